#include <algorithm>
#include <array>
#include <iostream>
#include <map>

#include "conformance.hpp"
#include "error.hpp"
#include "mutation.hpp"

namespace cleave::proofs {
namespace {

/// What a word is replaced by, or what is put before it.
const std::array<std::string, 30> kWords{"",           "0",
                                         "1",          "2",
                                         "7",          "007",
                                         "4294967295", "4294967296",
                                         "-1",         "+1",
                                         "0x1",        "0b1",
                                         "1_0",        "1.0",
                                         "1e2",        "99999999999999999999999",
                                         "end",        "cut",
                                         "after",      "cells",
                                         "before",     "dimension",
                                         "#",          "\n# x\n",
                                         "\n#1 2\n",   " # ",
                                         "\v",         "\r",
                                         "\t1",        "cleave-certificate"};

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;  // each with the blank or end of line behind it
  for (const char c : text) {
    if (words.empty() || words.back().back() == ' ' || words.back().back() == '\n')
      words.emplace_back();
    words.back() += c;
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word;
  return text;
}

bool is_number(const std::string& word) { return word[0] >= '0' && word[0] <= '9'; }

std::string with_other_words(const std::string& text, Rng& rng) {
  std::vector<std::string> words = words_of(text);
  const std::size_t at = rng.below(words.size()), other = rng.below(words.size());
  switch (rng.below(6)) {
    case 0:
      words[at] =
          rng.pick(std::vector<std::string>(kWords.begin(), kWords.end())) + words[at].back();
      break;
    case 1:
      words[at].insert(0, rng.pick(std::vector<std::string>(kWords.begin(), kWords.end())) + " ");
      break;
    case 2:
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 3:
      words[at] += words[at];
      break;
    case 4:
      std::swap(words[at], words[other]);
      break;
    default:
      words[at] = words[other];
  }
  return joined(words);
}

/// One vertex of the result in the place of another.
std::string with_other_result(const std::string& text, Rng& rng) {
  std::vector<std::string> words = words_of(text);
  const auto after = std::find(words.begin(), words.end(), "after\n");
  std::vector<std::size_t> vertices;
  for (auto at = after; at != words.end(); ++at)
    if (is_number(*at)) vertices.push_back(static_cast<std::size_t>(at - words.begin()));
  if (vertices.empty()) return text;
  std::string& one = words[rng.pick(vertices)];
  const std::string& other = words[rng.pick(vertices)];
  one = other.substr(0, other.size() - 1) + one.back();
  return joined(words);
}

std::string with_other_bytes(std::string text, Rng& rng) {
  const std::size_t at = rng.below(text.size());
  const std::string likely = "0123456789 \n\t\r#-+\vae";
  const char byte =
      rng.chance(0.7) ? likely[rng.below(likely.size())] : static_cast<char>(rng.below(256));
  switch (rng.below(4)) {
    case 0:
      text[at] = byte;
      break;
    case 1:
      text.insert(at, 1, byte);
      break;
    case 2:
      text.erase(at, 1 + rng.below(4));
      break;
    default:
      text.resize(rng.chance(0.5) ? at : text.size() - rng.below(std::min<std::size_t>(5, at + 1)));
  }
  return text;
}

Sample small_sample(std::uint64_t& number, Rng& rng) {
  for (;;) {
    const Sample one = sample(number++, rng);
    if (one.certificate.cell_count() <= 14) return one;
  }
}

/// How often the checker calls it a success, or a verdict, that its output could not be written.
std::size_t lost_outputs(const Checker& checker, const std::string& text) {
  const Folder folder;
  const std::filesystem::path file = folder.put("one", text);
  std::size_t wrong = 0;
  for (const std::string options : {"", "--batch", "--unglue", "--help"}) {
    const int status = checker.run(options + " >/dev/full", file).second;
    if (status == app::kBadInput) continue;
    std::cout << "WRONG: on a full disk the checker exits with " << status << ' ' << options
              << '\n';
    ++wrong;
  }
  return wrong;
}

/// What a program that cuts wrongly would write.
std::string with_mutated_result(const Sample& sample, Rng& rng) {
  app::Certificate certificate = sample.certificate;
  const Mutation mutation = kMutations[rng.below(kMutations.size())];
  if (const auto after = mutated(sample, mutation, rng)) certificate.after = *after;
  return text_of(certificate);
}

std::string nearly(const Sample& original, Rng& rng) {
  const bool wrong = rng.chance(0.5);
  std::string text = wrong ? with_mutated_result(original, rng) : text_of(original.certificate);
  for (std::size_t edits = wrong ? rng.below(2) : 1 + rng.below(2); edits > 0 && !text.empty();
       --edits) {
    const double kind = rng.unit();
    text = kind < 0.6   ? with_other_result(text, rng)
           : kind < 0.9 ? with_other_words(text, rng)
                        : with_other_bytes(text, rng);
  }
  return text;
}

}  // namespace

bool compare_texts(const Checker& checker, std::uint64_t texts, std::uint64_t seed) {
  Rng rng(seed);
  std::map<Verdict, std::size_t> verdicts{{"accepted", 0},        {"malformed", 0},
                                          {"rejected: cells", 0}, {"rejected: parent", 0},
                                          {"rejected: uncut", 0}, {"rejected: connected", 0}};
  std::uint64_t number = 0;
  std::size_t wrong = 0;
  Sample original;
  for (std::uint64_t n = 0; n < texts; ++n) {
    if (n % 10 == 0) original = small_sample(number, rng);
    const std::string text = nearly(original, rng);
    const Verdict by_proofs = checker.judged(text), by_cpp = judged_by_cpp(text);
    ++verdicts[by_proofs];
    if (by_proofs == by_cpp) continue;
    if (++wrong <= 3)
      std::cout << "WRONG: C++ says " << by_cpp << ", the checker " << by_proofs << ":\n"
                << text << '\n';
  }
  wrong += lost_outputs(checker, text_of(original.certificate));
  std::cout << texts << " texts, nearly certificates; both judges, each in a run of its own, say";
  bool all_met = true;
  for (const auto& [verdict, count] : verdicts) {
    std::cout << "\n  " << verdict << ": " << count << (count == 0 ? "   NEVER MET" : "");
    all_met = all_met && count > 0;
  }
  std::cout << '\n' << wrong << " wrong\n";
  return wrong == 0 && all_met;
}

}  // namespace cleave::proofs
