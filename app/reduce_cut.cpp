#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "body.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/explain.hpp"
#include "cleave/topology/unglue.hpp"
#include "cut_request.hpp"
#include "error.hpp"
#include "file_words.hpp"
#include "reduce_findings.hpp"
#include "reduce_property.hpp"

namespace cleave::app {
namespace {

using topology::FacetSet;
using topology::HalfFacetId;
using topology::VertexId;

// The two sides of each facet of a request.
struct Sides {
  std::vector<HalfFacetId> one, other;
};

template <int D>
FacetSet requested(const Body<D>& body, const CutRequest& request) {
  const Mesh& mesh = *body.mesh;
  if (request.all) return FacetSet::all(body.complex);
  std::vector<HalfFacetId> facets;
  if (!request.facets.empty())
    facets = locate(body, read_facets(request.facets, mesh), request.facets);
  for (const std::string& name : request.groups) {
    const auto some =
        locate(body, vertices_of(mesh, facet_group(mesh, name)), fmt::format("group \"{}\"", name));
    facets.insert(facets.end(), some.begin(), some.end());
  }
  return sort_out(body.complex, std::span<const HalfFacetId>(facets)).interior;
}

// A body after a cut along `facets` of it.
template <int D>
struct AfterCut {
  topology::Complex<D> complex;
  topology::Relabelling change;
  AfterCut(const Body<D>& body, const FacetSet& facets)
      : complex(body.complex), change(unglue(complex, facets)) {}
};

struct PinchedEdge {
  std::array<Index, 2> places;  // of its ends in the mesh of the body, ascending
  std::vector<Index> cells;     // of two parts around it, ascending
};

template <int D>
std::vector<PinchedEdge> pinched_edges(const Body<D>& body, const AfterCut<D>& after) {
  topology::CellSoup<D> soup{{after.complex.cells().begin(), after.complex.cells().end()},
                             after.complex.vertex_count(),
                             {}};
  for (Index c = 0; c < soup.cells.size(); ++c)
    soup.signs.push_back(static_cast<std::int8_t>(after.complex.sign({c})));
  std::vector<PinchedEdge> edges;
  for (const auto& violation : check(soup, topology::Level::edge_regular)) {
    const auto* pinched = std::get_if<topology::PinchedSimplex>(&violation);
    if (pinched == nullptr) continue;
    PinchedEdge edge{{}, {pinched->one_part.value, pinched->other_part.value}};
    for (std::size_t i = 0; i < 2; ++i)
      edge.places[i] = body.place(after.change.parent(pinched->simplex[i]));
    std::sort(edge.places.begin(), edge.places.end());
    std::sort(edge.cells.begin(), edge.cells.end());
    edges.push_back(std::move(edge));
  }
  return edges;
}

// The half-facet of a part that was `h` in the whole; none if its cell is not in the part.
template <int D>
std::optional<HalfFacetId> in_part(HalfFacetId h, const std::vector<Index>& cells) {
  const auto at = std::lower_bound(cells.begin(), cells.end(), topology::cell_of<D>(h).value);
  if (at == cells.end() || *at != topology::cell_of<D>(h).value) return std::nullopt;
  return topology::half_facet<D>({static_cast<Index>(at - cells.begin())},
                                 topology::local_index<D>(h));
}

// A candidate, cut. Throws InputError if it cannot be.
template <int D>
struct CutPart {
  SubMesh part;
  Body<D> body;
  AfterCut<D> after;

  CutPart(SubMesh some, const Candidate& candidate, const Sides& sides)
      : part(std::move(some)),
        body(make_body<D>(part.mesh)),
        after(body, FacetSet::of(body.complex, inner(candidate, sides))) {}

