#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "check_report.hpp"
#include "check_rules.hpp"
#include "file_lines.hpp"
#include "finding_json.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;

// A path as a relative reference of RFC 3986, or as a file URI if it is not below the working
// folder. Every byte that is not unreserved is percent-encoded, whatever its encoding.
std::string uri_of(const std::string& file) {
  const std::filesystem::path path = std::filesystem::path(file).lexically_normal();
  std::error_code ignored;
  const std::filesystem::path below =
      path.is_absolute() ? path.lexically_relative(std::filesystem::current_path(ignored)) : path;
  const bool outside = below.empty() || *below.begin() == "..";
  const std::string text =
      outside ? std::filesystem::absolute(path, ignored).lexically_normal().string()
              : below.string();
  std::string uri = outside ? "file://" : "";
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    uri += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

// FNV-1a: a short name for a text that is the same everywhere.
std::string digest(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return fmt::format("{:016x}", hash);
}

// "NotCutRegular" of "not-cut-regular".
std::string camel_case(std::string_view name) {
  std::string words;
  bool start = true;
  for (const char c : name) {
    if (c != '-') words += start && c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
    start = c == '-';
  }
  return words;
}

Json descriptor(const Rule& rule) {
  return {{"id", rule.name},
          {"name", camel_case(rule.name)},
          {"shortDescription", {{"text", rule.title}}},
          {"fullDescription", {{"text", rule.meaning}}},
          {"help", {{"text", explanation(rule)}, {"markdown", explanation_markdown(rule)}}},
          {"defaultConfiguration", {{"level", name(rule.usual)}}}};
}

// The numbers of the witness by which an element can be named: cells, vertices, a facet or edge.
Json logical_locations(const Finding& finding) {
  static const std::map<std::string, std::string> kKinds = {
      {"cell", "cell"},       {"cells", "cell"},  {"vertex", "vertex"}, {"vertices", "vertex"},
      {"repeated", "vertex"}, {"node", "vertex"}, {"nodes", "vertex"}};
  Json locations = Json::array();
  const auto add = [&](const std::string& kind, const std::string& number) {
    locations.push_back(
        {{"name", number}, {"fullyQualifiedName", kind + " " + number}, {"kind", kind}});
  };
  for (const auto& [key, value] : finding.witness) {
    const auto kind = kKinds.find(key);
    if (const auto* numbers = std::get_if<std::vector<std::uint64_t>>(&value)) {
      if (kind == kKinds.end())
        add(key, fmt::format("({})", fmt::join(*numbers, " ")));  // a facet, an edge
      else
        for (const std::uint64_t number : *numbers) add(kind->second, std::to_string(number));
    } else if (const auto* number = std::get_if<std::uint64_t>(&value);
               number != nullptr && kind != kKinds.end()) {
      add(kind->second, std::to_string(*number));
    }
  }
  return locations;
}

Json location(const std::string& file) {
  Json artifact = {{"uri", uri_of(file)}};
  if (artifact["uri"].get_ref<const std::string&>().rfind("file:", 0) != 0)
    artifact["uriBaseId"] = "%SRCROOT%";
  return {{"physicalLocation", {{"artifactLocation", artifact}}}};
}

// The first cell, else the first vertex that a witness names.
struct FirstNamed {
  std::optional<std::uint64_t> cell, vertex;

  explicit FirstNamed(const Finding& finding) {
    for (const auto& [key, value] : finding.witness) {
      auto& place = key == "cell" || key == "cells" ? cell : vertex;
      if (place || !is_named(key)) continue;
      if (const auto* one = std::get_if<std::uint64_t>(&value)) place = *one;
      if (const auto* many = std::get_if<std::vector<std::uint64_t>>(&value);
          many && !many->empty())
        place = many->front();
    }
    if (cell) vertex.reset();
  }

 private:
  static bool is_named(const std::string& key) {
    return key == "cell" || key == "cells" || key == "vertex" || key == "vertices" ||
           key == "node" || key == "nodes";
  }
};

Json result(const CheckReport& report, const Finding& finding, const FileLines& lines,
            std::size_t more) {
  std::string message = finding.message;
  if (more > 0) message += fmt::format(" (and {} more like this)", more);
  Json where = location(report.source);
  const FirstNamed first(finding);
  const auto& of_kind = first.cell ? lines.cells : lines.vertices;
  const auto line = of_kind.find(first.cell ? *first.cell : first.vertex.value_or(0));
  if ((first.cell || first.vertex) && line != of_kind.end())
    where["physicalLocation"]["region"] = {{"startLine", line->second}};
  if (Json named = logical_locations(finding); !named.empty())
    where["logicalLocations"] = std::move(named);
  const Json witness = json_of_witness(finding);
  return {{"ruleId", finding.rule},
          {"ruleIndex", place_of_rule(finding.rule)},
          {"level", name(finding.severity)},
          {"message", {{"text", message}}},
          {"locations", Json::array({where})},
          {"partialFingerprints", {{"cleaveWitness/v1", digest(finding.rule + witness.dump())}}},
          {"properties", {{"witness", witness}}}};
}

void add_results(const CheckReport& report, std::size_t at_most, Json& results) {
  std::map<std::pair<std::string, Severity>, std::size_t> of_kind, given;
  std::vector<const Finding*> kept;
  std::set<std::uint64_t> cells, vertices;
  for (const Finding& finding : report.findings) {
    if (++of_kind[{finding.rule, finding.severity}] > at_most) continue;
    kept.push_back(&finding);
    const FirstNamed first(finding);
    if (first.cell) cells.insert(*first.cell);
    if (first.vertex) vertices.insert(*first.vertex);
  }
  const FileLines lines = find_lines(report.source, report.dimension, cells, vertices);
  for (const Finding* finding : kept) {
    const std::pair kind(finding->rule, finding->severity);
    const std::size_t more = ++given[kind] == at_most ? of_kind[kind] - at_most : 0;
    results.push_back(result(report, *finding, lines, more));
  }
}

}  // namespace

std::string sarif_of(const std::vector<CheckReport>& reports, std::size_t at_most) {
  Json descriptors = Json::array(), results = Json::array(), unread = Json::array();
  for (const Rule& rule : rules()) descriptors.push_back(descriptor(rule));
  for (const CheckReport& report : reports) {
    if (!report.unreadable.empty())
      unread.push_back({{"level", "error"},
                        {"message", {{"text", report.unreadable}}},
                        {"locations", Json::array({location(report.source)})}});
    add_results(report, std::max<std::size_t>(at_most, 1), results);
  }
  Json invocation = {{"executionSuccessful", unread.empty()}};
  if (!unread.empty()) invocation["toolExecutionNotifications"] = unread;
  const Json run = {
      {"tool",
       {{"driver",
         {{"name", "cleave"}, {"semanticVersion", CLEAVE_VERSION}, {"rules", descriptors}}}}},
      {"invocations", Json::array({invocation})},
      {"columnKind", "utf16CodeUnits"},
      {"results", results}};
  return text_of_json({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                       {"version", "2.1.0"},
                       {"runs", Json::array({run})}});
}

}  // namespace cleave::app
