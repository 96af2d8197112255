#include "cut_request.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <unordered_map>

#include "blade.hpp"
#include "error.hpp"
#include "files/input_text.hpp"
#include "json_value.hpp"

namespace cleave::app {
namespace {

nlohmann::json parse_file(const InputText& text) { return parse_json(text.bytes(), text.source()); }

template <std::size_t N>
std::vector<JsonValue> items(const JsonValue& value, const char* what) {
  auto items = value.items();
  if (items.size() != N)
    value.fail(std::to_string(N) + " " + what + " are needed, there are " +
               std::to_string(items.size()));
  return items;
}

template <std::size_t N>
std::array<double, N> read_point(const JsonValue& value) {
  std::array<double, N> point{};
  const auto parts = items<N>(value, "coordinates");
  for (std::size_t i = 0; i < N; ++i) {
    point[i] = parts[i].number();
    if (!std::isfinite(point[i])) parts[i].fail("the number is too large");
  }
  return point;
}

cutting::Sweep<3> read_triangles(const JsonValue& document) {
  cutting::Sweep<3> sweep;
  for (const JsonValue& triangle : document["triangles"].items()) {
    const auto corners = items<3>(triangle, "corners");
    sweep.simplices.push_back(
        {read_point<3>(corners[0]), read_point<3>(corners[1]), read_point<3>(corners[2])});
  }
  sweep.step_of.assign(sweep.simplices.size(), 0);
  if (!document.has("step_of_triangle")) return sweep;
  const JsonValue list = document["step_of_triangle"];
  const auto steps = list.items();
  if (steps.size() != sweep.simplices.size())
    list.fail("one step per triangle is needed: " + std::to_string(sweep.simplices.size()) +
              ", there are " + std::to_string(steps.size()));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::uint64_t step = steps[i].count();
    if (step > std::numeric_limits<std::uint32_t>::max() - 1)
      steps[i].fail("the number of this step is too large");
    sweep.step_of[i] = static_cast<std::uint32_t>(step);
    if (i > 0 && sweep.step_of[i] < sweep.step_of[i - 1])
      steps[i].fail("steps must ascend; list the triangles in the order of their steps");
  }
  return sweep;
}

cutting::Sweep<2> read_polyline(const JsonValue& polyline) {
  std::vector<cutting::Point<2>> points;
  for (const JsonValue& point : polyline.items()) points.push_back(read_point<2>(point));
  if (points.size() < 2) polyline.fail("a polyline needs at least two points");
  return cutting::sweep_of_polyline(points);
}

}  // namespace

std::vector<Index> read_facets(const std::filesystem::path& path, const Mesh& mesh) {
  const InputText text = input_at(path);
  const auto json = parse_file(text);
  const JsonValue document(json, text.source());
  document.only({"facets"});

  std::unordered_map<std::uint64_t, Index> place_of;
  place_of.reserve(mesh.points.size());
  for (Index i = 0; i < mesh.vertex_numbers.size(); ++i)
    place_of.emplace(mesh.vertex_numbers[i], i);

  std::vector<Index> places;
  for (const JsonValue& facet : document["facets"].items()) {
    const auto numbers = facet.items();
    if (numbers.size() != static_cast<std::size_t>(mesh.dimension))
      facet.fail("a facet of " + mesh.source + " has " + std::to_string(mesh.dimension) +
                 " vertices, this one has " + std::to_string(numbers.size()));
    for (const JsonValue& number : numbers) {
      const auto found = place_of.find(number.count());
      if (found == place_of.end())
        number.fail(mesh.source + " has no vertex " + std::to_string(number.count()));
      places.push_back(found->second);
    }
  }
  return places;
}

template <int D>
cutting::Sweep<D> read_sweep(const std::filesystem::path& path) {
  const InputText text = input_at(path);
  const auto json = parse_file(text);
  const JsonValue document(json, text.source());
  if constexpr (D == 2) {
    if (document.has("blade") || document.has("triangles"))
      document.fail("this mesh is two-dimensional, so what cuts it is a \"polyline\"");
    document.only({"polyline"});
    return read_polyline(document["polyline"]);
  } else {
    if (document.has("polyline"))
      document.fail(
          "this mesh is three-dimensional, so what cuts it is a \"blade\" or \"triangles\"");
    if (document.one_of({"blade", "triangles"}) == "blade") {
      document.only({"blade"});
      return cutting::sweep_of_blade(read_blade(document["blade"]));
    }
    document.only({"triangles", "step_of_triangle"});
    return read_triangles(document);
  }
}

template cutting::Sweep<2> read_sweep<2>(const std::filesystem::path&);
template cutting::Sweep<3> read_sweep<3>(const std::filesystem::path&);

}  // namespace cleave::app
