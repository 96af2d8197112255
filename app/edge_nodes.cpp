#include "edge_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "file_words.hpp"

namespace cleave::app {
namespace {

constexpr std::array<const char*, 4> kWord{"vertex element", "edge", "triangle", "tetrahedron"};

// The first element that has a node, and on which of its edges.
struct Seat {
  Index a = kNoNode, b = kNoNode;  // ends of the edge, ascending
  Index element = 0;
  int dimension = 0;  // 0: not seen
};

class NodeCheck {
 public:
  explicit NodeCheck(const Mesh& mesh) : mesh_(mesh), corner_(mesh.points.size()) {}

  std::vector<Finding> run() {
    find_mixed_dimensions();
    mark_corners();
    std::vector<Seat> seats(mesh_.points.size());
    for (int k = 1; k <= mesh_.dimension; ++k) {
      const Elements& elements = of(k);
      if (!elements.second_order()) continue;
      const std::size_t corners = static_cast<std::size_t>(k) + 1;
      const Index* node = elements.midside.data();
      for (Index e = 0; e < elements.size(); ++e) {
        const Index* v = &elements.vertices[corners * e];
        for (std::size_t i = 0; i < corners; ++i)
          for (std::size_t j = i + 1; j < corners; ++j)
            look_at(*node++, {std::min(v[i], v[j]), std::max(v[i], v[j]), e, k}, seats);
      }
    }
    find_edges_with_two(seats);
    return std::move(findings_);
  }

 private:
  const Elements& of(int k) const { return mesh_.elements[static_cast<std::size_t>(k)]; }
  std::uint64_t number(Index place) const { return mesh_.vertex_numbers[place]; }
  std::string element(const Seat& seat) const {
    return fmt::format("{} {}", kWord[static_cast<std::size_t>(seat.dimension)],
                       of(seat.dimension).numbers[seat.element]);
  }
  std::vector<std::uint64_t> ends(const Seat& seat) const {
    return {number(seat.a), number(seat.b)};
  }
  void add(std::string message, std::vector<std::pair<std::string, WitnessValue>> witness) {
    findings_.push_back({"bad-edge-node", Severity::error, std::move(message), std::move(witness)});
  }

  void find_mixed_dimensions() {
    const bool order = mesh_.cells().second_order();
    for (int k = 1; k < mesh_.dimension; ++k) {
      if (of(k).size() == 0 || of(k).second_order() == order) continue;
      const Seat first{0, 0, 0, k}, cell{0, 0, 0, mesh_.dimension};
      const Seat &with = order ? cell : first, &without = order ? first : cell;
      add(fmt::format("{} has nodes on its edges and {} has none; write the mesh in one order",
                      element(with), element(without)),
          {{"elements", std::vector{of(with.dimension).numbers.front(),
                                    of(without.dimension).numbers.front()}}});
    }
  }

  void mark_corners() {
    for (std::size_t k = 1; k < mesh_.elements.size(); ++k)
      for (const Index v : mesh_.elements[k].vertices) corner_[v] = true;
  }

  void look_at(Index node, const Seat& seat, std::vector<Seat>& seats) {
    if (node == kNoNode) {
      add(fmt::format("{} has no node on its edge ({}), while other edges have", element(seat),
                      listed(ends(seat))),
          {{"edge", ends(seat)}});
      return;
    }
    Seat& first = seats[node];
    if (first.dimension == 0) {
      first = seat;
      if (corner_[node])
        add(fmt::format("vertex {} is the node on the edge ({}) of {}, and a corner of an element",
                        number(node), listed(ends(seat)), element(seat)),
            {{"node", number(node)}, {"edge", ends(seat)}});
    } else if (first.a != seat.a || first.b != seat.b) {
      add(fmt::format("node {} is on the edge ({}) of {} and on the edge ({}) of {}", number(node),
                      listed(ends(first)), element(first), listed(ends(seat)), element(seat)),
          {{"node", number(node)}, {"edges", std::vector{ends(first), ends(seat)}}});
    }
  }

  void find_edges_with_two(const std::vector<Seat>& seats) {
    std::vector<Index> nodes;
    for (Index n = 0; n < seats.size(); ++n)
      if (seats[n].dimension != 0) nodes.push_back(n);
    const auto edge = [&](Index n) { return std::pair(seats[n].a, seats[n].b); };
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](Index m, Index n) { return edge(m) < edge(n); });
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const Index one = nodes[i - 1], other = nodes[i];
      if (edge(one) != edge(other)) continue;
      add(fmt::format("the edge ({}) has node {} in {} and node {} in {}", listed(ends(seats[one])),
                      number(one), element(seats[one]), number(other), element(seats[other])),
          {{"edge", ends(seats[one])}, {"nodes", std::vector{number(one), number(other)}}});
    }
  }

  const Mesh& mesh_;
  std::vector<bool> corner_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<bool> edge_nodes(const Mesh& mesh) {
  std::vector<bool> node(mesh.points.size());
  for (const Elements& elements : mesh.elements)
    for (const Index n : elements.midside)
      if (n != kNoNode) node[n] = true;
  for (std::size_t k = 1; k < mesh.elements.size(); ++k)
    for (const Index v : mesh.elements[k].vertices) node[v] = false;
  return node;
}

std::vector<Finding> check_edge_nodes(const Mesh& mesh) {
  const bool any = std::any_of(mesh.elements.begin(), mesh.elements.end(),
                               [](const Elements& e) { return e.second_order(); });
  if (!any) return {};
  return NodeCheck(mesh).run();
}

}  // namespace cleave::app
