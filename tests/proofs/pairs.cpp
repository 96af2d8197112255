#include <algorithm>
#include <array>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>

#include "conformance.hpp"
#include "mutation.hpp"

namespace cleave::proofs {
namespace {

constexpr std::size_t kPairsPerRun = 200;
constexpr std::size_t kMutationsPerPair = 4;
const std::array<Verdict, 4> kClauses{"rejected: cells", "rejected: parent", "rejected: uncut",
                                      "rejected: connected"};

/// What the pairs of a dimension are like.
struct Kinds {
  std::vector<std::size_t> sizes;                                           // cells
  std::size_t empty = 0, none_opened = 0, some_opened = 0, all_opened = 0;  // each is one of these
  std::size_t shut = 0, not_cut_regular = 0, pinched = 0;
  std::map<support::MeshClass, std::size_t> meshes;

  void count(const Sample& sample) {
    sizes.push_back(sample.certificate.cell_count());
    empty += sample.asked == 0;
    none_opened += sample.asked > 0 && sample.opened == 0;
    some_opened += sample.opened > 0 && sample.opened < sample.asked;
    all_opened += sample.opened > 0 && sample.opened == sample.asked;
    shut += sample.opened < sample.asked;
    not_cut_regular += !sample.cut_regular;
    pinched += sample.pinched;
    ++meshes[sample.mesh_class];
  }
};

/// What the judges say of the mutants of a kind.
struct Tally {
  std::size_t made = 0, same = 0;  // same: up to names
  std::size_t killed_by_cpp = 0, killed_by_proofs = 0;
  std::map<Verdict, std::size_t> clauses;
};

struct Mutant {
  Mutation mutation{};
  int dimension = 0;
  bool same = false;
  std::string text;
};

class Comparison {
 public:
  Comparison(const Checker& checker, std::uint64_t seed) : checker_(checker), rng_(seed) {}

  void run(std::uint64_t pairs) {
    for (std::uint64_t first = 0; first < pairs; first += kPairsPerRun)
      compare(first, std::min<std::uint64_t>(first + kPairsPerRun, pairs));
    compare_faults(pairs);
  }

  bool print() const {
    print_kinds();
    print_mutations();
    for (const auto& [fault, counts] : faults_)
      std::cout << "malformed: " << fault << ": " << counts.second << " of " << counts.first
                << " by both\n";
    std::cout << wrong_ << " wrong\n";
    const std::vector<std::string> missing = never_met();
    for (const std::string& what : missing) std::cout << "NEVER MET: " << what << '\n';
    return wrong_ == 0 && missing.empty();
  }

 private:
  /// What the pairs must hold, and do not: they prove less without it.
  std::vector<std::string> never_met() const {
    std::vector<std::string> missing;
    const auto demand = [&](std::size_t count, const std::string& what) {
      if (count == 0) missing.push_back(what);
    };
    for (const int d : {1, 2, 3, 4}) {
      const std::string in = "D = " + std::to_string(d) + ": ";
      const Kinds kinds = at(kinds_, d);
      for (const auto mesh_class : support::kMeshClasses)
        demand(at(kinds.meshes, mesh_class), in + "meshes: " + std::string(name(mesh_class)));
      demand(kinds.empty, in + "an empty cut");
      demand(kinds.all_opened, in + "a cut that opens all");
      for (const Verdict& clause : kClauses) demand(at(at(clauses_, d), clause), in + clause);
      if (d == 1) continue;  // every facet opens, and every mesh is cut-regular
      demand(kinds.some_opened, in + "a cut that opens some");
      demand(kinds.none_opened, in + "a cut that opens nothing");
      demand(kinds.shut, in + "a facet that stays shut");
      demand(kinds.not_cut_regular, in + "a mesh that is not cut-regular");
      if (d > 2) demand(kinds.pinched, in + "a pinched simplex");
    }
    for (const Mutation mutation : kMutations) {
      const Tally tally = at(tallies_, mutation);
      demand(tally.made, "mutation: " + std::string(name(mutation)));
      if (mutation != Mutation::renamed)
        demand(tally.made - tally.same,
               "a wrong result by mutation: " + std::string(name(mutation)));
    }
    return missing;
  }

  template <class Key, class Value>
  static Value at(const std::map<Key, Value>& map, const Key& key) {
    const auto found = map.find(key);
    return found == map.end() ? Value{} : found->second;
  }

  void compare(std::uint64_t from, std::uint64_t to) {
    std::vector<Sample> samples;
    std::vector<std::string> texts;
    std::vector<Mutant> mutants;
    for (std::uint64_t n = from; n < to; ++n) {
      samples.push_back(sample(n, rng_));
      const Sample& one = samples.back();
      kinds_[one.certificate.dimension].count(one);
      texts.push_back(text_of(one.certificate));
      for (std::size_t i = 0; i < kMutationsPerPair; ++i)
        add_mutant(one, kMutations[(n / 4 * kMutationsPerPair + i) % kMutations.size()], mutants);
    }
    const auto verdicts = checker_.judged(texts);
    const auto partitions = checker_.unglued(texts);
    require(partitions.size() == texts.size(), "the checker unglues all", "");
    for (std::size_t i = 0; i < samples.size(); ++i) {
      require(judged_by_cpp(texts[i]) == "accepted", "C++ accepts its result", texts[i]);
      require(verdicts[i] == "accepted", "the checker accepts the result of C++", texts[i]);
      require(classes(partitions[i]) == classes(samples[i].certificate.after),
              "the partition is that of the proofs", texts[i]);
    }
    std::vector<std::string> mutant_texts;
    for (const Mutant& mutant : mutants) mutant_texts.push_back(mutant.text);
    const auto of_mutants = checker_.judged(mutant_texts);
    for (std::size_t i = 0; i < mutants.size(); ++i) judge(mutants[i], of_mutants[i]);
  }

