#include "file_numbers.hpp"

#include <algorithm>
#include <limits>

#include "files/abaqus.hpp"
#include "files/numbers.hpp"

namespace cleave::app {
namespace {

using Numbers = std::vector<std::uint64_t>;

Numbers counted_from(std::uint64_t first, std::size_t count) {
  Numbers numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = first + i;
  return numbers;
}

/// The elements of dimensions from `least` on and the cohesive ones, numbered all together.
void number_together(FileNumbers& numbers, const Mesh& mesh, std::size_t least,
                     std::uint64_t greatest) {
  Numbers all;
  for (std::size_t d = least; d <= 3; ++d)
    all.insert(all.end(), mesh.elements[d].numbers.begin(), mesh.elements[d].numbers.end());
  all.insert(all.end(), mesh.cohesive.numbers.begin(), mesh.cohesive.numbers.end());
  all = kept_or_counted(all, greatest);
  auto next = all.begin();
  const auto take = [&](Numbers& into, std::size_t count) {
    into.assign(next, next + static_cast<std::ptrdiff_t>(count));
    next += static_cast<std::ptrdiff_t>(count);
  };
  for (std::size_t d = least; d <= 3; ++d) take(numbers.elements[d], mesh.elements[d].size());
  take(numbers.cohesive, mesh.cohesive.size());
}

/// Cells of a VTK file keep their numbers if these are all those from 0 on, ascending in each
/// dimension; else they are counted by falling dimension.
void number_vtk_cells(FileNumbers& numbers, const Mesh& mesh) {
  const std::array<const Numbers*, 5> kinds = {&mesh.elements[3].numbers, &mesh.elements[2].numbers,
                                               &mesh.elements[1].numbers, &mesh.elements[0].numbers,
                                               &mesh.cohesive.numbers};
  Numbers all;
  bool kept = true;
  for (const Numbers* kind : kinds) {
    kept = kept && std::is_sorted(kind->begin(), kind->end());
    all.insert(all.end(), kind->begin(), kind->end());
  }
  std::sort(all.begin(), all.end());
  kept = kept && all == counted_from(0, all.size());
  std::uint64_t first = 0;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    Numbers& into = k < 4 ? numbers.elements[3 - k] : numbers.cohesive;
    into = kept ? *kinds[k] : counted_from(first, kinds[k]->size());
    first += kinds[k]->size();
  }
}

void number_by_place(FileNumbers& numbers, const Mesh& mesh, std::uint64_t first) {
  numbers.vertices = counted_from(first, mesh.points.size());
  for (std::size_t d = 1; d <= 3; ++d)
    numbers.elements[d] = counted_from(first, mesh.elements[d].size());
}

}  // namespace

FileNumbers numbers_in(const Mesh& mesh, MeshFormat format, const WriteOptions& options) {
  FileNumbers numbers;
  switch (format) {
    case MeshFormat::kMedit:
      number_by_place(numbers, mesh, 1);
      break;
    case MeshFormat::kTetgen:
      number_by_place(numbers, mesh,
                      !mesh.vertex_numbers.empty() && mesh.vertex_numbers[0] == 0 ? 0 : 1);
      break;
    case MeshFormat::kGmsh: {
      const bool narrow = options.binary.value_or(mesh.msh_binary) &&
                          options.msh_version.value_or(mesh.msh_version) == MshVersion::k22;
      const std::uint64_t greatest =
          narrow ? std::uint64_t{std::numeric_limits<std::int32_t>::max()} : UINT64_MAX;
      numbers.vertices = kept_or_counted(mesh.vertex_numbers, greatest);
      number_together(numbers, mesh, 0, greatest);
      break;
    }
    case MeshFormat::kAbaqus:
      numbers.vertices = kept_or_counted(mesh.vertex_numbers, kAbaqusGreatest);
      number_together(numbers, mesh, 1, kAbaqusGreatest);
      break;
    case MeshFormat::kVtu:
    case MeshFormat::kVtk:
      numbers.vertices = counted_from(0, mesh.points.size());
      number_vtk_cells(numbers, mesh);
      break;
  }
  if (numbers.elements[0].empty())  // marks on vertices
    for (const Index v : mesh.elements[0].vertices)
      numbers.elements[0].push_back(numbers.vertices[v]);
  return numbers;
}

std::size_t numbers_changed(const std::vector<std::uint64_t>& before,
                            const std::vector<std::uint64_t>& after) {
  if (before.size() != after.size() || before.empty()) return 0;
  const bool places = before[0] <= 1 && after[0] <= 1 &&
                      before == counted_from(before[0], before.size()) &&
                      after == counted_from(after[0], after.size());
  if (places) return 0;
  std::size_t changed = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i] != after[i]) ++changed;
  return changed;
}

}  // namespace cleave::app
