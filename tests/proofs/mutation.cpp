#include "mutation.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

namespace cleave::proofs {
namespace {

using Numbers = std::vector<std::uint32_t>;

std::uint32_t unused(const Numbers& numbers, Rng& rng) {
  for (;;) {
    const auto number = static_cast<std::uint32_t>(rng.next());
    if (std::find(numbers.begin(), numbers.end(), number) == numbers.end()) return number;
  }
}

void rename(Numbers& after, Rng& rng) {
  const auto offset = static_cast<std::uint32_t>(rng.next());
  for (std::uint32_t& v : after) v = offset ^ (v << 16U | v >> 16U);  // a bijection
}

std::map<std::uint32_t, std::set<std::uint32_t>> copies_of(const Numbers& before,
                                                           const Numbers& after) {
  std::map<std::uint32_t, std::set<std::uint32_t>> copies;
  for (std::size_t c = 0; c < after.size(); ++c) copies[before[c]].insert(after[c]);
  return copies;
}

bool take_other_copy(const Numbers& before, Numbers& after, Rng& rng) {
  auto copies = copies_of(before, after);
  std::vector<std::size_t> corners;  // of split vertices
  for (std::size_t c = 0; c < after.size(); ++c)
    if (copies.at(before[c]).size() > 1) corners.push_back(c);
  if (corners.empty()) return false;
  const std::size_t corner = rng.pick(corners);
  auto& names = copies.at(before[corner]);
  names.erase(after[corner]);
  after[corner] = rng.pick(Numbers(names.begin(), names.end()));
  return true;
}

bool lose_split(const Numbers& before, Numbers& after, Rng& rng) {
  const auto copies = copies_of(before, after);
  std::vector<Numbers> split;
  for (const auto& [vertex, names] : copies)
    if (names.size() > 1) split.emplace_back(names.begin(), names.end());
  if (split.empty()) return false;
  auto names = rng.pick(split);
  rng.shuffle(names);
  std::replace(after.begin(), after.end(), names[0], names[1]);
  return true;
}

bool split_more(Numbers& after, Rng& rng) {
  std::unordered_map<std::uint32_t, std::vector<std::size_t>> corners;
  for (std::size_t c = 0; c < after.size(); ++c) corners[after[c]].push_back(c);
  for (int tries = 0; tries < 20; ++tries) {
    auto of_one = corners.at(rng.pick(after));
    if (of_one.size() < 2) continue;
    rng.shuffle(of_one);
    of_one.resize(1 + rng.below(of_one.size() - 1));
    const std::uint32_t name = unused(after, rng);
    for (const std::size_t c : of_one) after[c] = name;
    return true;
  }
  return false;
}

}  // namespace

std::string_view name(Mutation mutation) {
  constexpr std::array<std::string_view, kMutations.size()> kNames{
      "renamed",       "wrong vertex",  "other copy",   "lost split", "extra split",
      "swapped cells", "permuted cell", "dropped cell", "added cell", "other cut"};
  return kNames[static_cast<std::size_t>(mutation)];
}

std::optional<Numbers> mutated(const Sample& sample, Mutation mutation, Rng& rng) {
  Numbers after = sample.certificate.after;
  const auto width = static_cast<std::ptrdiff_t>(sample.certificate.corners());
  const std::size_t cells = sample.certificate.cell_count();
  const auto cell = [&](std::size_t c) { return after.begin() + width * static_cast<int>(c); };
  const std::size_t one = rng.below(cells), other = rng.below(cells);
  switch (mutation) {
    case Mutation::renamed:
      rename(after, rng);
      return after;
    case Mutation::wrong_vertex: {
      const std::uint32_t wrong = rng.pick(after);
      after[rng.below(after.size())] = wrong;
      return after;
    }
    case Mutation::other_copy:
      if (!take_other_copy(sample.certificate.before, after, rng)) return std::nullopt;
      return after;
    case Mutation::lost_split:
      if (!lose_split(sample.certificate.before, after, rng)) return std::nullopt;
      return after;
    case Mutation::extra_split:
      if (!split_more(after, rng)) return std::nullopt;
      return after;
    case Mutation::swapped_cells:
      if (one == other) return std::nullopt;
      std::swap_ranges(cell(one), cell(one + 1), cell(other));
      return after;
    case Mutation::permuted_cell:
      std::rotate(cell(one), cell(one) + 1 + static_cast<std::ptrdiff_t>(rng.below(width - 1U)),
                  cell(one + 1));
      return after;
    case Mutation::dropped_cell:
      after.erase(cell(one), cell(one + 1));
      return after;
    case Mutation::added_cell: {
      const Numbers copy(cell(one), cell(one + 1));
      after.insert(cell(other), copy.begin(), copy.end());
      return after;
    }
    case Mutation::other_cut:
      return sample.other_after;
  }
  return std::nullopt;
}

}  // namespace cleave::proofs