  void add_mutant(const Sample& sample, Mutation mutation, std::vector<Mutant>& mutants) {
    const auto after = mutated(sample, mutation, rng_);
    if (!after) return;
    app::Certificate certificate = sample.certificate;
    const bool same = classes(*after) == classes(certificate.after);
    certificate.after = *after;
    mutants.push_back({mutation, certificate.dimension, same, text_of(certificate)});
  }

  void judge(const Mutant& mutant, const Verdict& by_proofs) {
    const Verdict by_cpp = judged_by_cpp(mutant.text);
    const std::string kind(name(mutant.mutation));
    require(by_cpp == by_proofs, kind + ": both say the same", mutant.text);
    require((by_cpp == "accepted") == mutant.same, kind + ": accepted iff it is the same",
            mutant.text);
    Tally& tally = tallies_[mutant.mutation];
    ++tally.made;
    tally.same += mutant.same;
    tally.killed_by_cpp += by_cpp != "accepted" && !mutant.same;
    tally.killed_by_proofs += by_proofs != "accepted" && !mutant.same;
    ++tally.clauses[by_proofs];
    ++clauses_[mutant.dimension][by_proofs];
  }

  void compare_faults(std::uint64_t pairs) {
    const std::array<const char*, 4> names{"a cell has a vertex twice", "a cell twice",
                                           "a facet in three cells", "a row that is no facet"};
    for (const Fault fault :
         {Fault::repeated_vertex, Fault::same_vertices, Fault::three_cells, Fault::no_facet}) {
      std::vector<std::string> texts;
      for (std::uint64_t n = 0; n < std::max<std::uint64_t>(pairs / 40, 4); ++n)
        texts.push_back(text_of(faulty(fault, static_cast<int>(n % 4) + 1, rng_)));
      const auto verdicts = checker_.judged(texts);
      auto& [made, refused] = faults_[names[static_cast<std::size_t>(fault)]];
      for (std::size_t i = 0; i < texts.size(); ++i) {
        const bool both = verdicts[i] == "malformed" && judged_by_cpp(texts[i]) == "malformed";
        require(both, "malformed for both", texts[i]);
        ++made;
        refused += both;
      }
    }
  }

  void require(bool holds, const std::string& what, const std::string& text) {
    if (holds) return;
    const std::string file = "wrong-" + std::to_string(++wrong_) + ".cert";
    if (wrong_ > 9) return;
    std::ofstream(file) << text;
    std::cout << "WRONG, see " << file << ": " << what << '\n';
  }

  void print_kinds() const {
    std::cout << "random pairs: meshes and cuts, and what is opened of the facets asked for\n"
                 "D   pairs   cells: least median most   empty cut   none   some    all   shut "
                 "facets   not cut-regular   pinched\n";
    for (auto [dimension, kinds] : kinds_) {
      std::sort(kinds.sizes.begin(), kinds.sizes.end());
      std::cout << dimension << std::setw(8) << kinds.sizes.size() << std::setw(15)
                << kinds.sizes.front() << std::setw(7) << kinds.sizes[kinds.sizes.size() / 2]
                << std::setw(5) << kinds.sizes.back() << std::setw(12) << kinds.empty
                << std::setw(7) << kinds.none_opened << std::setw(7) << kinds.some_opened
                << std::setw(7) << kinds.all_opened << std::setw(14) << kinds.shut << std::setw(18)
                << kinds.not_cut_regular << std::setw(10) << kinds.pinched << '\n';
    }
    std::cout << "meshes:";
    for (const auto& [mesh_class, count] : kinds_.begin()->second.meshes)
      std::cout << ' ' << name(mesh_class);
    std::cout << " in turn; cuts:";
    for (const auto cut_class : support::kCutClasses) std::cout << ' ' << name(cut_class);
    std::cout << " in turn\n\n";
  }

  void print_mutations() const {
    std::cout << "mutated results: `same`, up to names, accepted by both; of the others the rate "
                 "that C++ and the proofs reject\n"
              << std::left << std::setw(16) << "mutation" << std::right << std::setw(7) << "made"
              << std::setw(7) << "same" << std::setw(9) << "C++" << std::setw(9) << "proofs"
              << std::setw(10) << "cells" << std::setw(10) << "parent" << std::setw(10) << "uncut"
              << std::setw(10) << "connected" << '\n';
    for (const auto& [mutation, tally] : tallies_) {
      std::cout << std::left << std::setw(16) << name(mutation) << std::right << std::setw(7)
                << tally.made << std::setw(7) << tally.same;
      for (const std::size_t killed : {tally.killed_by_cpp, tally.killed_by_proofs})
        std::cout << std::setw(9) << rate(killed, tally.made - tally.same);
      for (const Verdict& clause : kClauses)
        std::cout << std::setw(10) << at(tally.clauses, clause);
      std::cout << '\n';
    }
    std::cout << '\n';
  }

  static std::string rate(std::size_t part, std::size_t whole) {
    if (whole == 0) return "-";
    const std::size_t tenths = 1000 * part / whole;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + "%";
  }

  const Checker& checker_;
  Rng rng_;
  std::map<int, Kinds> kinds_;
  std::map<Mutation, Tally> tallies_;
  std::map<int, std::map<Verdict, std::size_t>> clauses_;  // that mutants met, by dimension
  std::map<std::string, std::pair<std::size_t, std::size_t>> faults_;
  std::size_t wrong_ = 0;
};

}  // namespace

bool compare_pairs(const Checker& checker, std::uint64_t pairs, std::uint64_t seed) {
  Comparison comparison(checker, seed);
  comparison.run(pairs);
  return comparison.print();
}

}  // namespace cleave::proofs
