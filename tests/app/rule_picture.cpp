#include "rule_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "body.hpp"

namespace cleave::app::test {
namespace {

struct Spot {
  double x = 0, y = 0, depth = 0;  // on the paper, y downwards; larger depth is farther away
};

Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y, a.depth + b.depth}; }
Spot operator*(double s, Spot a) { return {s * a.x, s * a.y, s * a.depth}; }

std::string number(double x) {
  const std::string text = fmt::format("{:.1f}", x);
  return text == "-0.0" ? "0.0" : text;
}

std::string path(const std::vector<Spot>& spots) {
  std::vector<std::string> words;
  for (const Spot& spot : spots) words.push_back(number(spot.x) + "," + number(spot.y));
  return fmt::format("{}", fmt::join(words, " "));
}

constexpr double kWidth = 480, kHeight = 300, kMargin = 48;

// Where each vertex is on the paper.
std::vector<Spot> project(const Mesh& mesh, const std::vector<std::array<double, 3>>& points) {
  const bool from_above = is_planar(mesh);
  constexpr double kYaw = -0.5, kPitch = 0.55;
  std::vector<Spot> spots;
  for (const auto& p : points) {
    const double along = std::cos(kYaw) * p[0] + std::sin(kYaw) * p[1];
    const double away = -std::sin(kYaw) * p[0] + std::cos(kYaw) * p[1];
    if (from_above)
      spots.push_back({p[0], -p[1], 0});
    else
      spots.push_back({along, -(std::cos(kPitch) * p[2] + std::sin(kPitch) * away),
                       std::cos(kPitch) * away - std::sin(kPitch) * p[2]});
  }
  double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
  for (const Spot& s : spots) {
    low[0] = std::min(low[0], s.x);
    high[0] = std::max(high[0], s.x);
    low[1] = std::min(low[1], s.y);
    high[1] = std::max(high[1], s.y);
  }
  const double scale = std::min((kWidth - 2 * kMargin) / std::max(high[0] - low[0], 1e-9),
                                (kHeight - 2 * kMargin) / std::max(high[1] - low[1], 1e-9));
  for (Spot& s : spots) {
    s.x = kWidth / 2 + scale * (s.x - (low[0] + high[0]) / 2);
    s.y = kHeight / 2 + scale * (s.y - (low[1] + high[1]) / 2);
  }
  return spots;
}

// What the witnesses name, in the file's numbers.
struct Named {
  std::set<std::uint64_t> cells, vertices;
  std::vector<std::vector<std::uint64_t>> simplices;  // edges and facets

  explicit Named(const std::vector<Finding>& findings) {
    for (const Finding& finding : findings)
      for (const auto& [key, value] : finding.witness) {
        const auto* one = std::get_if<std::uint64_t>(&value);
        const auto* many = std::get_if<std::vector<std::uint64_t>>(&value);
        const auto* lists = std::get_if<std::vector<std::vector<std::uint64_t>>>(&value);
        if (one && key == "cell") cells.insert(*one);
        if (many && key == "cells") cells.insert(many->begin(), many->end());
        if (one && (key == "vertex" || key == "repeated" || key == "node")) vertices.insert(*one);
        if (many &&
            (key == "nodes" || (key == "vertices" && finding.rule == "coincident-vertices")))
          vertices.insert(many->begin(), many->end());
        if (many && (key == "facet" || key == "edge")) simplices.push_back(*many);
        if (lists) simplices.insert(simplices.end(), lists->begin(), lists->end());
      }
  }
};

class Picture {
 public:
  Picture(const Mesh& mesh, const std::vector<Finding>& findings)
      : mesh_(mesh), named_(findings), known_(mesh.points.size(), true) {
    auto points = mesh.points;
    for (std::size_t v = 0; v < points.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (!std::isfinite(points[v][axis])) {
          known_[v] = false;
          points[v][axis] = axis < 2 ? 0.4 : 0;
        }
    spots_ = project(mesh, points);
  }

  std::string svg(bool arrows) {
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" font-family=\"sans-serif\">\n<rect width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" "
        "fill=\"#ffffff\"/>\n",
        kWidth, kHeight);
    return text + faces() + (arrows ? senses() : "") + simplices() + labels() + "</svg>\n";
  }

 private:
  std::size_t corners() const { return static_cast<std::size_t>(mesh_.dimension) + 1; }
  Index place(std::size_t cell, std::size_t i) const {
    return mesh_.cells().vertices[corners() * cell + i];
  }

  Spot centre(std::size_t cell) const {
    Spot sum;
    for (std::size_t i = 0; i < corners(); ++i) sum = sum + spots_[place(cell, i)];
    return 1.0 / static_cast<double>(corners()) * sum;
  }

  std::set<Index> vertices_of(std::size_t cell) const {
    const auto* first = &mesh_.cells().vertices[corners() * cell];
    return {first, first + corners()};
  }
  bool repeated_later(std::size_t cell) const {
    for (std::size_t later = cell + 1; later < mesh_.cells().size(); ++later)
      if (vertices_of(later) == vertices_of(cell)) return true;
    return false;
  }

