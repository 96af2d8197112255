#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// The two programs that judge certificates: `cleave certify`, whose functions are called, and the
/// one that is extracted from the proofs, which is run.
namespace cleave::proofs {

/// "accepted", "rejected: parent", .. or "malformed".
using Verdict = std::string;

/// Of C++, on the text of one certificate.
Verdict judged_by_cpp(const std::string& text);

/// A folder that goes with its object.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path put(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

class Checker {
 public:
  explicit Checker(std::string program) : program_(std::move(program)) {}

  /// Of each of these certificates, by one run in batch mode. Throws std::runtime_error if it does
  /// not say one thing of each, or if its exit status is not that of the worst verdict.
  std::vector<Verdict> judged(const std::vector<std::string>& texts) const;

  /// Of one text, by a run of its own. Throws if its exit status is not that of the verdict.
  Verdict judged(const std::string& text) const;

  /// unglue(before, cut) of each certificate: the name of the class of each corner.
  std::vector<std::vector<std::uint32_t>> unglued(const std::filesystem::path& file) const;
  std::vector<std::vector<std::uint32_t>> unglued(const std::vector<std::string>& texts) const;

  /// What it prints and its exit status.
  std::pair<std::string, int> run(const std::string& options,
                                  const std::filesystem::path& file) const;

 private:
  std::string program_;
  Folder folder_;
};

}  // namespace cleave::proofs
