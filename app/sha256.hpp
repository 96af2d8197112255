#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace cleave::app {

/// SHA-256 (FIPS 180-4) of bytes as they come: what `sha256sum` prints.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void add(std::string_view bytes);

  /// Of all bytes added, in 64 hexadecimal digits. Call once, as the last thing.
  std::string hex();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// Of the bytes of a file. Throws InputError if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace cleave::app
