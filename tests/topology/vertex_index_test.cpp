// The corners that VertexIndex lists are those of the cells.
#include "cleave/topology/vertex_index.hpp"

#include "cleave/topology/unglue.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <class Dimension>
class Corners : public ::testing::Test {};
TYPED_TEST_SUITE(Corners, Dimensions);

/// The corners at `vertex`, ascending, by looking at all there are.
template <int D>
std::vector<CornerId> corners_by_definition(const Complex<D>& k, VertexId vertex) {
  std::vector<CornerId> corners;
  for (Index c = 0; c < k.half_facet_count(); ++c)
    if (k.vertex(CornerId{c}) == vertex) corners.push_back(CornerId{c});
  return corners;
}

template <int D>
void expect_index_of(const Complex<D>& k) {
  const VertexIndex<D> index(k);
  ASSERT_EQ(index.vertex_count(), k.vertex_count());
  for (Index v = 0; v < k.vertex_count(); ++v) {
    const auto found = index[VertexId{v}];
    EXPECT_EQ(std::vector<CornerId>(found.begin(), found.end()),
              corners_by_definition(k, VertexId{v}));
  }
}

TYPED_TEST(Corners, AreListedByVertexBeforeAndAfterACut) {
  constexpr int D = TypeParam::value;
  for (Complex<D> k : sample_complexes<D>()) {
    expect_index_of(k);
    unglue(k, dense_cut(k));
    expect_index_of(k);
  }
}

TYPED_TEST(Corners, OfAVertexThatNoCellUsesAreNone) {
  constexpr int D = TypeParam::value;
  auto mesh = support::simplex<D>();
  ++mesh.vertex_count;
  const VertexIndex<D> index(complex_of(mesh));
  EXPECT_TRUE(index[VertexId{D + 1}].empty());
  EXPECT_EQ(VertexIndex<D>().vertex_count(), 0u);
}

}  // namespace
}  // namespace cleave::views
