#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace cleave::app {

/// Bytes that belong to nobody else.
struct OwnedBytes {
  std::unique_ptr<char[]> bytes;
  std::size_t size = 0;
};

/// The content of a gzip file (RFC 1952): of its members, one after the other. Throws InputError if
/// it is none, breaks off, fails its checksum, is followed by something else, or unpacks to more
/// than `most` bytes; messages name `source`. Memory: at most four times the content.
OwnedBytes unpack_gzip(const std::string& source, std::string_view packed, std::size_t most);

/// What unpacked content may take: half of the machine's memory.
std::size_t most_unpacked();

}  // namespace cleave::app