  static std::vector<HalfFacetId> inner(const Candidate& candidate, const Sides& sides) {
    std::vector<HalfFacetId> facets;
    for (const Index f : candidate.facets) {
      const auto one = in_part<D>(sides.one[f], candidate.cells);
      if (one && in_part<D>(sides.other[f], candidate.cells)) facets.push_back(*one);
    }
    return facets;
  }
};

template <int D>
bool stays_shut(const CutPart<D>& cut, HalfFacetId facet, const Candidate& candidate) {
  const auto here = in_part<D>(facet, candidate.cells);
  return here && cut.after.complex.is_interior(*here);
}

template <int D>
bool stays_pinched(const CutPart<D>& cut, const PinchedEdge& wanted) {
  const auto edges = pinched_edges(cut.body, cut.after);
  return std::any_of(edges.begin(), edges.end(), [&](const PinchedEdge& edge) {
    return cut.part.place[edge.places[0]] == wanted.places[0] &&
           cut.part.place[edge.places[1]] == wanted.places[1];
  });
}

template <int D>
CutProperty property_of(const Mesh& mesh, const CutRequest& request, CutOutcome outcome) {
  const Body<D> body = make_body<D>(mesh);
  const FacetSet facets = requested(body, request);
  const AfterCut<D> after(body, facets);
  const auto sides = std::make_shared<Sides>();
  CutProperty result;
  for (const HalfFacetId h : facets.half_facets()) {
    sides->one.push_back(h);
    sides->other.push_back(*body.complex.mate(h));
    std::vector<Index> vertices;
    for (const VertexId v : body.complex.facet(h)) vertices.push_back(body.place(v));
    result.request.push_back(std::move(vertices));
  }
  Property& property = result.property;
  property.facets = facets.size();

  std::function<bool(const CutPart<D>&, const Candidate&)> shows;
  if (outcome == CutOutcome::shut) {
    if (after.change.shut.empty())
      throw InputError(mesh.source + ": there is nothing to reduce: no facet stays shut");
    const HalfFacetId shut = after.change.shut.front();
    property.what = fmt::format("facet ({}) stays shut", listed(facet_vertices(mesh, shut)));
    const auto at = std::find(sides->one.begin(), sides->one.end(), shut);
    property.kept_facets = {static_cast<Index>(at - sides->one.begin())};
    property.kept = {topology::cell_of<D>(shut).value,
                     topology::cell_of<D>(sides->other[property.kept_facets[0]]).value};
    for (const auto& because : explain(after.complex, FacetSet::of_lesser(after.change.shut), shut))
      for (const topology::CellId cell : because.through) property.seed.push_back(cell.value);
    shows = [shut](const CutPart<D>& cut, const Candidate& candidate) {
      return stays_shut(cut, shut, candidate);
    };
  } else {
    const auto edges = pinched_edges(body, after);
    if (edges.empty())
      throw InputError(mesh.source +
                       ": there is nothing to reduce: the cut leaves no pinched edge");
    const PinchedEdge& edge = edges.front();
    property.what = fmt::format("edge ({} {}) is pinched", mesh.vertex_numbers[edge.places[0]],
                                mesh.vertex_numbers[edge.places[1]]);
    property.kept = edge.cells;
    property.seed = edge.cells;
    shows = [wanted = edge](const CutPart<D>& cut, const Candidate&) {
      return stays_pinched(cut, wanted);
    };
  }
  for (auto* cells : {&property.kept, &property.seed}) {
    std::sort(cells->begin(), cells->end());
    cells->erase(std::unique(cells->begin(), cells->end()), cells->end());
  }

  const auto known = std::make_shared<KnownFindings>(mesh, topology::Level::cut_regular);
  property.judge = [&mesh, known, sides, shows](const Candidate& candidate) {
    SubMesh part = sub_mesh(mesh, candidate.cells, candidate.loose);
    bool new_rule = false;
    Judgement judgement;
    judgement.blame = known->blame(known->of(part), new_rule);
    if (new_rule) return judgement;
    try {
      judgement.holds = shows(CutPart<D>(std::move(part), candidate, *sides), candidate);
    } catch (const InputError&) {  // its cells are no oriented complex: some of the whole must be
    }
    return judgement;
  };
  return result;
}

}  // namespace

CutProperty cut_property(const Mesh& mesh, const CutRequest& request, CutOutcome outcome) {
  if (mesh.dimension == 1) return property_of<1>(mesh, request, outcome);
  if (mesh.dimension == 2) return property_of<2>(mesh, request, outcome);
  return property_of<3>(mesh, request, outcome);
}

}  // namespace cleave::app
