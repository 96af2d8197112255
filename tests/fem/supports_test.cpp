#include <gtest/gtest.h>

#include <limits>

#include "bodies.hpp"
#include "cleave/fem/dirichlet.hpp"

namespace cleave::fem {
namespace {

TEST(Dirichlet, NamesVertexAndAxisOfAContradiction) {
  Dirichlet supports;
  supports.prescribe(VertexId{4}, 1, 0.5);
  supports.prescribe(VertexId{4}, 1, 0.5);  // said twice, no contradiction
  EXPECT_EQ(supports.size(), 1u);
  try {
    supports.prescribe(VertexId{4}, 1, -0.5);
    FAIL() << "a contradiction was taken";
  } catch (const ContradictorySupport& error) {
    EXPECT_EQ(error.vertex.value, 4u);
    EXPECT_EQ(error.axis, 1);
    EXPECT_EQ(error.earlier, 0.5);
    EXPECT_EQ(error.later, -0.5);
    EXPECT_NE(std::string(error.what()).find("vertex 4"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("along y"), std::string::npos);
  }
}

TEST(Dirichlet, RefusesWhatIsNoCoordinateOrNoNumber) {
  Dirichlet supports;
  EXPECT_THROW(supports.prescribe(VertexId{0}, 3, 0.0), std::invalid_argument);
  EXPECT_THROW(supports.prescribe(VertexId{0}, -1, 0.0), std::invalid_argument);
  EXPECT_THROW(supports.prescribe(VertexId{0}, 0, std::numeric_limits<double>::infinity()),
               std::invalid_argument);
  EXPECT_TRUE(supports.empty());
}

TEST(Dirichlet, ImposesAndProjects) {
  Dirichlet supports;
  supports.prescribe(VertexId{1}, 2, 7.0);
  Eigen::VectorXd u = Eigen::VectorXd::Ones(6);
  supports.impose(u);
  EXPECT_EQ(u[5], 7.0);
  supports.project(u);
  EXPECT_EQ(u[5], 0.0);
  EXPECT_EQ(u.head(5), Eigen::VectorXd::Ones(5));
  Eigen::VectorXd too_short = Eigen::VectorXd::Ones(3);
  EXPECT_THROW(supports.impose(too_short), std::invalid_argument);
  EXPECT_THROW(supports.project(too_short), std::invalid_argument);
}

TEST(Dirichlet, HoldsForAllCopiesAfterACut) {
  Body body = cube(4);
  Dirichlet supports;
  for (const VertexId v : vertices_where(body, [](const Point& p) { return p[2] == 0.0; }))
    supports.prescribe(v, 0, body.points[v.value][1]);
  const auto change =
      cut(body, facets_between(body, [](const Point& p) { return p[0] < 1.0 / 3.0; }));
  supports.carry_over(change);
  std::size_t copies = 0;
  for (const VertexId v : vertices_where(body, [](const Point& p) { return p[2] == 0.0; })) {
    EXPECT_TRUE(supports.prescribes(v, 0));
    EXPECT_FALSE(supports.prescribes(v, 1));
    EXPECT_EQ(supports.values().at(3 * v.value), body.points[v.value][1]);
    copies += v.value >= change.vertices_before;
  }
  EXPECT_EQ(copies, 4u);
}

TEST(Dirichlet, MergedCopiesMustAgree) {
  topology::Relabelling merge;
  merge.vertices_before = 9;
  merge.vertices_after = 8;
  merge.merges = {{VertexId{8}, VertexId{2}}};
  Dirichlet supports;
  supports.prescribe(VertexId{8}, 0, 1.0);
  supports.prescribe(VertexId{2}, 1, 3.0);
  Dirichlet agreeing = supports;
  agreeing.carry_over(merge);
  EXPECT_TRUE(agreeing.prescribes(VertexId{2}, 0));
  EXPECT_TRUE(agreeing.prescribes(VertexId{2}, 1));
  EXPECT_EQ(agreeing.size(), 2u);

  supports.prescribe(VertexId{2}, 0, 2.0);
  EXPECT_THROW(supports.carry_over(merge), ContradictorySupport);
  EXPECT_EQ(supports.size(), 3u);
  EXPECT_TRUE(supports.prescribes(VertexId{8}, 0));
}

}  // namespace
}  // namespace cleave::fem
