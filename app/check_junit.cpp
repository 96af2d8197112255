#include <fmt/format.h>

#include <algorithm>

#include "check_report.hpp"
#include "check_rules.hpp"
#include "file_words.hpp"
#include "xml_text.hpp"

namespace cleave::app {
namespace {

// The messages of one rule, a line each, the first `at_most` of them.
struct Messages {
  std::string text, first;
  std::size_t count = 0;

  void add(const Finding& finding, std::size_t at_most) {
    if (count == 0) first = finding.message;
    if (++count <= at_most) text += finding.message + '\n';
  }
  std::string all(std::size_t at_most) const {
    if (at_most == 0) return counted(count, "finding") + ", not shown\n";
    return count <= at_most ? text : text + fmt::format("and {} more\n", count - at_most);
  }
};

struct Suite {
  std::string cases;
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;

  void add_case(const std::string& file, std::string_view name, const std::string& content) {
    ++tests;
    cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\"", xml_text(file), name);
    cases += content.empty() ? "/>\n" : ">\n" + content + "  </testcase>\n";
  }
};

std::string outcome(const char* element, const std::string& type, const std::string& message,
                    const std::string& text) {
  return fmt::format("    <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n", element, type,
                     xml_text(message), xml_text(text));
}

void add_rule(const CheckReport& report, const Rule& rule, std::size_t at_most, Suite& suite) {
  Messages failures, others;
  for (const Finding& finding : report.findings)
    if (finding.rule == rule.name)
      (finding.severity == Severity::error ? failures : others).add(finding, at_most);
  std::string content;
  if (failures.count > 0) {
    ++suite.failures;
    content += outcome("failure", std::string(rule.name),
                       failures.count == 1
                           ? failures.first
                           : fmt::format("{} findings: {}; ..", failures.count, failures.first),
                       failures.all(at_most));
  } else if (std::find(report.undecided.begin(), report.undecided.end(), rule.name) !=
             report.undecided.end()) {
    ++suite.skipped;
    content += "    <skipped message=\"undecided until other findings are mended\"/>\n";
  }
  if (others.count > 0)
    content += fmt::format("    <system-out>{}: {}</system-out>\n",
                           counted(others.count, "warning or note", "warnings and notes"),
                           xml_text(others.all(at_most)));
  suite.add_case(report.source, rule.name, content);
}

Suite suite_of(const CheckReport& report, std::size_t at_most) {
  Suite suite;
  const bool read = report.unreadable.empty();
  suite.errors = read ? 0 : 1;
  suite.add_case(report.source, "readable",
                 read ? "" : outcome("error", "unreadable", report.unreadable, report.unreadable));
  if (read)
    for (const Rule& rule : rules()) add_rule(report, rule, at_most, suite);
  return suite;
}

}  // namespace

std::string junit_of(const std::vector<CheckReport>& reports, std::size_t at_most) {
  std::string suites;
  Suite total;
  for (const CheckReport& report : reports) {
    const Suite suite = suite_of(report, at_most);
    suites += fmt::format(
        " <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n{}"
        " </testsuite>\n",
        xml_text(report.source), suite.tests, suite.failures, suite.errors, suite.skipped,
        suite.cases);
    total.tests += suite.tests;
    total.failures += suite.failures;
    total.errors += suite.errors;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"cleave check\" tests=\"{}\" "
      "failures=\"{}\" errors=\"{}\">\n{}</testsuites>\n",
      total.tests, total.failures, total.errors, suites);
}

}  // namespace cleave::app
