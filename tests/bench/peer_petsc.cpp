#include <petscdmplex.h>

#include <stdexcept>
#include <string>

#include "median.hpp"
#include "peers.hpp"

/// PETSc's DMPlex: a graph of all cells, facets, edges and vertices. Its cohesive cells, made for
/// faults, put a layer of prisms into a cut, whose two sides have vertices of their own; a new mesh
/// is made. Timed is what leads from labelled facets to it.
namespace cleave::bench {
namespace {

void require(PetscErrorCode error) {
  if (error != 0) throw std::runtime_error("PETSc fails with error " + std::to_string(error));
}

/// PETSc from the first use to the end of the program.
void start() {
  static const struct Session {
    Session() {
      require(PetscInitializeNoArguments());
      require(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
    }
    ~Session() { PetscFinalize(); }
  } session;
}

struct Mesh {
  Mesh() = default;
  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;
  ~Mesh() { DMDestroy(&dm); }
  DM dm = nullptr;

  PetscInt vertex_count() const {
    PetscInt begin = 0, end = 0;
    require(DMPlexGetDepthStratum(dm, 0, &begin, &end));
    return end - begin;
  }
};

/// Labels the facets of the cut and their faces with 1. PETSc numbers cells first, then vertices.
DMLabel label_facets(DM dm, const CutMesh<3>& mesh) {
  require(DMCreateLabel(dm, "cut"));
  DMLabel label = nullptr;
  require(DMGetLabel(dm, "cut", &label));
  const auto vertices = static_cast<PetscInt>(mesh.soup.cells.size());
  for (const auto& facet : mesh.cut) {
    PetscInt points[3];
    for (std::size_t i = 0; i < 3; ++i)
      points[i] = vertices + static_cast<PetscInt>(facet[i].value);
    PetscInt count = 0;
    const PetscInt* join = nullptr;
    require(DMPlexGetFullJoin(dm, 3, points, &count, &join));
    if (count != 1) throw std::logic_error("PETSc does not find a facet");
    require(DMLabelSetValue(label, join[0], 1));
    require(DMPlexRestoreJoin(dm, 3, points, &count, &join));
  }
  require(DMPlexLabelComplete(dm, label));  // edges and vertices too
  return label;
}

Split insert_cohesive_cells(const CutMesh<3>& mesh) {
  start();
  std::vector<PetscInt> cells;
  for (std::size_t c = 0; c < mesh.soup.cells.size(); ++c) {
    auto v = mesh.soup.cells[c];
    if (mesh.soup.signs[c] > 0) std::swap(v[2], v[3]);
    for (const auto vertex : v) cells.push_back(static_cast<PetscInt>(vertex.value));
  }
  Mesh whole, sheet, split_mesh;
  require(DMPlexCreateFromCellListPetsc(
      PETSC_COMM_SELF, 3, static_cast<PetscInt>(mesh.soup.cells.size()),
      static_cast<PetscInt>(mesh.soup.vertex_count), 4, PETSC_TRUE, cells.data(), 3,
      mesh.coordinates.data(), &whole.dm));
  DMLabel label = label_facets(whole.dm, mesh);
  Split split;
  DMLabel sides = nullptr;
  split.seconds = seconds([&] {
    require(DMPlexCreateSubmesh(whole.dm, label, 1, PETSC_TRUE, &sheet.dm));
    require(DMPlexOrient(sheet.dm));
    DMLabel points_of_sheet = nullptr;
    require(DMPlexGetSubpointMap(sheet.dm, &points_of_sheet));
    require(DMLabelDuplicate(points_of_sheet, &sides));
    require(DMLabelClearStratum(sides, 3));
    require(DMPlexLabelCohesiveComplete(whole.dm, sides, nullptr, 1, PETSC_FALSE, sheet.dm));
    require(DMPlexConstructCohesiveCells(whole.dm, sides, nullptr, &split_mesh.dm));
  });
  require(DMLabelDestroy(&sides));
  split.new_vertices = static_cast<std::size_t>(split_mesh.vertex_count() - whole.vertex_count());
  return split;
}

const Registration kCohesive(Splitter<3>{"PETSc_cohesive", insert_cohesive_cells, 1'000'000,
                                         100'000});

}  // namespace
}  // namespace cleave::bench
