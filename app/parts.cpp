#include "parts.hpp"

#include <malloc.h>

#include <algorithm>
#include <new>

namespace cleave::app {
namespace {

// Bytes given out by malloc at this moment, in the heap and in mappings of their own.
std::int64_t heap_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<std::int64_t>(info.uordblks + info.hblkhd);
}

bool heap_is_told() {
  const std::int64_t before = heap_in_use();
  void* const block = ::operator new(1 << 20);
  const std::int64_t after = heap_in_use();
  ::operator delete(block);
  return after - before >= 1 << 20;
}

}  // namespace

Parts::Parts() : bytes_known_(heap_is_told()) {}

Parts::Booking::Booking(Parts& record, std::string_view name) : parts(record) {
  auto& all = parts.parts_;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Part& part) { return part.name == name; });
  place = static_cast<std::size_t>(found - all.begin());
  if (found == all.end()) all.push_back({std::string(name), 0, 0.0, 0});
  bytes_before = heap_in_use();
  start = std::chrono::steady_clock::now();
}

Parts::Booking::~Booking() {
  Part& part = parts.parts_[place];
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  part.seconds += elapsed.count();
  part.bytes += heap_in_use() - bytes_before;
  ++part.times;
}

}  // namespace cleave::app
