#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "progress.hpp"

namespace cleave::app {

/// Gives bytes back to where they are from.
struct ReleaseBytes {
  std::size_t mapped = 0;  // so many are mapped; 0: they were made by new
  void operator()(char* bytes) const;
};

/// A whole text file in memory, with messages that name the file and the line. Nothing counts
/// lines while reading; a message does, from the place it speaks of.
class InputText {
 public:
  /// A file whose extension is `.gz` is unpacked, and lines are those of its content. Throws
  /// InputError if the file is missing, a folder, unreadable or empty, or no good gzip file (see
  /// unpack_gzip).
  /// Regular files are mapped, so that they take no memory that others need; `how_far` is told how
  /// far reading has come.
  explicit InputText(const std::filesystem::path& path, HowFar how_far = {});

  /// For text that is already in memory; `source` is the name messages quote.
  InputText(std::string source, std::string_view bytes);

  const std::string& source() const { return source_; }
  std::string_view bytes() const { return {bytes_.get(), size_}; }
  const char* begin() const { return bytes_.get(); }
  const char* end() const { return bytes_.get() + size_; }

  /// Readers say where they are, when they have passed the place that they were given the last time
  /// (at first, any); returns the next such place.
  const char* passed(const char* place) const;

  /// "SOURCE:LINE" for the line that `place`, a position in bytes(), is on; "SOURCE: byte OFFSET"
  /// if there is binary data, a zero byte, before it.
  std::string where(const char* place) const;

  /// Throws InputError("where(place): message").
  [[noreturn]] void fail(const char* place, const std::string& message) const;

  /// Throws InputError for content that is not of the `expected` format, and says what it looks
  /// like instead.
  [[noreturn]] void fail_format(const std::string& expected) const;

 private:
  void map(int descriptor, std::size_t size);

  std::string source_;
  std::unique_ptr<char[], ReleaseBytes> bytes_;
  std::size_t size_ = 0;
  HowFar how_far_;
};

/// The text of a file, or of standard input for the name "-". Throws InputError.
InputText input_at(const std::filesystem::path& path);

/// True if the extension of `path` is `.gz` or `.GZ`.
bool is_gzip_name(const std::filesystem::path& path);

/// Throws InputError if there is no file that can be read and has content at `path`; for readers
/// that do the reading themselves. Returns its size in bytes.
std::size_t require_readable_file(const std::filesystem::path& path);

/// Text from a file as a message may show it: control characters replaced, at most `longest` bytes.
std::string printable(std::string_view text, std::size_t longest = 200);

/// What the first bytes of a file look like: "an XML file", "binary data", ...; empty if unknown.
std::string_view describe_content(std::string_view bytes);

}  // namespace cleave::app
