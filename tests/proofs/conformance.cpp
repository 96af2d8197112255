// Lets the C++ and the checker extracted from the proofs judge the same certificates:
//
// - conformance pairs CHECKER PAIRS [SEED]: random meshes and cuts, and mutations of the results.
// - conformance texts CHECKER TEXTS [SEED]: random texts, most of them nearly certificates.
// - conformance files CHECKER FILE..: certificates of large meshes, with times.
//
// Without SEED, the environment variable CLEAVE_SEED is the seed, or else a fixed number.
// Exit status 1 if the two disagree anywhere, if a judge is wrong, or if the random ones are not of
// all the kinds that they should be; 77 if there is no CHECKER.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "conformance.hpp"

int main(int argc, char** argv) {
  using namespace cleave::proofs;
  const std::vector<std::string> args(argv + 1, argv + argc);
  const auto number = [&](std::size_t i, std::uint64_t otherwise) {
    return i < args.size() ? std::strtoull(args[i].c_str(), nullptr, 10) : otherwise;
  };
  try {
    if (args.size() >= 3) {
      if (!std::filesystem::exists(args[1])) {
        std::cout << "there is no " << args[1] << "; ./dev proofs builds it\n";
        return 77;
      }
      const Checker checker(args[1]);
      if (args[0] == "files") return compare_files(checker, {args.begin() + 2, args.end()}) ? 0 : 1;
      const char* const chosen = std::getenv("CLEAVE_SEED");
      const std::uint64_t seed =
          number(3, chosen != nullptr ? std::strtoull(chosen, nullptr, 10) : 20001126);
      std::cout << "seed " << seed << '\n';
      if (args[0] == "pairs") return compare_pairs(checker, number(2, 0), seed) ? 0 : 1;
      if (args[0] == "texts") return compare_texts(checker, number(2, 0), seed) ? 0 : 1;
    }
  } catch (const std::exception& e) {
    std::cerr << "conformance: " << e.what() << '\n';
    return 1;
  }
  std::cerr << "usage: conformance pairs|texts CHECKER COUNT [SEED]\n"
               "       conformance files CHECKER FILE..\n";
  return 2;
}
