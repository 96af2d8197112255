#include "reduce_property.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <system_error>

#include "error.hpp"
#include "mesh_file.hpp"
#include "reduce_findings.hpp"
#include "temporaries.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to us

namespace cleave::app {
namespace {

// Whether `a` and `b`, findings of one rule, are about the same place.
bool same_place(const Finding& a, const Finding& b) {
  if (a.rule == "non-orientable") return true;
  if (a.rule == "bad-vertex-link") return a.witness == b.witness;  // the same link, too
  return a.witness.front() == b.witness.front();
}

const Finding& chosen_finding(const std::vector<Finding>& all, const std::string& rule,
                              const std::string& source) {
  std::set<std::string> rules;
  for (const Finding& finding : all) {
    if (rule.empty() ? finding.severity == Severity::error : finding.rule == rule) return finding;
    rules.insert(finding.rule);
  }
  std::string others;
  for (const std::string& name : rules) others += (others.empty() ? "" : ", ") + name;
  throw InputError(fmt::format("{}: there is nothing to reduce: `cleave check` finds {}{}", source,
                               rule.empty() ? "no error" : "nothing of rule " + rule,
                               others.empty() ? "" : "; what it finds, for --rule: " + others));
}

// The shell command for a mesh file at `path`.
std::string filled_in(const std::string& command, const std::string& path) {
  std::string quoted = "'";
  for (const char c : path) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  quoted += '\'';
  std::string result = command;
  for (std::size_t at = 0; (at = result.find("{}", at)) != std::string::npos; at += quoted.size())
    result.replace(at, 2, quoted);
  return result;
}

// Runs a shell command with no input and no output; its exit status, 128 + n if signal n ended it.
// Ctrl-C, which it gets as well, ends this process, too.
int run_shell(const std::string& command) {
  std::string shell = "sh", flag = "-c", text = command;
  char* argv[] = {shell.data(), flag.data(), text.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = posix_spawn(&child, "/bin/sh", &actions, nullptr, argv, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw OutputError("/bin/sh cannot be run: " + std::generic_category().message(error));
  int state = 0;
  while (waitpid(child, &state, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(state)) return WEXITSTATUS(state);
  if (WTERMSIG(state) == SIGINT) raise(SIGINT);
  return 128 + WTERMSIG(state);
}

// A mesh file for a command, gone when this is.
class TrialFile {
 public:
  TrialFile(const std::filesystem::path& path, const Mesh& mesh)
      : path_(path),
        groups_(groups_path(path)),
        watch_(path_.string()),
        watch_groups_(groups_.string()) {
    write_mesh(path_, mesh);
  }
  ~TrialFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    std::filesystem::remove(groups_, ignored);
  }
  TrialFile(const TrialFile&) = delete;
  TrialFile& operator=(const TrialFile&) = delete;

 private:
  std::filesystem::path path_, groups_;
  WatchedTemporary watch_, watch_groups_;
};

}  // namespace

Property finding_property(const Mesh& mesh, const std::string& rule, topology::Level required) {
  const auto known = std::make_shared<KnownFindings>(mesh, required);
  const Finding wanted = chosen_finding(known->all(), rule, mesh.source);
  Property property;
  property.what = wanted.rule + ": " + wanted.message;
  property.seed = known->cells(wanted);
  if (wanted.rule == "not-cut-regular" || wanted.rule == "pinched-edge")
    property.kept = property.seed;
  if (property.seed.empty()) {
    const auto at = known->vertices(wanted);
    const auto corners = static_cast<std::size_t>(mesh.dimension) + 1;
    const auto& tuples = mesh.cells().vertices;
    for (std::size_t i = 0; i < tuples.size(); ++i) {
      const auto cell = static_cast<Index>(i / corners);
      if (std::binary_search(at.begin(), at.end(), tuples[i]) &&
          (property.seed.empty() || property.seed.back() != cell))
        property.seed.push_back(cell);
    }
  }
  property.judge = [&mesh, known, wanted](const Candidate& candidate) {
    const auto findings = known->of(sub_mesh(mesh, candidate.cells, candidate.loose));
    bool new_rule = false;
    Judgement judgement;
    judgement.blame = known->blame(findings, new_rule);
    judgement.holds =
        !new_rule && std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
          return finding.rule == wanted.rule && same_place(finding, wanted);
        });
    return judgement;
  };
  return property;
}

Property command_property(const Mesh& mesh, const std::string& command,
                          const std::filesystem::path& out) {
  auto trial = out;
  trial.replace_filename(
      fmt::format("{}.trial-{}{}", out.stem().string(), getpid(), out.extension().string()));
  const auto status_for = [trial, text = filled_in(command, trial.string())](const Mesh& part) {
    const TrialFile file(trial, part);
    return run_shell(text);
  };
  const int wanted = status_for(mesh);
  if (wanted == 0)
    throw InputError(fmt::format(
        "{}: there is nothing to reduce: the command ends with status 0 for the whole mesh",
        mesh.source));
  Property property;
  property.what = fmt::format("the command ends with status {}", wanted);
  property.judge = [&mesh, status_for, wanted](const Candidate& candidate) {
    return Judgement{status_for(sub_mesh(mesh, candidate.cells, candidate.loose).mesh) == wanted,
                     {}};
  };
  return property;
}

}  // namespace cleave::app
