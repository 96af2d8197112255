#include "reduce.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "ddmin.hpp"

namespace cleave::app {
namespace {

using Places = std::vector<Index>;

Places united(const Places& a, const Places& b) {
  Places both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

Places without(const Places& a, const Places& b) {
  Places rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest;
}

Places first(std::size_t n) {
  Places all(n);
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

class Reducer {
 public:
  Reducer(const Mesh& mesh, const Property& property,
          const std::function<void(const Reduction&)>& progress)
      : property_(property),
        progress_(progress),
        corners_(static_cast<std::size_t>(mesh.dimension) + 1),
        tuples_(mesh.cells().vertices),
        cells_at_(mesh.points.size()) {
    for (Index c = 0; c < mesh.cells().size(); ++c)
      for (std::size_t i = 0; i < corners_; ++i) {
        Places& at = cells_at_[tuples_[corners_ * c + i]];
        if (at.empty() || at.back() != c) at.push_back(c);
      }
    best_.rest.cells = first(mesh.cells().size());
    best_.rest.facets = first(property.facets);
    for (Index v = 0; v < mesh.points.size(); ++v)
      if (cells_at_[v].empty()) best_.rest.loose.push_back(v);
    drop_midsides(mesh);
  }

  Reduction run() {
    start_at_the_seed();
    drop_pieces();
    for (std::size_t size = 0; size != best_size();) {  // what one step drops may free another
      size = best_size();
      shrink(&Candidate::cells, property_.kept);
      shrink(&Candidate::loose, {});
      shrink(&Candidate::facets, property_.kept_facets);
    }
    return best_;
  }

 private:
  std::size_t best_size() const {
    return best_.rest.cells.size() + best_.rest.loose.size() + best_.rest.facets.size();
  }

  // Nodes of second order are in use, though cells_at_ does not know them.
  void drop_midsides(const Mesh& mesh) {
    Places between;
    for (const Elements& elements : mesh.elements)
      between.insert(between.end(), elements.midside.begin(), elements.midside.end());
    std::sort(between.begin(), between.end());
    between.erase(std::unique(between.begin(), between.end()), between.end());
    best_.rest.loose = without(best_.rest.loose, between);
  }

  Judgement judge(Candidate candidate) {
    ++best_.tries;
    if (candidate.cells.empty()) return {};
    Judgement judgement = property_.judge(candidate);
    if (judgement.holds) {
      best_.rest = std::move(candidate);
      progress_(best_);
    }
    return judgement;
  }

  Places around(const Places& vertices) const {
    Places cells;
    for (const Index v : vertices)
      cells.insert(cells.end(), cells_at_[v].begin(), cells_at_[v].end());
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
  }

  Places vertices_of(const Places& cells) const {
    Places vertices;
    for (const Index c : cells)
      vertices.insert(vertices.end(), &tuples_[corners_ * c], &tuples_[corners_ * c] + corners_);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  // Takes the cells around blamed vertices, or else one ring, until the property holds. Beyond half
  // of the mesh the whole is as good a start.
  void start_at_the_seed() {
    if (property_.seed.empty()) return;
    Candidate candidate = best_.rest;
    candidate.cells = property_.seed;
    const std::size_t most = best_.rest.cells.size() / 2;
    while (candidate.cells.size() <= most) {
      const Judgement judgement = judge(candidate);
      if (judgement.holds) return;
      const std::size_t size = candidate.cells.size();
      candidate.cells = united(candidate.cells, around(judgement.blame));
      if (candidate.cells.size() == size)
        candidate.cells = united(candidate.cells, around(vertices_of(candidate.cells)));
      if (candidate.cells.size() == size) return;  // these are whole pieces
    }
  }

  // The sets of cells that hang together by vertices, by least cell.
  std::vector<Places> pieces() const {
    std::vector<Places> all;
    Places left = best_.rest.cells;
    std::vector<bool> is_left(tuples_.size() / corners_, false), seen(cells_at_.size(), false);
    for (const Index c : left) is_left[c] = true;
    for (const Index start : left) {
      if (!is_left[start]) continue;
      is_left[start] = false;
      Places piece{start};
      for (std::size_t i = 0; i < piece.size(); ++i)
        for (std::size_t k = 0; k < corners_; ++k) {
          const Index v = tuples_[corners_ * piece[i] + k];
          if (seen[v]) continue;
          seen[v] = true;
          for (const Index next : cells_at_[v])
            if (is_left[next]) {
              is_left[next] = false;
              piece.push_back(next);
            }
        }
      std::sort(piece.begin(), piece.end());
      all.push_back(std::move(piece));
    }
    return all;
  }

  void drop_pieces() {
    const auto all = pieces();
    if (all.size() < 2) return;
    const Candidate start = best_.rest;
    ddmin(all, [&](const std::vector<Places>& some) {
      Candidate candidate = start;
      candidate.cells = property_.kept;
      for (const Places& piece : some) candidate.cells = united(candidate.cells, piece);
      return judge(std::move(candidate)).holds;
    });
  }

  void shrink(Places Candidate::*what, const Places& kept) {
    const Candidate start = best_.rest;
    ddmin(without(start.*what, kept), [&](const Places& some) {
      Candidate candidate = start;
      candidate.*what = united(some, kept);
      return judge(std::move(candidate)).holds;
    });
  }

  const Property& property_;
  const std::function<void(const Reduction&)>& progress_;
  std::size_t corners_;
  const Places& tuples_;
  std::vector<Places> cells_at_;  // by vertex
  Reduction best_;
};

}  // namespace

Reduction reduce(const Mesh& mesh, const Property& property,
                 const std::function<void(const Reduction&)>& progress) {
  return Reducer(mesh, property, progress).run();
}

}  // namespace cleave::app
