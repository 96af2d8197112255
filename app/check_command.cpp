#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>

#include "check_config.hpp"
#include "check_report.hpp"
#include "check_rules.hpp"
#include "choice.hpp"
#include "commands.hpp"
#include "error.hpp"
#include "glob.hpp"
#include "mesh_file.hpp"
#include "mesh_paths.hpp"
#include "progress.hpp"

namespace cleave::app {
namespace {

struct CheckOptions {
  std::vector<std::string> meshes, exclude, severities, explain;
  std::string config;
  bool no_config = false, list_rules = false, quiet = false;
  topology::Level required = topology::Level::cut_regular;
  CountHoles betti = CountHoles::automatic;
  SettingsChange settings;  // of these, what the command line names
  std::optional<std::size_t> max_findings;
  std::string json, sarif, junit;
};

constexpr std::size_t kShownPerRule = 20;
constexpr std::size_t kResultsPerRule = 1000;  // viewers of SARIF take some thousands in all

CheckConfig config_of(const CheckOptions& options) {
  if (!options.config.empty()) return read_check_config(options.config);
  if (options.no_config) return {};
  const auto found = find_check_config(".");
  return found ? read_check_config(*found) : CheckConfig{};
}

// Writing a report over a file that was checked would lose it.
void refuse_reports_onto_meshes(const CheckOptions& options,
                                const std::vector<std::string>& files) {
  try {
    for (const std::string& report : {options.json, options.sarif, options.junit})
      refuse_report_onto(report, files);
  } catch (const CLI::ValidationError& e) {
    throw InputError(e.what());
  }
}

void write_reports(const CheckOptions& options, const std::vector<CheckReport>& reports,
                   std::size_t at_most) {
  if (!options.json.empty()) write_report(options.json, json_of(reports));
  if (!options.sarif.empty()) write_report(options.sarif, sarif_of(reports, kResultsPerRule));
  if (!options.junit.empty()) write_report(options.junit, junit_of(reports, at_most));
}

// One file, whatever becomes of it; the exit status that it asks for.
int check_file(const std::string& path, const CheckSettings& settings, Progress& progress,
               CheckReport& report) {
  report.source = path;
  const auto failure = attempt([&] {
    progress.stage("reading " + path);
    const Mesh mesh = read_mesh(path, progress.within_stage());
    report = check_mesh(mesh, settings, &progress);
    progress.clear();
    for (const std::string& note : mesh.dropped) warn(note);
  });
  progress.clear();
  if (!failure) return report.count(Severity::error) == 0 ? kFine : kFindings;
  report.unreadable = failure->text;
  return complain(*failure);
}

int check_meshes(const CheckOptions& options) {
  const CheckConfig config = config_of(options);
  const MeshPaths paths = find_meshes(options.meshes, [&](const std::filesystem::path& file) {
    return config.excludes(file) ||
           std::any_of(options.exclude.begin(), options.exclude.end(),
                       [&](const std::string& pattern) { return glob_names(pattern, file, "."); });
  });
  refuse_reports_onto_meshes(options, paths.files);
  const std::size_t at_most =
      options.max_findings.value_or(config.max_findings.value_or(kShownPerRule));
  const bool text = options.json != "-" && options.sarif != "-" && options.junit != "-";
  std::vector<CheckReport> reports;
  int status = kFine;
  Progress progress((1 + kCheckStages) * paths.files.size(), options.quiet);
  for (const std::string& path : paths.files) {
    CheckReport& report = reports.emplace_back();
    const CheckSettings settings = config.settings_for(path, options.settings);
    status = std::max(status, check_file(path, settings, progress, report));
    if (text && report.unreadable.empty()) print(text_of(report, at_most, !options.quiet));
  }
  if (text && !options.quiet) print(closing_text(reports, paths.excluded));
  write_reports(options, reports, at_most);
  return status;
}

int explain(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    const Rule* rule = find_rule(name);
    text += (text.empty() ? "" : "\n") + explanation(*rule);
  }
  print(text);
  return kFine;
}

// "RULE=SEVERITY", one per text.
std::map<std::string, Severity> severities_of(const std::vector<std::string>& texts) {
  std::map<std::string, Severity> found;
  for (const std::string& text : texts) {
    const std::size_t sign = text.find('=');
    const std::string rule = text.substr(0, sign);
    const std::string word = sign == std::string::npos ? "" : text.substr(sign + 1);
    if (find_rule(rule) == nullptr)
      throw CLI::ValidationError(
          "--severity", fmt::format("there is no rule '{}'; rules are {}", rule, rule_names()));
    bool known = false;
    for (const Severity s : {Severity::off, Severity::note, Severity::warning, Severity::error})
      if (word == name(s)) {
        found[rule] = s;
        known = true;
      }
    if (!known)
      throw CLI::ValidationError("--severity",
                                 fmt::format("'{}' is not RULE=off, note, warning or error", text));
  }
  return found;
}

// What CLI11 cannot tell by itself.
void finish(CheckOptions& options) {
  if (options.list_rules) return;
  for (const std::string& rule : options.explain)
    if (find_rule(rule) == nullptr)
      throw CLI::ValidationError(
          "--explain", fmt::format("there is no rule '{}'; rules are {}", rule, rule_names()));
  if (!options.explain.empty()) return;
  if (options.meshes.empty()) throw CLI::RequiredError("MESH");
  options.settings.severity = severities_of(options.severities);
  const std::vector<std::string> reports = {options.json, options.sarif, options.junit};
  for (std::size_t i = 0; i < reports.size(); ++i) {
    refuse_report_onto(reports[i], options.meshes);
    for (std::size_t j = 0; j < i; ++j)
      if (!reports[i].empty() && reports[i] == reports[j])
        throw CLI::ValidationError("reports",
                                   fmt::format("two of them would be written to '{}'", reports[i]));
  }
}

std::size_t whole_number(const std::string& option, const std::string& text) {
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data(), end, number);
  if (problem != std::errc{} || rest != end)
    throw CLI::ValidationError(option, fmt::format("'{}' is not a whole number from 0 on", text));
  return number;
}

