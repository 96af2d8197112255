#include "files/gzip.hpp"

#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "error.hpp"

namespace cleave::app {
namespace {

/// Inflates the members of a gzip file into bytes that grow.
class Unpacking {
 public:
  Unpacking(const std::string& source, std::string_view packed, std::size_t most)
      : source_(source), packed_(packed), most_(most) {
    constexpr int kGzipOnly = 16;
    if (inflateInit2(&stream_, MAX_WBITS + kGzipOnly) != Z_OK) throw std::bad_alloc();
    constexpr std::size_t kUsualRatio = 4;
    reserve(kUsualRatio * packed.size() + 1);
  }
  Unpacking(const Unpacking&) = delete;
  Unpacking& operator=(const Unpacking&) = delete;
  ~Unpacking() { inflateEnd(&stream_); }

  OwnedBytes unpack() {
    while (at_ < packed_.size()) {
      if (packed_.substr(at_, 2) != "\x1f\x8b") fail_not_gzip();
      while (step() != Z_STREAM_END) {
      }
      inflateReset(&stream_);
    }
    return std::move(content_);
  }

 private:
  /// Room for one byte more than is allowed shows that there is too much.
  void reserve(std::size_t capacity) {
    capacity_ = std::min(capacity, most_ + 1);
    std::unique_ptr<char[]> larger(new char[capacity_]);
    if (content_.size > 0) std::memcpy(larger.get(), content_.bytes.get(), content_.size);
    content_.bytes = std::move(larger);
  }

  /// Unpacks as much as there is room for. Returns Z_OK, or Z_STREAM_END after a member.
  int step() {
    if (content_.size == capacity_) reserve(2 * capacity_);
    constexpr std::size_t kMost = std::size_t{1} << 30;  // zlib counts in 32 bits
    const std::size_t given = std::min(kMost, packed_.size() - at_);
    const std::size_t room = std::min(kMost, capacity_ - content_.size);
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed_.data() + at_));
    stream_.avail_in = static_cast<uInt>(given);
    stream_.next_out = reinterpret_cast<Bytef*>(content_.bytes.get() + content_.size);
    stream_.avail_out = static_cast<uInt>(room);
    const int result = inflate(&stream_, Z_NO_FLUSH);
    at_ += given - stream_.avail_in;
    content_.size += room - stream_.avail_out;
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    if (content_.size > most_)
      fail("unpacks to more than " + std::to_string(most_) +
           " bytes, half of this machine's memory; look whether it is what it says it is");
    if (result == Z_BUF_ERROR) fail("breaks off: the gzip data is not complete; copy it again");
    if (result != Z_OK && result != Z_STREAM_END)
      fail("is damaged: the gzip data is wrong before byte " + std::to_string(at_) +
           (stream_.msg != nullptr ? " (" + std::string(stream_.msg) + ")" : "") +
           "; copy it again");
    return result;
  }

  [[noreturn]] void fail_not_gzip() const {
    if (at_ == 0) fail("is no gzip file, as its extension says; take the extension .gz off");
    fail("goes on after the gzip data, with " + std::to_string(packed_.size() - at_) +
         " bytes that are none; cut them off");
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError("cannot read '" + source_ + "': it " + what);
  }

  const std::string& source_;
  std::string_view packed_;
  std::size_t at_ = 0, capacity_ = 0, most_;
  OwnedBytes content_;
  z_stream stream_{};
};

}  // namespace

OwnedBytes unpack_gzip(const std::string& source, std::string_view packed, std::size_t most) {
  return Unpacking(source, packed, most).unpack();
}

std::size_t most_unpacked() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  constexpr std::size_t kIfUnknown = std::size_t{1} << 32;
  if (pages <= 0 || page <= 0) return kIfUnknown;
  return static_cast<std::size_t>(pages) * static_cast<std::size_t>(page) / 2;
}

}  // namespace cleave::app
