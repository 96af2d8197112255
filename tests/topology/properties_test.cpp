// Arrays of values per vertex that follow cuts and stitches.
#include "cleave/topology/properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "cleave/support/rng.hpp"
#include "cleave/topology/incision.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

TEST(VertexProperties, FollowACutAndItsStitch) {
  Incision<3> incision(complex_of<3>(kuhn_cube<3>(3)));
  const std::size_t vertices = incision.complex().vertex_count();
  VertexProperties properties(vertices);
  auto& weight = properties.add_constant("weight", 1.0, merging::Sum{});
  auto& name = properties.add("name", std::vector<std::string>(vertices, "somewhere in the cube"));
  auto& heat = properties.add_constant("heat", 20.0, merging::MeanBy{weight});
  name[VertexId{13}] = "the vertex in the middle of the cube";

  const FacetSet all = FacetSet::all(incision.complex());
  const Relabelling change = incision.cut(all);
  properties.follow(change);
  EXPECT_EQ(properties.vertex_count(), incision.complex().vertex_count());
  EXPECT_EQ(name.size(), incision.complex().vertex_count());
  std::vector<VertexId> middle{{13}};
  carry_over_set(middle, change);
  EXPECT_EQ(middle.size(), 24u);
  for (const VertexId v : middle) EXPECT_EQ(name[v], name[VertexId{13}]);

  heat[middle[0]] = 20.0 + 24.0;
  properties.follow(incision.stitch(all));
  EXPECT_EQ(name.size(), vertices);
  EXPECT_DOUBLE_EQ(heat[VertexId{13}], 21.0);
  EXPECT_DOUBLE_EQ(weight[VertexId{13}], 24.0);
}

TEST(VertexProperties, AreFoundByNameAndType) {
  VertexProperties properties(2);
  auto& height = properties.add("height", std::vector{1.0, 2.0});
  properties.add_constant("fixed", false);
  for (int n = 0; n < 100; ++n) properties.add_constant("n" + std::to_string(n), n);
  EXPECT_EQ(&properties.get<double>("height"), &height);  // where it was
  EXPECT_EQ(properties.find<float>("height"), nullptr);
  EXPECT_EQ(properties.find<double>("depth"), nullptr);
  EXPECT_TRUE(properties.has("fixed"));
  EXPECT_EQ(properties.names().size(), 102u);
  EXPECT_EQ(properties.names()[1], "fixed");
  EXPECT_TRUE(properties.remove("fixed"));
  EXPECT_FALSE(properties.remove("fixed"));
  EXPECT_FALSE(properties.has("fixed"));
  for (double& h : height.span()) h *= 10;
  EXPECT_EQ(height.values(), (std::vector{10.0, 20.0}));
  const VertexProperties& seen = properties;
  EXPECT_EQ(seen.get<double>("height")[VertexId{1}], 20.0);
  EXPECT_EQ(seen.find<int>("n7")->name(), "n7");
}

template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(VertexProperties, RefuseWhatDoesNotFit) {
  VertexProperties properties(2);
  properties.add("height", std::vector{1.0, 2.0});
  EXPECT_EQ(refusal([&] {
              properties.add("height", std::vector{1, 2});
            }),
            "there is a property \"height\" already");
  EXPECT_EQ(refusal([&] {
              properties.add("depth", std::vector{1, 2, 3});
            }),
            "property \"depth\" has 3 values for 2 vertices");
  EXPECT_EQ(refusal([&] { properties.get<int>("height"); }),
            "values of another type has property \"height\"");
  EXPECT_EQ(refusal([&] { properties.get<int>("depth"); }), "there is no property \"depth\"");
  EXPECT_EQ(refusal([&] { properties.follow(some_merges()); }),
            "2 values are given for 6 vertices");
  EXPECT_EQ(properties.names(), std::vector<std::string>{"height"});
}

TEST(VertexProperties, AllFollowOrNone) {
  VertexProperties properties(6);
  auto& force = properties.add("force", std::vector<double>{1, 2, 4, 8, 16, 32}, merging::Sum{});
  auto& fixed = properties.add("fixed", std::vector<bool>{true, true, false, true, false, true});
  const auto force_before = force.values();
  const auto fixed_before = fixed.values();
  EXPECT_THROW(properties.require_mergeable(some_merges().merges), UnequalValues);
  EXPECT_THROW(properties.follow(some_merges()), UnequalValues);
  EXPECT_EQ(force.values(), force_before);
  EXPECT_EQ(fixed.values(), fixed_before);
  EXPECT_EQ(properties.vertex_count(), 6u);

  fixed[VertexId{4}] = true;
  EXPECT_NO_THROW(properties.require_mergeable(some_merges().merges));
  EXPECT_EQ(force.values(), force_before);
  properties.follow(some_merges());
  EXPECT_EQ(force.values(), (std::vector<double>{33, 26, 4}));
  EXPECT_EQ(fixed.values(), (std::vector<bool>{true, true, false}));
}

