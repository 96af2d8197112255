#include <nlohmann/json.hpp>

#include "cut_report.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<CutReport::Copy>& copies) {
  Json list = Json::array();
  for (const auto& copy : copies)
    list.push_back({{"vertex", copy.vertex}, {"parent", copy.parent}});
  return list;
}

Json json_of(const CutReport::Fix& fix) {
  Json json{{"facets", fix.facets}, {"exact", fix.exact}};
  if (!fix.kept.empty()) json["kept"] = fix.kept;
  return json;
}

Json json_of(const CutReport::Shut& shut) {
  Json because = Json::array();
  for (const auto& reason : shut.because)
    because.push_back({{"vertex", reason.vertex}, {"through", reason.through}});
  Json json{{"facet", shut.facet}, {"because", because}};
  if (shut.fix) json["fix"] = json_of(*shut.fix);
  return json;
}

}  // namespace

std::string fix_it_file(const CutReport& report) {
  return Json{{"facets", report.fix->facets}}.dump() + "\n";
}

std::string json_of(const CutReport& report) {
  Json json{{"schema", "cleave-cut/1"},
            {"mesh",
             {{"cells", report.cells},
              {"vertices_before", report.vertices_before},
              {"vertices_after", report.vertices_after}}},
            {"facets",
             {{"requested", report.requested},
              {"opened", report.opened},
              {"shut", report.shut},
              {"not_interior", report.not_interior},
              {"kept", report.kept},
              {"added", report.added.size()}}},
            {"pieces", {{"before", report.pieces_before}, {"after", report.pieces_after}}},
            {"cut_regular", report.cut_regular},
            {"pinched_edges", report.pinched_edges},
            {"regularized", json_of(report.regularized)},
            {"splits", json_of(report.splits)},
            {"shut_facets", Json::array()},
            {"one_sided", Json::array()}};
  if (!report.added.empty()) json["added_facets"] = report.added;
  if (report.fix) json["fix"] = json_of(*report.fix);
  if (report.earlier)
    json["earlier"] = {{"opened", report.earlier->opened}, {"shut", report.earlier->shut}};
  for (const auto& shut : report.shut_facets) json["shut_facets"].push_back(json_of(shut));
  for (const auto& sheet : report.one_sided)
    json["one_sided"].push_back({{"name", sheet.name}, {"loop", sheet.loop}});
  if (report.opened_facets) {
    json["opened_facets"] = Json::array();
    for (const auto& opened : *report.opened_facets)
      json["opened_facets"].push_back({{"facet", opened.facet}, {"by", opened.by}});
  }
  if (report.edge_nodes_before > 0) {
    json["mesh"]["edge_nodes_before"] = report.edge_nodes_before;
    json["mesh"]["edge_nodes_after"] = report.edge_nodes_after;
  }
  if (report.cohesive > 0) json["mesh"]["cohesive_elements"] = report.cohesive;
  constexpr auto kReplace = Json::error_handler_t::replace;  // names need not be UTF-8
  return json.dump(1, ' ', false, kReplace) + "\n";
}

}  // namespace cleave::app
