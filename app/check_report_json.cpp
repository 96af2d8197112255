#include <nlohmann/json.hpp>

#include "check_report.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Finding& finding) {
  Json witness = Json::object();
  for (const auto& [key, value] : finding.witness)
    std::visit([&, &k = key](const auto& v) { witness[k] = v; }, value);
  return {{"rule", finding.rule},
          {"severity", finding.severity == Severity::error ? "error" : "warning"},
          {"message", finding.message},
          {"witness", witness}};
}

Json json_of(const CheckReport& report) {
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
          {"topology",
           {{"pieces", report.topology.pieces},
            {"boundary_components", report.topology.boundary_components},
            {"euler_characteristic", report.topology.euler_characteristic}}}};
}

}  // namespace

std::string json_of(const std::vector<CheckReport>& reports) {
  Json all = Json::array();
  for (const CheckReport& report : reports) all.push_back(json_of(report));
  constexpr auto kReplace = Json::error_handler_t::replace;  // file names need not be UTF-8
  return (reports.size() == 1 ? all[0] : all).dump(1, ' ', false, kReplace) + "\n";
}

}  // namespace cleave::app
