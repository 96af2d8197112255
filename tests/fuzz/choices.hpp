#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace cleave::fuzz {

/// The bytes of an input as a sequence of decisions; when they are used up, every decision is 0, so
/// that a prefix of an input is an input.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool left() const { return at_ < bytes_.size(); }

  /// 0 .. n-1 for n of 1 .. 256: one byte.
  std::size_t below(std::size_t n) { return next() % n; }

  /// One bit, eight to a byte.
  bool bit() {
    if (bits_left_ == 0) {
      bits_ = next();
      bits_left_ = 8;
    }
    --bits_left_;
    const bool result = (bits_ & 1U) != 0;
    bits_ >>= 1U;
    return result;
  }

 private:
  unsigned next() { return left() ? bytes_[at_++] : 0U; }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  unsigned bits_ = 0;
  int bits_left_ = 0;
};

}  // namespace cleave::fuzz
