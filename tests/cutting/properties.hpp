#pragma once
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cleave/support/rng.hpp>
#include <cstdint>

namespace cleave::cutting {

/// Random numbers for one run of a property. The seed is drawn from its whole range whatever the
/// run's size, and not shrunk: a neighbouring seed gives an unrelated case.
inline support::Rng any_rng() {
  const auto seed =
      *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()))
           .as("seed");
  return support::Rng(seed);
}

}  // namespace cleave::cutting
