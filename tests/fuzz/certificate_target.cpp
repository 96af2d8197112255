// A certificate, as `cleave certify` reads and judges it.
#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "certify_certificate.hpp"
#include "cleave/support/reference.hpp"
#include "error.hpp"
#include "targets.hpp"

namespace cleave::fuzz {
namespace {

using topology::Cell;
using topology::Facet;
using topology::HalfFacetId;

template <class Row>
std::vector<Row> rows(const std::vector<std::uint32_t>& numbers) {
  std::vector<Row> rows(numbers.size() / Row{}.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    rows[i / Row{}.size()][i % Row{}.size()] = {numbers[i]};
  return rows;
}

/// Whether there is something to judge, and then by Algorithm 3 whether it is right.
template <int D>
std::optional<bool> is_right(const app::Certificate& certificate) {
  const auto before = rows<Cell<D>>(certificate.before), after = rows<Cell<D>>(certificate.after);
  std::set<std::set<topology::VertexId>> distinct;
  for (const Cell<D>& cell : before)
    if (!distinct.insert({cell.begin(), cell.end()}).second ||
        std::set(cell.begin(), cell.end()).size() != cell.size())
      return std::nullopt;
  if (!support::is_pseudo_manifold<D>(before)) return std::nullopt;
  const auto facets = support::facets_of<D>(before);
  std::vector<HalfFacetId> cut;
  for (Facet<D> facet : rows<Facet<D>>(certificate.cut)) {
    std::sort(facet.begin(), facet.end());
    const auto found = facets.find(facet);
    if (found == facets.end()) return std::nullopt;
    if (found->second.size() == 2) cut.push_back(found->second.front());
  }
  return before.size() == after.size() &&
         support::same_partition<D>(support::algorithm_3<D>(before, cut), after);
}

std::optional<bool> is_right(const app::Certificate& certificate) {
  if (certificate.dimension == 1) return is_right<1>(certificate);
  if (certificate.dimension == 2) return is_right<2>(certificate);
  if (certificate.dimension == 3) return is_right<3>(certificate);
  return is_right<4>(certificate);
}

std::string written(const app::Certificate& certificate) {
  std::string text;
  app::write_certificate(certificate, [&](std::string_view some) { text += some; });
  return text;
}

void require_right_verdict(const app::CertificateFile& file) {
  const std::optional<bool> right = is_right(file.certificate());
  try {
    FUZZ_REQUIRE(right == !app::certify(file).has_value());
  } catch (const app::InputError&) {
    FUZZ_REQUIRE(!right);
  }
}

}  // namespace

void fuzz_certificate(Bytes bytes) {
  std::optional<app::CertificateFile> file;
  try {
    file.emplace(app::InputText("certificate", text_of(bytes)));
  } catch (const app::InputError&) {
    return;
  }
  const std::string text = written(file->certificate());
  const app::CertificateFile again(app::InputText("certificate", text));
  FUZZ_REQUIRE(written(again.certificate()) == text);
  FUZZ_REQUIRE(again.certificate().before == file->certificate().before);
  FUZZ_REQUIRE(again.certificate().cut == file->certificate().cut);
  FUZZ_REQUIRE(again.certificate().after == file->certificate().after);
  require_right_verdict(*file);
}

}  // namespace cleave::fuzz
