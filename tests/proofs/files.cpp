#include <chrono>
#include <iomanip>
#include <iostream>

#include "certify_certificate.hpp"
#include "conformance.hpp"
#include "sample.hpp"

namespace cleave::proofs {
namespace {

template <class Action>
double seconds(Action action) {
  const auto start = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

bool compare_files(const Checker& checker, const std::vector<std::filesystem::path>& files) {
  bool all = true;
  std::cout << "     cells    cut   C++ (s)   proofs (s)   unglue of proofs (s)\n"
            << std::fixed << std::setprecision(2);
  for (const auto& path : files) {
    const app::CertificateFile file{app::InputText(path)};
    bool accepted = false, accepted_by_proofs = false, same = false;
    const double cpp =
        seconds([&] { accepted = !app::certify(app::CertificateFile(app::InputText(path))); });
    const double proofs = seconds([&] {
      accepted_by_proofs = checker.run("", path) == std::pair<std::string, int>("accepted\n", 0);
    });
    const double unglue = seconds(
        [&] { same = classes(checker.unglued(path).at(0)) == classes(file.certificate().after); });
    std::cout << std::setw(10) << file.certificate().cell_count() << std::setw(7)
              << file.certificate().facet_count() << std::setw(10) << cpp << std::setw(13) << proofs
              << std::setw(23) << unglue << "   " << path.filename().string() << ": "
              << (accepted && accepted_by_proofs && same
                      ? "accepted by both, and the partition is the same"
                      : "WRONG")
              << '\n';
    all = all && accepted && accepted_by_proofs && same;
  }
  return all && !files.empty();
}

}  // namespace cleave::proofs