/// The greatest of the values of merged vertices.
struct Greatest {
  template <class T>
  T operator()(const std::vector<T>& values, std::span<const VertexId> vertices) const {
    T greatest = values[vertices[0].value];
    for (const VertexId v : vertices) greatest = std::max<T>(greatest, values[v.value]);
    return greatest;
  }
};

/// Whether each vertex has the greatest of the values that its corners had before.
template <int D, class T>
bool is_greatest(const std::vector<Cell<D>>& before, const std::vector<T>& values_before,
                 const Complex<D>& k, const std::vector<T>& values) {
  std::vector<T> expected(k.vertex_count());
  std::vector<bool> used(k.vertex_count(), false);
  for (std::size_t c = 0; c < before.size(); ++c)
    for (std::size_t i = 0; i <= D; ++i) {
      const std::size_t v = k.cells()[c][i].value;
      const T value = values_before[before[c][i].value];
      expected[v] = used[v] ? std::max<T>(expected[v], value) : value;
      used[v] = true;
    }
  if (values.size() != k.vertex_count()) return false;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] && values[v] != expected[v]) return false;
  return true;
}

template <int D>
void follow_a_history(support::Rng rng) {
  Incision<D> incision(complex_of<D>(kuhn_cube<D>(D == 1 ? 9 : D <= 3 ? 4 : 3)));
  const FacetSet interior = FacetSet::all(incision.complex());
  VertexProperties properties(incision.complex().vertex_count());
  std::vector<VertexId> themselves;
  for (Index v = 0; v < properties.vertex_count(); ++v) themselves.push_back({v});
  const auto& original = properties.add("original", themselves);
  auto& number = properties.add_constant("number", 0, Greatest{});
  auto& name = properties.add_constant("name", std::string(), Greatest{});
  auto& flag = properties.add_constant("flag", false, Greatest{});

  Relabelling change;
  for (int step = 0; step < 12; ++step) {
    for (Index v = 0; v < properties.vertex_count(); ++v) {
      number[VertexId{v}] = static_cast<int>(rng.below(100));
      name[VertexId{v}] = std::string(rng.below(40), static_cast<char>('a' + rng.below(26)));
      flag[VertexId{v}] = rng.chance(0.5);
    }
    const std::vector<Cell<D>> cells{incision.complex().cells().begin(),
                                     incision.complex().cells().end()};
    const auto numbers = number.values();
    const auto names = name.values();
    const auto flags = flag.values();
    std::vector<HalfFacetId> facets;
    const double chance = rng.unit();
    for (const HalfFacetId h : interior.half_facets())
      if (rng.chance(chance)) facets.push_back(h);
    const std::size_t action = rng.below(4);
    if (action == 0 && incision.can_undo())
      incision.undo(change);
    else if (action == 1 && incision.can_redo())
      incision.redo(change);
    else if (action <= 2)
      incision.cut(FacetSet::of_lesser(facets), change);
    else
      incision.stitch(FacetSet::of_lesser(facets), change);
    properties.follow(change);
    const Complex<D>& k = incision.complex();
    RC_ASSERT(properties.vertex_count() == k.vertex_count());
    for (Index v = 0; v < k.vertex_count(); ++v)
      if (k.a_corner(VertexId{v}))
        RC_ASSERT(original[VertexId{v}] == incision.original(VertexId{v}));
    RC_ASSERT((is_greatest<D, int>(cells, numbers, k, number.values())));
    RC_ASSERT((is_greatest<D, std::string>(cells, names, k, name.values())));
    RC_ASSERT((is_greatest<D, bool>(cells, flags, k, flag.values())));
  }
}

template <class Dimension>
class VertexPropertiesProperty : public ::testing::Test {};
TYPED_TEST_SUITE(VertexPropertiesProperty, Dimensions);

TYPED_TEST(VertexPropertiesProperty, FollowAnyHistory) {
  EXPECT_TRUE(rc::check([] {
    follow_a_history<TypeParam::value>(support::Rng(*rc::gen::arbitrary<std::uint64_t>()));
  }));
}

}  // namespace
}  // namespace cleave::views
