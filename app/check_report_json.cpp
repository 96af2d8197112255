#include <nlohmann/json.hpp>

#include "check_report.hpp"
#include "finding_json.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Finding& finding) {
  return {{"rule", finding.rule},
          {"severity", name(finding.severity)},
          {"message", finding.message},
          {"witness", json_of_witness(finding)}};
}

Json json_of(const CheckReport& report) {
  if (!report.unreadable.empty())
    return {{"schema", "cleave-check/1"},
            {"mesh", {{"file", report.source}}},
            {"unreadable", report.unreadable}};
  Json violations = Json::array();
  for (const Finding& finding : report.findings) violations.push_back(json_of(finding));
  return {{"schema", "cleave-check/1"},
          {"mesh",
           {{"file", report.source},
            {"dimension", report.dimension},
            {"cells", report.cells},
            {"vertices", report.vertices}}},
          {"level", topology::name(report.level)},
          {"violations", violations},
          {"undecided", report.undecided},
          {"topology",
           {{"pieces", report.topology.pieces},
            {"boundary_components", report.topology.boundary_components},
            {"euler_characteristic", report.topology.euler_characteristic},
            {"betti", report.betti ? Json(*report.betti) : Json()}}}};
}

}  // namespace

nlohmann::ordered_json json_of_witness(const Finding& finding) {
  Json witness = Json::object();
  for (const auto& [key, value] : finding.witness)
    std::visit([&, &k = key](const auto& v) { witness[k] = v; }, value);
  return witness;
}

std::string json_of(const std::vector<CheckReport>& reports) {
  Json all = Json::array();
  for (const CheckReport& report : reports) all.push_back(json_of(report));
  return text_of_json(reports.size() == 1 ? all[0] : all);
}

std::string text_of_json(const nlohmann::ordered_json& document) {
  constexpr auto kReplace = Json::error_handler_t::replace;  // file names need not be UTF-8
  return document.dump(1, ' ', false, kReplace) + "\n";
}

}  // namespace cleave::app
