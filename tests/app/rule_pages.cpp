// Writes the pages of docs/checks: for every rule its text, and a picture of a mesh that breaks it,
// with what the check says of that mesh. usage: app_rule_pages FOLDER
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "check_report.hpp"
#include "check_rules.hpp"
#include "finding_json.hpp"
#include "output_file.hpp"
#include "rule_examples.hpp"
#include "rule_picture.hpp"

namespace cleave::app::test {
namespace {

std::string page(const Rule& rule, const RuleExample& example, const Finding& first) {
  return fmt::format(
      "# {0}\n\nIn short: {1}.\n\n![{2}]({0}.svg)\n\n*{2}. Vertices have upright numbers, cells "
      "slanted ones; what the witness names is coloured.*\n\nWhat `cleave check` says of it:\n\n"
      "```\n{3}: {0}: {4}\n```\n\nThe witness: `{5}`\n\n{6}",
      rule.name, rule.title, example.caption, name(first.severity), first.message,
      json_of_witness(first).dump(), explanation_markdown(rule));
}

std::string contents() {
  std::string text =
      "# The rules of `cleave check`\n\n| rule | about | usually | a finding says "
      "|\n|---|---|---|---|\n";
  for (const Rule& rule : rules())
    text += fmt::format("| [{0}]({0}.md) | {1} | {2} | {3} |\n", rule.name, rule.subject,
                        name(rule.usual), rule.title);
  return text;
}

void write_pages(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const RuleExample& example : rule_examples()) {
    std::vector<Finding> findings;
    for (Finding& finding : check_mesh(example.mesh, {}).findings)
      if (finding.rule == example.rule) findings.push_back(std::move(finding));
    const Rule* rule = find_rule(example.rule);
    if (rule == nullptr || findings.empty())
      throw std::runtime_error("the example does not break " + example.rule);
    const bool arrows = example.rule == "orientation-conflict" || example.rule == "inverted-cell";
    write_file(folder / (example.rule + ".md"), page(*rule, example, findings.front()));
    write_file(folder / (example.rule + ".svg"), rule_picture(example.mesh, findings, arrows));
  }
  write_file(folder / "README.md", contents());
}

}  // namespace
}  // namespace cleave::app::test

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: app_rule_pages FOLDER\n", stderr), 2;
  cleave::app::test::write_pages(argv[1]);
  return 0;
}
