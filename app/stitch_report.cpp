#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "file_words.hpp"
#include "stitch_mesh.hpp"

namespace cleave::app {

std::string text_of(const StitchReport& report, const std::string& source) {
  return fmt::format(
      "{}: {} taken back, {} of them closed{}; {} opened and {} shut still; pieces {} -> {}; "
      "vertices {} -> {}; cells {}\n",
      source, counted(report.requested, "facet"), report.closed,
      report.shut_again.empty() ? "" : fmt::format(", and {} with them", report.shut_again.size()),
      report.opened, report.shut, report.pieces_before, report.pieces_after, report.vertices_before,
      report.vertices_after, report.cells);
}

std::string json_of(const StitchReport& report) {
  using Json = nlohmann::ordered_json;
  Json merges = Json::array();
  for (const auto& merge : report.merges)
    merges.push_back({{"vertex", merge.vertex}, {"into", merge.into}});
  const Json json{{"schema", "cleave-stitch/1"},
                  {"mesh",
                   {{"cells", report.cells},
                    {"vertices_before", report.vertices_before},
                    {"vertices_after", report.vertices_after}}},
                  {"facets",
                   {{"requested", report.requested},
                    {"closed", report.closed},
                    {"not_scored", report.not_scored},
                    {"opened", report.opened},
                    {"shut", report.shut}}},
                  {"pieces", {{"before", report.pieces_before}, {"after", report.pieces_after}}},
                  {"shut_again", report.shut_again},
                  {"merges", merges}};
  return json.dump(1) + "\n";
}

}  // namespace cleave::app
