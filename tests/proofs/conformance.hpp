#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "judges.hpp"

/// The comparisons. Each prints what it has met, and returns whether all is as it must be.
namespace cleave::proofs {

/// Random cuts: C++ and the checker must accept the result of C++, `unglue` of the proofs must give
/// the same partition, and both must reject every mutation that is not the same up to names, by the
/// same clause, and accept the others. Meshes that are none must be malformed for both. Every kind
/// of pair, mutation and verdict must be met.
bool compare_pairs(const Checker& checker, std::uint64_t pairs, std::uint64_t seed);

/// Small certificates with wrong results, and words and bytes changed at random: both must say the
/// same, and every verdict must be met.
bool compare_texts(const Checker& checker, std::uint64_t texts, std::uint64_t seed);

/// As for pairs, of certificates in files; prints how long each judge takes.
bool compare_files(const Checker& checker, const std::vector<std::filesystem::path>& files);

}  // namespace cleave::proofs
