#include "coverage.hpp"

#include <iomanip>
#include <string_view>

namespace cleave::topology {
namespace {

constexpr std::array<std::string_view, kMarks.size()> kMarkNames{"split",   "shut",   "branching",
                                                                 "pinched", "closed", "pieces"};

/// Below this many cases 5 % means little.
constexpr std::size_t kFewestJudged = 100;

std::string percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? "-" : std::to_string((100 * part + whole / 2) / whole) + "%";
}

bool is_below_five_percent(std::size_t part, std::size_t whole) { return 20 * part < whole; }

}  // namespace

bool can_occur(Mark mark, int dimension) {
  const bool needs_ridges = mark == Mark::shut || mark == Mark::branching || mark == Mark::pinched;
  return dimension >= 2 || !needs_ridges;
}

Coverage& coverage() {
  static Coverage instance;
  return instance;
}

void Coverage::record(const std::string& property, int dimension, support::MeshClass mesh_class,
                      support::CutClass cut_class, const Marks& marks) {
  Row& row = rows_[{property, dimension}];
  Counts& counts = row.meshes[mesh_class];
  ++counts.cases;
  ++row.cuts[cut_class];
  for (std::size_t m = 0; m < marks.size(); ++m)
    if (marks[m]) ++counts.marks[m];
}

void Coverage::record_defect(int dimension, support::Defect defect) {
  ++defects_[dimension][defect];
}

Coverage::Counts Coverage::Row::total() const {
  Counts sum;
  for (const auto& [mesh_class, counts] : meshes) {
    sum.cases += counts.cases;
    for (std::size_t m = 0; m < sum.marks.size(); ++m) sum.marks[m] += counts.marks[m];
  }
  return sum;
}

void Coverage::print(std::ostream& out) const {
  const auto line = [&](const std::string& property, int dimension, std::string_view input,
                        const Counts& counts) {
    out << std::left << std::setw(16) << property << 'D' << dimension << "  " << std::setw(11)
        << input << std::right << std::setw(6) << counts.cases;
    for (const std::size_t marked : counts.marks)
      out << std::setw(11) << percent(marked, counts.cases);
    out << '\n';
  };
  out << std::left << std::setw(16) << "property"
      << "D   " << std::setw(11) << "input" << std::right << std::setw(6) << "cases";
  for (const std::string_view mark : kMarkNames) out << std::setw(11) << mark;
  out << '\n';
  for (const auto& [key, row] : rows_) {
    for (const auto& [mesh_class, counts] : row.meshes)
      line(key.first, key.second, support::name(mesh_class), counts);
    line(key.first, key.second, "all", row.total());
  }
  out << '\n'
      << std::left << std::setw(16) << "property"
      << "D " << std::right;
  for (const auto cut_class : support::kCutClasses)
    out << std::setw(11) << support::name(cut_class);
  out << '\n';
  for (const auto& [key, row] : rows_) {
    out << std::left << std::setw(16) << key.first << 'D' << key.second << std::right;
    for (const auto cut_class : support::kCutClasses) {
      const auto found = row.cuts.find(cut_class);
      out << std::setw(11)
          << percent(found == row.cuts.end() ? 0 : found->second, row.total().cases);
    }
    out << '\n';
  }
  for (const auto& [dimension, planted] : defects_) {
    out << "\nplanted, D" << dimension << ':';
    for (const auto& [defect, cases] : planted)
      out << ' ' << support::name(defect) << ' ' << cases << ',';
  }
  out << "\n";
}

std::vector<std::string> Coverage::gaps() const {
  std::vector<std::string> result;
  const auto judge_share = [&](const std::string& where, std::string_view what, std::size_t count,
                               std::size_t cases) {
    if (cases >= kFewestJudged && is_below_five_percent(count, cases))
      result.push_back(where + ": only " + std::to_string(count) + " of " + std::to_string(cases) +
                       " cases are " + std::string(what));
  };
  for (const auto& [key, row] : rows_) {
    const Counts total = row.total();
    const std::string where = key.first + " D" + std::to_string(key.second);
    const auto judge = [&](std::string_view what, std::size_t count) {
      judge_share(where, what, count, total.cases);
    };
    for (const auto mesh_class : support::kMeshClasses) {
      const auto found = row.meshes.find(mesh_class);
      judge(support::name(mesh_class), found == row.meshes.end() ? 0 : found->second.cases);
    }
    for (const auto cut_class : support::kCutClasses) {
      const auto found = row.cuts.find(cut_class);
      if (support::can_occur(cut_class, key.second))
        judge(support::name(cut_class), found == row.cuts.end() ? 0 : found->second);
    }
    for (std::size_t m = 0; m < kMarks.size(); ++m)
      if (can_occur(kMarks[m], key.second)) judge(kMarkNames[m], total.marks[m]);
  }
  for (const auto& [dimension, planted] : defects_) {
    std::size_t cases = 0;
    for (const auto& [defect, count] : planted) cases += count;
    for (const auto defect : support::kDefects) {
      const auto found = planted.find(defect);
      if (support::can_occur(defect, dimension))
        judge_share("planted D" + std::to_string(dimension), support::name(defect),
                    found == planted.end() ? 0 : found->second, cases);
    }
  }
  return result;
}

}  // namespace cleave::topology