void add_reports(CLI::App& check, CheckOptions& options) {
  check.add_option("--json", options.json, "Write all findings to this file; - is standard output")
      ->option_text("FILE");
  check.add_option("--sarif", options.sarif, "Write them as SARIF 2.1.0, for code scanning")
      ->option_text("FILE");
  check.add_option("--junit", options.junit, "Write them as JUnit XML: a suite per mesh")
      ->option_text("FILE");
  check
      .add_option_function<std::string>(
          "--max-findings",
          [&options](const std::string& text) {
            options.max_findings = whole_number("--max-findings", text);
          },
          "Show this many findings of a rule and mesh (usually 20)")
      ->option_text("N");
}

void add_settings(CLI::App& check, CheckOptions& options) {
  add_choice<topology::Level>(check, "--require", options.required,
                              {{"pseudo-manifold", topology::Level::pseudo_manifold},
                               {"cut-regular", topology::Level::cut_regular},
                               {"edge-regular", topology::Level::edge_regular},
                               {"manifold", topology::Level::manifold}},
                              "What is below this level is an error, what is above it a warning: "
                              "pseudo-manifold, cut-regular (default), edge-regular or manifold")
      ->option_text("LEVEL");
  check
      .add_option("--severity", options.severities,
                  "Report findings of a rule as error, warning or note, or not at all (off); may "
                  "be repeated")
      ->allow_extra_args(false)  // what follows is a mesh
      ->option_text("RULE=SEVERITY");
  add_choice<CountHoles>(check, "--betti", options.betti,
                         {{"automatic", CountHoles::automatic},
                          {"always", CountHoles::always},
                          {"never", CountHoles::never}},
                         "Count holes: of meshes of up to about three million cells (automatic, "
                         "the default), always or never")
      ->option_text("WHEN");
  check
      .add_option("--exclude", options.exclude,
                  "Leave out files and folders whose name, or path if it has a /, matches; may be "
                  "repeated")
      ->allow_extra_args(false)
      ->option_text("GLOB");
  auto* config = check.add_option("--config", options.config,
                                  "Settings from this file instead of .cleave-check.json here or "
                                  "in a folder above");
  config->option_text("FILE");
  check.add_flag("--no-config", options.no_config, "Read no .cleave-check.json")->excludes(config);
}

}  // namespace

void add_check_command(CLI::App& cleave, Action& chosen) {
  auto* check = cleave.add_subcommand(
      "check", "Says of meshes what is wrong with them, with the witness of each finding");
  auto options = std::make_shared<CheckOptions>();
  check->add_option("MESH", options->meshes, "Mesh files, or folders with mesh files at any depth")
      ->option_text("FILE|FOLDER..");
  add_settings(*check, *options);
  add_reports(*check, *options);
  check->add_flag("--quiet", options->quiet, "No progress bar and no summary; findings only");
  check->add_flag("--rules", options->list_rules, "List all rules");
  check->add_option("--explain", options->explain, "Say what rules mean and how to mend findings")
      ->option_text("RULE..");
  check->footer(
      "Exit status: 0 no errors; 1 errors found; 2 wrong usage; 3 a file cannot be read.\n"
      "Examples:\n"
      "  cleave check liver.mesh\n"
      "  cleave check meshes/ --exclude 'draft-*' --sarif cleave.sarif\n"
      "  cleave check --explain not-cut-regular");
  check->callback([check, options, &chosen] {
    if (check->count("--require") > 0) options->settings.required = options->required;
    if (check->count("--betti") > 0) options->settings.betti = options->betti;
    finish(*options);
    chosen = [options] {
      if (options->list_rules) return print(list_of_rules()), static_cast<int>(kFine);
      return options->explain.empty() ? check_meshes(*options) : explain(options->explain);
    };
  });
}

}  // namespace cleave::app
