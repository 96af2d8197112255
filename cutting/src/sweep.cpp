#include "cleave/cutting/sweep.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "finite.hpp"

namespace cleave::cutting {

template <int D>
std::pair<std::size_t, std::size_t> Sweep<D>::step(std::size_t k) const {
  const auto [first, last] = std::equal_range(step_of.begin(), step_of.end(), k);
  return {static_cast<std::size_t>(first - step_of.begin()),
          static_cast<std::size_t>(last - step_of.begin())};
}

template <int D>
void require_valid(const Sweep<D>& sweep) {
  if (sweep.simplices.size() != sweep.step_of.size())
    throw std::invalid_argument("sweep: " + std::to_string(sweep.simplices.size()) +
                                " simplices, but steps for " +
                                std::to_string(sweep.step_of.size()));
  const auto drop = std::is_sorted_until(sweep.step_of.begin(), sweep.step_of.end());
  if (drop != sweep.step_of.end())
    throw std::invalid_argument("sweep: simplex " + std::to_string(drop - sweep.step_of.begin()) +
                                " belongs to an earlier step than the one before it; order the "
                                "simplices by step");
  detail::require_finite<D>(sweep.simplices);
}

Sweep<3> sweep_of_blade(std::span<const std::array<Point<3>, 2>> positions) {
  Sweep<3> sweep;
  for (std::size_t i = 0; i + 1 < positions.size(); ++i) {
    const auto& [p0, q0] = positions[i];
    const auto& [p1, q1] = positions[i + 1];
    sweep.simplices.push_back({p0, q0, p1});
    sweep.simplices.push_back({q0, q1, p1});
    sweep.step_of.insert(sweep.step_of.end(), 2, static_cast<std::uint32_t>(i));
  }
  return sweep;
}

Sweep<2> sweep_of_polyline(std::span<const Point<2>> points) {
  Sweep<2> sweep;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    sweep.simplices.push_back({points[i], points[i + 1]});
    sweep.step_of.push_back(static_cast<std::uint32_t>(i));
  }
  return sweep;
}

template struct Sweep<2>;
template struct Sweep<3>;
template void require_valid(const Sweep<2>&);
template void require_valid(const Sweep<3>&);

}  // namespace cleave::cutting
