#pragma once
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

#include "cleave/support/reference.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/unglue.hpp"
#include "coverage.hpp"

namespace cleave::topology {

using support::Mesh;
using support::Rng;

/// A random mesh with a random cut, and what the references say about them.
template <int D>
struct Trial {
  support::MeshClass mesh_class{};
  support::CutClass cut_class{};
  std::uint64_t seed = 0;  // for whatever else a property draws
  Mesh<D> mesh;            // perhaps not cut-regular
  std::vector<std::int8_t> signs;
  std::vector<HalfFacetId> cut;      // in any order, with repetitions
  std::vector<Cell<D>> regularized;  // Algorithm 3 with the empty cut
  std::vector<Cell<D>> expected;     // Algorithm 3 with the cut

  /// The complex that `assemble_regularized` makes of the mesh.
  Complex<D> complex() const;
  Rng rng() const { return Rng(seed); }
};

template <int D>
std::ostream& operator<<(std::ostream& out, const Trial<D>& trial);

/// A complex before and after its cut. unglue verifies the whole complex, too.
template <int D>
struct Cut {
  Complex<D> before, after;
  FacetSet facets;
  Relabelling change;
  explicit Cut(const Trial<D>& trial)
      : before(trial.complex()), after(before), facets(FacetSet::of(before, trial.cut)) {
    change = unglue(after, facets, Verify::all);
  }
};

/// Checks `property` on random trials and counts them under the name of the test suite. Every class
/// of meshes meets every class of cuts: the classes go round with RapidCheck's size, so that chance
/// cannot starve one.
template <int D>
void for_all(const std::function<void(const Trial<D>&)>& property);

/// Dimensions as types, for properties that hold in each.
template <int D>
using Dimension = std::integral_constant<int, D>;
using Dimensions = ::testing::Types<Dimension<1>, Dimension<2>, Dimension<3>, Dimension<4>>;

struct DimensionName {
  template <class T>
  static std::string GetName(int) {
    return "D" + std::to_string(T::value);
  }
};

}  // namespace cleave::topology

/// Declares the test suite of a theorem or of a part of the API, for D = 1..4.
#define CLEAVE_PROPERTIES(Id)           \
  template <class>                      \
  class Id : public ::testing::Test {}; \
  TYPED_TEST_SUITE(Id, Dimensions, DimensionName)