  // The corners of a cell, drawn towards its centre; of one that repeats another, more so.
  std::vector<Spot> drawn(std::size_t cell) const {
    double size = 0.92;
    for (std::size_t other = 0; other < cell; ++other)
      if (vertices_of(other) == vertices_of(cell)) size -= 0.4;
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < corners(); ++i)
      spots.push_back(size * spots_[place(cell, i)] + (1 - size) * centre(cell));
    return spots;
  }

  // Every triangle of every cell, the farthest first.
  std::string faces() const {
    std::multimap<double, std::string> farthest_first;
    for (std::size_t c = 0; c < mesh_.cells().size(); ++c) {
      const bool named = named_.cells.count(mesh_.cells().numbers[c]) > 0;
      bool known = true;
      for (std::size_t i = 0; i < corners(); ++i) known = known && known_[place(c, i)];
      const std::vector<Spot> spots = drawn(c);
      for (std::size_t out = 0; out < (corners() == 4 ? 4u : 1u); ++out) {
        std::vector<Spot> face = spots;
        if (corners() == 4) face.erase(face.begin() + static_cast<std::ptrdiff_t>(out));
        double depth = 0;
        for (const Spot& s : face) depth -= s.depth / 3;
        farthest_first.emplace(
            depth,
            fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"{}\" "
                        "stroke=\"{}\" stroke-width=\"1.5\" stroke-linejoin=\"round\"{}/>\n",
                        path(face), named ? "#f6a45a" : "#a9c1dc",
                        !known           ? "0.15"
                        : corners() == 4 ? "0.45"
                                         : "0.75",
                        named ? "#a85a12" : "#4a6688", known ? "" : " stroke-dasharray=\"6 5\""));
      }
    }
    std::string text;
    for (const auto& [depth, polygon] : farthest_first) text += polygon;
    return text;
  }

  // In each triangle an arrow the way its vertices are listed.
  std::string senses() const {
    std::string text;
    for (std::size_t c = 0; c < mesh_.cells().size(); ++c) {
      const std::vector<Spot> s = drawn(c);
      const double area =
          (s[1].x - s[0].x) * (s[2].y - s[0].y) - (s[2].x - s[0].x) * (s[1].y - s[0].y);
      const double turn = area > 0 ? 1 : -1;  // on paper, where y points down: +1 is clockwise
      const Spot m = centre(c);
      constexpr double kRadius = 20;
      std::vector<Spot> arc;
      for (int i = 0; i <= 16; ++i) {
        const double angle = 0.6 + turn * 4.6 * i / 16;
        arc.push_back({m.x + kRadius * std::cos(angle), m.y + kRadius * std::sin(angle), 0});
      }
      const double end = 0.6 + turn * 4.6;
      const Spot tip = arc.back();
      const auto barb = [&](double away) {
        const double angle = end - turn * M_PI / 2 + away;
        return Spot{tip.x + 9 * std::cos(angle), tip.y + 9 * std::sin(angle), 0};
      };
      text += fmt::format(
          "<polyline points=\"{}\" fill=\"none\" stroke=\"#333333\" stroke-width=\"2\"/>\n"
          "<polyline points=\"{}\" fill=\"none\" stroke=\"#333333\" stroke-width=\"2\"/>\n",
          path(arc), path({barb(0.5), tip, barb(-0.5)}));
    }
    return text;
  }

  std::string simplices() const {
    std::map<std::uint64_t, Spot> spot_of;
    for (std::size_t v = 0; v < spots_.size(); ++v) spot_of[mesh_.vertex_numbers[v]] = spots_[v];
    std::string text;
    for (const auto& simplex : named_.simplices) {
      std::vector<Spot> spots;
      for (const std::uint64_t v : simplex) spots.push_back(spot_of.at(v));
      text += fmt::format(
          "<polygon points=\"{}\" fill=\"#d11f2a\" fill-opacity=\"0.25\" stroke=\"#d11f2a\" "
          "stroke-width=\"3\" stroke-linejoin=\"round\"/>\n",
          path(spots));
    }
    return text;
  }

  static std::string label(double x, double y, const std::string& text, const char* look) {
    return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" {}>{}</text>\n", number(x),
                       number(y + 5), look, text);
  }

  std::string labels() const {
    std::string text;
    for (std::size_t c = 0; c < mesh_.cells().size() && mesh_.cells().size() <= 8; ++c) {
      // Of two cells in one place the outer one has its label at a corner.
      const Spot m = repeated_later(c) ? 0.72 * drawn(c).back() + 0.28 * centre(c) : centre(c);
      text += label(m.x, m.y, std::to_string(mesh_.cells().numbers[c]),
                    "font-size=\"15\" font-style=\"italic\" fill=\"#33465e\"");
    }
    // Vertices in one place share a label.
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> at;
    for (std::size_t v = 0; v < spots_.size(); ++v)
      at[{number(spots_[v].x), number(spots_[v].y)}].push_back(v);
    for (const auto& [where, vertices] : at) {
      const Spot s = spots_[vertices.front()];
      std::vector<std::uint64_t> numbers;
      bool named = false;
      for (const std::size_t v : vertices) {
        numbers.push_back(mesh_.vertex_numbers[v]);
        named = named || named_.vertices.count(numbers.back()) > 0;
      }
      const double dx = s.x - kWidth / 2, dy = s.y - kHeight / 2;
      const double length = std::max(std::hypot(dx, dy), 1.0);
      const bool middle = length < 60;  // every direction is as good: to the left
      text += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", number(s.x),
                          number(s.y), named ? 6 : 3, named ? "#d11f2a" : "#1d2b3d");
      text +=
          label(s.x + (middle ? -18 : 19 * dx / length), s.y + (middle ? -8 : 19 * dy / length),
                fmt::format("{}{}", fmt::join(numbers, ", "), known_[vertices.front()] ? "" : "?"),
                named ? "font-size=\"17\" font-weight=\"bold\" fill=\"#d11f2a\""
                      : "font-size=\"17\" fill=\"#1d2b3d\"");
    }
    return text;
  }

  const Mesh& mesh_;
  Named named_;
  std::vector<bool> known_;  // per vertex: has a place
  std::vector<Spot> spots_;
};

}  // namespace

std::string rule_picture(const Mesh& mesh, const std::vector<Finding>& findings, bool arrows) {
  return Picture(mesh, findings).svg(arrows);
}

}  // namespace cleave::app::test
