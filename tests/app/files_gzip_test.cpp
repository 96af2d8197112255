// Files compressed by gzip: read as what they hold, or refused with the reason.
#include <zlib.h>

#include <cstdlib>

#include "error.hpp"
#include "files/gzip.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using Gzip = Files;

/// One member of a gzip file, made by zlib.
std::string packed(const std::string& content) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string result(deflateBound(&stream, content.size()) + 32, '\0');
  std::string input = content;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

TEST_F(Gzip, EveryLineFormatIsRead) {
  for (const std::string name : {"a.mesh", "a.msh"}) {
    Mesh mesh = grouped_mesh();
    for (const bool binary : {false, true}) {
      mesh.msh_binary = binary;
      write_mesh(path(name), mesh);
      put(name + ".gz", packed(bytes(name)));
      const Mesh read = read_mesh(path(name + ".gz"));
      expect_same_content(read, mesh);  // the names in a.mesh.groups.json too
      EXPECT_EQ(read.source, path(name + ".gz").string());
    }
  }
}

TEST_F(Gzip, WhatTheProgramGzipWritesIsRead) {
  write_mesh(path("a.msh"), grouped_mesh());
  ASSERT_EQ(std::system(("gzip -k " + path("a.msh").string()).c_str()), 0);
  expect_same_content(read_mesh(path("a.msh.gz")), grouped_mesh());
}

TEST_F(Gzip, MembersAreJoined) {
  write_mesh(path("a.msh"), grouped_mesh());
  const std::string text = bytes("a.msh");
  put("b.msh.gz", packed(text.substr(0, 100)) + packed("") + packed(text.substr(100)));
  expect_same_content(read_mesh(path("b.msh.gz")), grouped_mesh());
}

TEST_F(Gzip, EveryTruncatedOrDamagedFileIsRefused) {
  write_mesh(path("a.msh"), grouped_mesh());
  const std::string text = bytes("a.msh");
  const std::string whole = packed(text);
  for (std::size_t size = 1; size < whole.size(); ++size)
    EXPECT_THROW(unpack_gzip("a", whole.substr(0, size), 1000000), InputError) << size;
  constexpr std::size_t kHeader = 10;  // time and system in it change nothing
  std::size_t refused = 0;
  for (std::size_t at = kHeader; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    try {
      const OwnedBytes content = unpack_gzip("a", damaged, 1000000);
      EXPECT_EQ(std::string_view(content.bytes.get(), content.size), text) << at;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GE(refused + kHeader + 1, whole.size()) << "only bits that fill a byte may be changed";
  expect_reading_error(put("b.msh.gz", whole.substr(0, whole.size() / 2)),
                       {"b.msh.gz", "breaks off"});
  std::string damaged = whole;
  damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 4);
  expect_reading_error(put("b.msh.gz", damaged), {"b.msh.gz", "is damaged"});
  expect_reading_error(put("b.msh.gz", whole + "more"), {"goes on", "4 bytes that are none"});
  expect_reading_error(put("b.msh.gz", text), {"no gzip file", "take the extension .gz off"});
  expect_reading_error(put("b.msh.gz", packed("")), {"b.msh.gz", "empty"});
  expect_reading_error(put("b.msh", whole), {"b.msh:1:", "a gzip archive", "add .gz"});
}

TEST_F(Gzip, WhatUnpacksToTooMuchIsRefused) {
  const std::string bomb = packed(std::string(3000000, '0'));
  ASSERT_LT(bomb.size(), 10000u);
  EXPECT_EQ(unpack_gzip("a", bomb, 3000000).size, 3000000u);
  try {
    unpack_gzip("a.msh.gz", bomb, 2999999);
    ADD_FAILURE() << "too much was unpacked";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("more than 2999999 bytes"), std::string::npos);
  }
  EXPECT_GT(most_unpacked(), std::size_t{1} << 26);
}

TEST_F(Gzip, CompressedFilesAreNotWritten) {
  try {
    write_mesh(path("a.msh.gz"), grouped_mesh());
    ADD_FAILURE() << "it was written";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a.msh' and compress it with gzip"),
              std::string::npos);
  }
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace cleave::app::test
