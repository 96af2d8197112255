#include "element_images.hpp"

#include <algorithm>
#include <bit>

namespace cleave::app {

using topology::CellId;

template <int D>
Index Renaming<D>::in_cell(CellId cell, Index place) const {
  const Index* tuple = &body->mesh->cells().vertices[static_cast<std::size_t>(D + 1) * cell.value];
  const auto i = static_cast<std::size_t>(std::find(tuple, tuple + D, place) - tuple);
  return place_of[after->vertices(cell)[i].value];
}

namespace {

constexpr std::size_t kMost = 3;         // vertices of an element below the cells, at most
using Tuple = std::array<Index, kMost>;  // filled up with kNoPlace

struct Keyed {
  Tuple key;  // ascending places in the file
  Index element;
  friend bool operator<(const Keyed& a, const Keyed& b) {
    return a.key != b.key ? a.key < b.key : a.element < b.element;
  }
};

struct Image {
  Index element;
  Tuple tuple;
};

Tuple tuple_of(const Elements& elements, std::size_t corners, std::size_t e) {
  Tuple tuple;
  tuple.fill(kNoPlace);
  std::copy_n(&elements.vertices[corners * e], corners, tuple.begin());
  return tuple;
}

Tuple ascending(Tuple tuple) {
  std::sort(tuple.begin(), tuple.end());
  return tuple;
}

// For each face with `corners` vertices of each cell that has a vertex with several copies: the
// images it makes of the elements there, by ascending cell.
template <int D>
std::vector<Image> images_in_cells(const Renaming<D>& renaming, std::size_t corners,
                                   const Elements& elements, const std::vector<Keyed>& keyed,
                                   const std::vector<Index>& copies) {
  std::vector<Image> images;
  const Index* cell = renaming.body->mesh->cells().vertices.data();
  for (Index c = 0; c < renaming.after->cell_count(); ++c, cell += D + 1) {
    unsigned split = 0;
    for (int i = 0; i <= D; ++i)
      if (copies[cell[i]] > 1) split |= 1u << i;
    if (split == 0) continue;
    for (unsigned face = 1; face < (1u << (D + 1)); ++face) {
      if ((face & split) == 0 || static_cast<std::size_t>(std::popcount(face)) != corners) continue;
      Keyed key{{}, 0};
      key.key.fill(kNoPlace);
      std::size_t n = 0;
      for (int i = 0; i <= D; ++i)
        if ((face >> i) & 1u) key.key[n++] = cell[i];
      key.key = ascending(key.key);
      for (auto at = std::lower_bound(keyed.begin(), keyed.end(), key);
           at != keyed.end() && at->key == key.key; ++at) {
        Image image{at->element, tuple_of(elements, corners, at->element)};
        for (std::size_t i = 0; i < corners; ++i)
          image.tuple[i] = renaming.in_cell({c}, image.tuple[i]);
        images.push_back(image);
      }
    }
  }
  return images;
}

}  // namespace

template <int D>
std::vector<Index> count_copies(const Renaming<D>& renaming) {
  const Mesh& mesh = *renaming.body->mesh;
  std::vector<Index> copies(mesh.points.size());
  std::vector<bool> seen(renaming.after->vertex_count());
  const Index* file_vertex = mesh.cells().vertices.data();
  for (const auto& cell : renaming.after->cells())
    for (const auto v : cell) {
      const Index place = *file_vertex++;
      if (!seen[v.value]) ++copies[place];
      seen[v.value] = true;
    }
  return copies;
}

template <int D>
Images images_of(const Renaming<D>& renaming, int element_dimension, const Elements& elements) {
  const auto corners = static_cast<std::size_t>(element_dimension) + 1;
  const auto copies = count_copies(renaming);

  std::vector<Keyed> keyed;  // the elements that the cut may have touched
  for (Index e = 0; e < elements.size(); ++e) {
    const Tuple tuple = tuple_of(elements, corners, e);
    if (std::any_of(tuple.begin(), tuple.begin() + static_cast<std::ptrdiff_t>(corners),
                    [&](Index place) { return copies[place] > 1; }))
      keyed.push_back({ascending(tuple), e});
  }
  std::sort(keyed.begin(), keyed.end());
  auto found = images_in_cells(renaming, corners, elements, keyed, copies);
  std::stable_sort(found.begin(), found.end(),
                   [](const Image& a, const Image& b) { return a.element < b.element; });

  Images images;
  const auto add = [&](const Tuple& tuple) {
    images.vertices.insert(images.vertices.end(), tuple.begin(),
                           tuple.begin() + static_cast<std::ptrdiff_t>(corners));
  };
  std::size_t next = 0;
  for (Index e = 0; e < elements.size(); ++e) {
    images.first.push_back(static_cast<Index>(images.vertices.size() / corners));
    const std::size_t begin = next;
    for (; next < found.size() && found[next].element == e; ++next) {
      const auto same = [&](const Image& other) { return other.tuple == found[next].tuple; };
      const auto from = found.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto to = found.begin() + static_cast<std::ptrdiff_t>(next);
      if (std::none_of(from, to, same)) add(found[next].tuple);
    }
    if (next > begin) continue;
    Tuple tuple = tuple_of(elements, corners, e);
    bool used = true;
    for (std::size_t i = 0; i < corners; ++i) {
      used = used && copies[tuple[i]] > 0;
      if (used) tuple[i] = renaming.place_of[tuple[i]];  // the original vertex keeps its id
    }
    if (used) add(tuple);
  }
  images.first.push_back(static_cast<Index>(images.vertices.size() / corners));
  return images;
}

template struct Renaming<1>;
template struct Renaming<2>;
template struct Renaming<3>;
template std::vector<Index> count_copies<1>(const Renaming<1>&);
template std::vector<Index> count_copies<2>(const Renaming<2>&);
template std::vector<Index> count_copies<3>(const Renaming<3>&);
template Images images_of<1>(const Renaming<1>&, int, const Elements&);
template Images images_of<2>(const Renaming<2>&, int, const Elements&);
template Images images_of<3>(const Renaming<3>&, int, const Elements&);

}  // namespace cleave::app
