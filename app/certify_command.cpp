#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "certify_certificate.hpp"
#include "commands.hpp"
#include "error.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;

struct CertifyOptions {
  std::string file, json;
};

std::string json_of(const Certificate& certificate,
                    const std::optional<CertificateRejection>& rejection) {
  Json json{{"schema", "cleave-certify/1"},
            {"dimension", certificate.dimension},
            {"cells", certificate.cell_count()},
            {"cut", certificate.facet_count()},
            {"accepted", !rejection}};
  if (rejection) {
    Json corners = Json::array();
    if (rejection->clause != topology::Rejection::Clause::cells)
      for (const auto& corner : rejection->corners)
        corners.push_back(
            {{"cell", corner.cell}, {"before", corner.before}, {"after", corner.after}});
    json["rejection"] = {{"clause", topology::name(rejection->clause)},
                         {"corners", corners},
                         {"message", rejection->where}};
  }
  return json.dump(1) + "\n";
}

int judge(const CertifyOptions& options) {
  const CertificateFile file(input_at(options.file));
  const auto rejection = certify(file);
  if (!options.json.empty()) write_report(options.json, json_of(file.certificate(), rejection));
  if (options.json != "-")
    print(rejection ? fmt::format("rejected: {}: {}\n", topology::name(rejection->clause),
                                  rejection->where)
                    : "accepted\n");
  return rejection ? kFindings : kFine;
}

}  // namespace

void add_certify_command(CLI::App& cleave, Action& chosen) {
  auto* command = cleave.add_subcommand(
      "certify", "Says whether the result in a certificate is that of its cut");
  auto options = std::make_shared<CertifyOptions>();
  command
      ->add_option("FILE", options->file,
                   "What `cleave cut --certificate` wrote, or any program; - is standard input")
      ->required()
      ->option_text("FILE");
  command
      ->add_option("--json", options->json,
                   "Write the verdict as JSON to this file; - is standard output")
      ->option_text("FILE");
  command->footer(
      "Exit status: 0 accepted; 1 rejected; 2 wrong usage; 3 the file cannot be read, or is no\n"
      "certificate.\n"
      "Examples:\n"
      "  cleave cut fault.msh -o open.msh --group fault --certificate fault.cert\n"
      "  cleave certify fault.cert");
  command->callback([options, &chosen] {
    refuse_report_onto(options->json, {options->file});
    chosen = [options] { return judge(*options); };
  });
}

}  // namespace cleave::app
