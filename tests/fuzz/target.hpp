#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace cleave::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Returns if the program treats the input as promised, aborts otherwise. libFuzzer calls it with
/// inputs it makes up, replay_main.cpp with the files of the corpus.
struct Target {
  std::string_view name;
  void (*run)(Bytes);
};

/// All targets there are.
std::span<const Target> targets();

/// The one of this name; null if there is none.
const Target* find_target(std::string_view name);

/// Says on stderr what does not hold and where, and aborts. Not an assertion of GoogleTest:
/// libFuzzer reports a crash and keeps the input.
[[noreturn]] void violated(const char* what, const char* file, int line,
                           const std::string& detail = {});

/// A folder of this process, under TMPDIR, that goes at its end.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path path(const std::string& name) const { return path_ / name; }

  /// Writes the file, which is replaced if it is there.
  std::filesystem::path put(const std::string& name, std::string_view bytes) const;

  /// Removes all that is in the folder.
  void clear() const;

  /// Writes the files that an input stands for: up to the first line "==> SUFFIX <==" the file
  /// `name`, then one file STEM + SUFFIX (or NAME + SUFFIX, for a suffix that starts with '+') per
  /// such line. A suffix is a dot and letters, so that every file is in the folder. Returns the
  /// path of `name`.
  std::filesystem::path put_all(const std::string& name, std::string_view input) const;

 private:
  std::filesystem::path path_;
};

inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace cleave::fuzz

#define FUZZ_REQUIRE(condition) \
  ((condition) ? static_cast<void>(0) : ::cleave::fuzz::violated(#condition, __FILE__, __LINE__))
