#include "sample.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "cleave/support/reference.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/incision.hpp"

namespace cleave::proofs {
namespace {

using support::Mesh;
using topology::Cell;
using topology::Complex;
using topology::CornerId;
using topology::FacetSet;
using topology::HalfFacetId;
using topology::VertexId;

template <int D>
std::vector<std::uint32_t> flat(std::span<const Cell<D>> cells) {
  std::vector<std::uint32_t> numbers;
  for (const Cell<D>& cell : cells)
    for (const VertexId v : cell) numbers.push_back(v.value);
  return numbers;
}

template <int D>
std::vector<std::uint32_t> unglued(Complex<D> k, const FacetSet& cut) {
  topology::unglue(k, cut);
  return flat<D>(k.cells());
}

/// Cut in two stages, with a facet too many that is taken back.
template <int D>
std::vector<std::uint32_t> incised(const Complex<D>& k, const FacetSet& cut, Rng& rng) {
  topology::Incision<D> incision(k);
  std::vector<HalfFacetId> some;
  for (const HalfFacetId h : cut.half_facets())
    if (rng.chance(0.5)) some.push_back(h);
  const FacetSet all = FacetSet::all(k);
  FacetSet first = FacetSet::of_lesser(some), more;
  if (!all.empty()) more = FacetSet::of_lesser({all.half_facets()[rng.below(all.size())]}) - cut;
  incision.cut(first | more);
  incision.cut(cut);
  incision.stitch(more);
  return flat<D>(incision.complex().cells());
}

/// `cut` with one facet more, or one less.
template <int D>
FacetSet other_cut(const Complex<D>& k, const FacetSet& cut, Rng& rng) {
  const FacetSet& from = !cut.empty() && rng.chance(0.7) ? cut : FacetSet::all(k);
  if (from.empty()) return cut;
  return cut ^ FacetSet::of_lesser({from.half_facets()[rng.below(from.size())]});
}

template <int D>
void append_facet(std::span<const Cell<D>> cells, HalfFacetId h, Rng& rng,
                  std::vector<std::uint32_t>& to) {
  auto facet = support::sorted_facet<D>(cells, h);
  rng.shuffle(facet);
  for (const VertexId v : facet) to.push_back(v.value);
}

/// Gives the vertices other numbers, large ones among them.
void rename(std::vector<std::uint32_t>& before, std::vector<std::uint32_t>& cut, Rng& rng) {
  std::unordered_map<std::uint32_t, std::uint32_t> name;
  std::unordered_set<std::uint32_t> taken;
  for (auto* numbers : {&before, &cut})
    for (std::uint32_t& v : *numbers) {
      const auto [at, is_new] = name.try_emplace(v, 0);
      while (is_new && !taken.insert(at->second).second)
        at->second = rng.chance(0.02) ? UINT32_MAX : static_cast<std::uint32_t>(rng.next());
      v = at->second;
    }
}

template <int D>
std::vector<HalfFacetId> cut_of(const Mesh<D>& mesh, std::uint64_t number, Rng& rng) {
  if (number % 13 == 12) return {};
  for (std::uint64_t n = number;; ++n) {
    const auto cut_class = support::kCutClasses[n % support::kCutClasses.size()];
    if (auto cut = support::random_cut<D>(mesh, cut_class, rng)) return *cut;
    if (n - number > support::kCutClasses.size()) return {};  // no interior facet
  }
}

template <int D>
Sample sample_of(std::uint64_t number, Rng& rng) {
  Sample sample;
  sample.mesh_class = support::kMeshClasses[number % support::kMeshClasses.size()];
  const Mesh<D> mesh = support::random_mesh<D>(sample.mesh_class, rng);
  auto facets = cut_of<D>(mesh, number / support::kMeshClasses.size(), rng);
  const auto made = topology::assemble_regularized<D>(
      {mesh.cells, mesh.vertex_count, support::coherent_signs<D>(mesh.cells).value()});
  const Complex<D>& k = made.complex;
  const FacetSet cut = FacetSet::of(k, std::span<const HalfFacetId>(facets));

  app::Certificate& certificate = sample.certificate;
  certificate.dimension = D;
  certificate.before = flat<D>(mesh.cells);
  certificate.after = rng.chance(0.5) ? unglued(k, cut) : incised(k, cut, rng);
  sample.other_after = unglued(k, other_cut(k, cut, rng));
  sample.cut_regular = made.splits.empty();
  for (const auto& violation : topology::check<D>(
           topology::CellView<D>::of(mesh.cells, mesh.vertex_count), topology::Level::edge_regular))
    sample.pinched = sample.pinched || std::holds_alternative<topology::PinchedSimplex>(violation);
  sample.asked = cut.size();
  Complex<D> after = k;
  sample.opened = topology::unglue(after, cut).opened.size();

  for (std::uint32_t h = 0; h < k.half_facet_count(); ++h)  // means nothing
    if (!k.is_interior({h}) && rng.chance(0.02)) facets.push_back({h});
  rng.shuffle(facets);
  for (const HalfFacetId h : facets) append_facet<D>(mesh.cells, h, rng, certificate.cut);
  if (rng.chance(0.3)) rename(certificate.before, certificate.cut, rng);
  return sample;
}

template <int D>
app::Certificate faulty_of(Fault fault, Rng& rng) {
  const auto defect = fault == Fault::repeated_vertex ? support::Defect::degenerate_cell
                      : fault == Fault::same_vertices ? support::Defect::duplicate_cell
                      : fault == Fault::three_cells   ? support::Defect::facet_in_three_cells
                                                      : support::Defect::none;
  auto planted = support::plant<D>(defect, rng);
  rng.shuffle(planted.mesh.cells);
  const std::vector<std::uint32_t> cells = flat<D>(planted.mesh.cells);
  app::Certificate certificate{D, cells, cells, {}};
  if (fault != Fault::no_facet) return certificate;
  for (std::uint32_t h = 0; h < cells.size(); ++h)
    if (rng.chance(0.3)) append_facet<D>(planted.mesh.cells, {h}, rng, certificate.cut);
  std::vector<std::uint32_t> row(static_cast<std::size_t>(D), rng.pick(cells));
  if (D == 1 || rng.chance(0.5))  // else one vertex, D times
    row[0] = static_cast<std::uint32_t>(planted.mesh.vertex_count);
  const std::size_t rows = certificate.cut.size() / row.size();
  certificate.cut.insert(
      certificate.cut.begin() + static_cast<std::ptrdiff_t>(row.size() * rng.below(rows + 1)),
      row.begin(), row.end());
  return certificate;
}

}  // namespace

Sample sample(std::uint64_t number, Rng& rng) {
  const std::uint64_t round = number / 4;
  switch (number % 4) {
    case 0:
      return sample_of<1>(round, rng);
    case 1:
      return sample_of<2>(round, rng);
    case 2:
      return sample_of<3>(round, rng);
    default:
      return sample_of<4>(round, rng);
  }
}

app::Certificate faulty(Fault fault, int dimension, Rng& rng) {
  if (dimension == 1) return faulty_of<1>(fault, rng);
  if (dimension == 2) return faulty_of<2>(fault, rng);
  if (dimension == 3) return faulty_of<3>(fault, rng);
  return faulty_of<4>(fault, rng);
}

std::string text_of(const app::Certificate& certificate) {
  std::string text;
  app::write_certificate(certificate, [&](std::string_view some) { text += some; });
  return text;
}

std::vector<std::uint32_t> classes(const std::vector<std::uint32_t>& vertices) {
  std::unordered_map<std::uint32_t, std::uint32_t> least;
  std::vector<std::uint32_t> result;
  for (std::uint32_t corner = 0; corner < vertices.size(); ++corner)
    result.push_back(least.try_emplace(vertices[corner], corner).first->second);
  return result;
}

}  // namespace cleave::proofs
