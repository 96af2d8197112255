#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_text.hpp"

/// A cut and its result as plain numbers, for anyone to judge: docs/certificate.md.
namespace cleave::app {

struct Certificate {
  /// Vertices are numbers up to this one, however many bits ids have.
  static constexpr std::uint32_t kGreatest = 4294967295;

  int dimension = 0;
  std::vector<std::uint32_t> before, after;  // dimension+1 vertices per cell
  std::vector<std::uint32_t> cut;            // dimension vertices per facet

  std::size_t cell_count() const { return before.size() / corners(); }
  std::size_t facet_count() const { return cut.size() / facet_size(); }
  std::size_t corners() const { return facet_size() + 1; }
  std::size_t facet_size() const { return static_cast<std::size_t>(dimension); }
};

/// Hands the text of a certificate to `put`, some at a time.
void write_certificate(const Certificate& certificate,
                       const std::function<void(std::string_view)>& put);

/// A certificate as it was read.
class CertificateFile {
 public:
  /// Throws InputError (file, line, what) for everything that is not a certificate word for word,
  /// and for dimensions that are not 1 to 4. What the numbers mean is not its business. Time and
  /// memory: linear in the text, whatever counts it claims.
  explicit CertificateFile(InputText text);

  const Certificate& certificate() const { return certificate_; }

  /// Throws InputError with the line of this cell of `before`, or of this facet of the cut.
  [[noreturn]] void fail_at_cell(std::size_t cell, const std::string& message) const;
  [[noreturn]] void fail_at_facet(std::size_t facet, const std::string& message) const;

 private:
  [[noreturn]] void fail_at_word(std::size_t word, const std::string& message) const;

  InputText text_;
  Certificate certificate_;
};

}  // namespace cleave::app
