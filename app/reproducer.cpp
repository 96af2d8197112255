#include "reproducer.hpp"

#include <nlohmann/json.hpp>

#include "output_file.hpp"

namespace cleave::app {

template <int D>
void write_reproducer(const std::filesystem::path& path, const topology::Complex<D>& before,
                      const topology::FacetSet& cut, const std::string& message) {
  using Json = nlohmann::ordered_json;
  Json cells = Json::array(), signs = Json::array(), facets = Json::array();
  for (Index c = 0; c < before.cell_count(); ++c) {
    Json tuple = Json::array();
    for (const auto v : before.vertices({c})) tuple.push_back(v.value);
    cells.push_back(std::move(tuple));
    signs.push_back(before.sign({c}));
  }
  for (const auto h : cut.half_facets()) facets.push_back(h.value);
  const Json json{{"schema", "cleave-reproducer/1"},
                  {"message", message},
                  {"dimension", D},
                  {"vertex_count", before.vertex_count()},
                  {"cells", cells},
                  {"signs", signs},
                  {"cut", facets}};
  constexpr auto kReplace = Json::error_handler_t::replace;
  write_file(path, json.dump(-1, ' ', false, kReplace) + "\n");
}

template void write_reproducer<1>(const std::filesystem::path&, const topology::Complex<1>&,
                                  const topology::FacetSet&, const std::string&);
template void write_reproducer<2>(const std::filesystem::path&, const topology::Complex<2>&,
                                  const topology::FacetSet&, const std::string&);
template void write_reproducer<3>(const std::filesystem::path&, const topology::Complex<3>&,
                                  const topology::FacetSet&, const std::string&);

}  // namespace cleave::app
