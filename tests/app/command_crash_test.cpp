// Every command that writes, with every call that changes a file failing in turn, with the process
// killed before each of them, at random times, on a full disk and on a read-only one: afterwards
// every file is the old one or the complete new one.
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "command_support.hpp"

namespace cleave::app::test {
namespace {

using Files = std::map<std::string, std::string>;  // path in the folder -> bytes

/// A command that writes, in a folder with files that an earlier one has written.
struct Scenario {
  std::string name;
  Files before;  // its input, and old output
  std::vector<std::string> args;
  std::vector<std::string> timed = {};  // reports with times in them, different in every run
  bool in_place = false;                // the output is the input
};

std::ostream& operator<<(std::ostream& out, const Scenario& scenario) {
  return out << scenario.name;
}

/// The name of a temporary file, or of one in a temporary folder.
bool is_temporary(const std::string& path) { return path.find(".cleave-") != std::string::npos; }

class Crash : public CommandTest, public testing::WithParamInterface<Scenario> {
 protected:
  Files snapshot() const {
    Files all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
      if (entry.is_regular_file()) {
        const auto name = std::filesystem::relative(entry.path(), folder_).string();
        all[name] = read(name);
      }
    return all;
  }

  void restore(const Files& files) const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      std::filesystem::remove_all(entry.path());
    for (const auto& [name, bytes] : files) {
      std::filesystem::create_directories((folder_ / name).parent_path());
      write(name, bytes);
    }
  }

  std::vector<std::string> command() const {
    std::vector<std::string> command{CLEAVE_COMMAND};
    command.insert(command.end(), GetParam().args.begin(), GetParam().args.end());
    return command;
  }

  /// Runs the scenario with this CLEAVE_FAULT. Returns the call that was hit, empty if none was.
  std::string run_with(const std::string& fault, bool named, Outcome& outcome) const {
    const std::string log = folder_.string() + ".log";
    std::vector<std::string> faulty{"env", std::string("LD_PRELOAD=") + CLEAVE_FAULT_SHIM,
                                    "ASAN_OPTIONS=verify_asan_link_order=0",
                                    "CLEAVE_FAULT_LOG=" + log, "CLEAVE_FAULT=" + fault};
    if (named) faulty.emplace_back("CLEAVE_FAULT_NAMED=1");
    const auto whole = command();
    faulty.insert(faulty.end(), whole.begin(), whole.end());
    outcome = run(faulty);
    std::string call;
    std::ifstream(log) >> call;
    std::filesystem::remove(log);
    return call;
  }

  /// Whether `bytes` is what an undisturbed run leaves; of a report with times in it: all of it.
  bool is_new(const std::string& name, const std::string& bytes) const {
    const auto expected = after_.find(name);
    if (expected == after_.end()) return false;
    const auto& timed = GetParam().timed;
    if (std::find(timed.begin(), timed.end(), name) == timed.end())
      return bytes == expected->second;
    const auto json = nlohmann::json::parse(bytes, nullptr, false);
    return json.is_object() && json.contains("schema") && bytes.back() == '\n';
  }

  void expect_new(const Files& now) const {
    for (const auto& [name, bytes] : after_) {
      const auto at = now.find(name);
      ASSERT_NE(at, now.end()) << name << " is missing";
      EXPECT_TRUE(is_new(name, at->second)) << name;
    }
    EXPECT_EQ(now.size(), after_.size());
  }

  /// Each file by itself: old, or new, or (a temporary one) to be recognised by its name.
  void expect_each_old_or_new(const Files& now) const {
    for (const auto& [name, bytes] : now) {
      const auto old = GetParam().before.find(name);
      const bool is_old = old != GetParam().before.end() && old->second == bytes;
      EXPECT_TRUE(is_old || is_temporary(name) || is_new(name, bytes)) << name << " is partial";
    }
    for (const auto& [name, bytes] : GetParam().before)
      EXPECT_TRUE(now.count(name) == 1 || after_.count(name) == 0) << name << " is lost";
  }

  static Files without_temporaries(Files files) {
    for (auto at = files.begin(); at != files.end();)
      at = is_temporary(at->first) ? files.erase(at) : std::next(at);
    return files;
  }

  void SetUp() override {
    restore(GetParam().before);
    const Outcome outcome = run(command());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    after_ = snapshot();
    ASSERT_NE(after_, GetParam().before);
  }

  Files after_;  // what an undisturbed run leaves
};

/// As many places as there are: until no call is hit any more.
constexpr int kMostCalls = 200;

TEST_P(Crash, AFailingCallLeavesEverythingOldOrEverythingNew) {
  for (const auto& [what, named] : {std::pair{std::to_string(EIO), false},
                                    {std::to_string(ENOSPC) + " on", false},
                                    {std::to_string(EDQUOT) + " on", true}}) {
    for (int n = 1;; ++n) {
      ASSERT_LT(n, kMostCalls);
      SCOPED_TRACE("call " + std::to_string(n) + ", error " + what);
      restore(GetParam().before);
      Outcome outcome;
      const std::string call = run_with(std::to_string(n) + " " + what, named, outcome);
      Files now = snapshot();
      // If a temporary name cannot be removed, nothing can be done.
      if (call == "unlink") now = without_temporaries(now);
      if (outcome.status == 0) {
        expect_new(now);
      } else {
        EXPECT_EQ(outcome.status, 3) << call << ": " << outcome.err;
        EXPECT_NE(outcome.err.find("cleave: error: cannot write "), std::string::npos)
            << outcome.err;
        EXPECT_EQ(now, GetParam().before) << call;
      }
      if (call.empty()) break;
    }
  }
}

TEST_P(Crash, AnInterruptedCallIsDoneAgain) {
  for (int n = 1;; ++n) {
    ASSERT_LT(n, kMostCalls);
    restore(GetParam().before);
    Outcome outcome;
    const std::string call =
        run_with(std::to_string(n) + " " + std::to_string(EINTR), n % 2 == 0, outcome);
    if (call == "open" || call == "write" || call == "fsync" || call.empty()) {
      EXPECT_EQ(outcome.status, 0) << call << ": " << outcome.err;
      expect_new(snapshot());
    }
    if (call.empty()) break;
  }
}

TEST_P(Crash, AKilledProcessLeavesNoPartialFile) {
  for (const bool named : {false, true}) {
    for (int n = 1;; ++n) {
      ASSERT_LT(n, kMostCalls);
      SCOPED_TRACE("killed before call " + std::to_string(n) + (named ? ", named" : ""));
      restore(GetParam().before);
      Outcome outcome;
      const std::string call = run_with(std::to_string(n) + " kill", named, outcome);
      EXPECT_EQ(outcome.status, call.empty() ? 0 : 128 + SIGKILL) << outcome.err;
      const Files now = snapshot();
      expect_each_old_or_new(now);
      if (call.empty()) break;
      if (GetParam().in_place && now != GetParam().before) continue;
      EXPECT_EQ(run(command()).status, 0);  // and the next run is none the worse
      expect_new(without_temporaries(snapshot()));
      for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
        EXPECT_FALSE(entry.is_directory() && is_temporary(entry.path().filename().string()))
            << entry.path() << ": the folder of a killed run goes with the next one";
    }
  }
}

TEST_P(Crash, AProcessKilledAtAnyTimeLeavesNoPartialFile) {
  std::mt19937 random(20001126);
  for (int i = 0; i < 12; ++i) {
    restore(GetParam().before);
    const int child = start(command());
    usleep(static_cast<useconds_t>(random() % 60000));
    kill(child, SIGKILL);
    finish(child);
    expect_each_old_or_new(snapshot());
  }
}

const char* const kScene = R"({"mesh": {"cube": {"nodes": [3, 3, 3], "size": [1, 1, 1]}},
  "material": {"young": 1000, "poisson": 0.3},
  "supports": [{"where": {"box": [[0, 0, 0], [0, 1, 1]]}, "axes": ["x", "y", "z"], "value": 0}],
  "loads": [{"where": {"box": [[1, 0, 0], [1, 1, 1]]}, "force": [1, 0, 0]}],
  "strokes": [{"blade": [[[0.4, -1, -1], [0.4, -1, 2]], [[0.4, 0.6, -1], [0.4, 0.6, 2]]]}],
  "solve": {}, "output": {"vtu": true, "frames": "final"}})";

/// Two tetrahedra that share a vertex and no more.
std::string touching_tetrahedra() {
  return medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {},
               {{1, 2, 3, 4, 0}, {1, 5, 6, 7, 0}});
}

std::vector<Scenario> scenarios() {
  const std::string mesh = two_tetrahedra_with_groups();
  return {
      {"CutWithNamesAndReport",
       {{"m.mesh", mesh},
        {"out.vtu", "old mesh"},
        {"out.vtu.groups.json", "old names"},
        {"report.json", "old report"}},
       {"cut", "m.mesh", "-o", "out.vtu", "--group", "7", "--json", "report.json"}},
      {"CutThatLeavesNoNames",
       {{"m.mesh", two_tetrahedra()},
        {"none.json", "{\"facets\": []}"},
        {"out.mesh", "old"},
        {"out.mesh.groups.json", "old names"}},
       {"cut", "m.mesh", "-o", "out.mesh", "--facets", "none.json"}},
      {"CutInPlace", {{"m.mesh", mesh}}, {"cut", "m.mesh", "-o", "m.mesh", "--all"}, {}, true},
      {"Check",
       {{"m.mesh", mesh}, {"report.json", "old"}},
       {"check", "m.mesh", "--json", "report.json"}},
      {"Reduce",
       {{"m.mesh", touching_tetrahedra()}, {"out.mesh", "old mesh"}},
       {"reduce", "m.mesh", "-o", "out.mesh"}},
      {"Run",
       {{"s.json", kScene},
        {"out/summary.json", "old"},
        {"out/final.vtu", "old"},
        {"out/mine.txt", "not Cleave's"}},
       {"run", "s.json", "-o", "out"},
       {"out/summary.json"}},
      {"RunIntoANewFolder",
       {{"s.json", kScene}},
       {"run", "s.json", "-o", "new/folder"},
       {"new/folder/summary.json"}},
  };
}

INSTANTIATE_TEST_SUITE_P(Commands, Crash, testing::ValuesIn(scenarios()),
                         [](const auto& each) { return each.param.name; });

class Disk : public CommandTest {
 protected:
  /// Runs shell commands as root of a mount namespace of their own, with a small disk at ./disk.
  Outcome with_disk(const std::string& size, const std::string& script) const {
    std::filesystem::create_directory(folder_ / "disk");
    const std::string mount = "mount -t tmpfs -o size=" + size + " none disk || exit 77\n";
    const std::string cleave = "cleave() { " CLEAVE_COMMAND " \"$@\"; }\n";
    std::vector<std::string> unshare{"unshare", "--mount"};
    if (geteuid() != 0) unshare.emplace_back("--map-root-user");
    for (const std::string& word : {std::string("sh"), std::string("-c"), mount + cleave + script})
      unshare.push_back(word);
    return run(unshare);
  }
};

#define SKIP_WITHOUT_MOUNT(outcome)                                                   \
  if ((outcome).status == 77 || (outcome).err.find("unshare") != std::string::npos || \
      (outcome).status == 127)                                                        \
  GTEST_SKIP() << "nothing can be mounted here: " << (outcome).err

TEST_F(Disk, WhatDoesNotFitLeavesTheOldFileAndNothingElse) {
  const Outcome outcome = with_disk("64k", R"(
    echo old > disk/out.msh
    cleave cut )" + data("fault.msh") + R"( -o disk/out.msh --all --quiet; echo status $?
    cat disk/out.msh; ls -A disk)");
  SKIP_WITHOUT_MOUNT(outcome);
  EXPECT_EQ(outcome.out, "status 3\nold\nout.msh\n");
  EXPECT_NE(outcome.err.find("No space left on device; free some space"), std::string::npos)
      << outcome.err;
}

TEST_F(Disk, AReadOnlyOneIsLeftAlone) {
  write("m.mesh", two_tetrahedra());
  write("s.json", kScene);
  const Outcome outcome = with_disk("64k", R"(
    echo old > disk/out.mesh; mkdir disk/run; mount -o remount,ro none disk || exit 77
    cleave cut m.mesh -o disk/out.mesh --all; echo status $?
    cleave cut m.mesh -o disk/new.mesh --all; echo status $?
    cleave check m.mesh --quiet --json disk/report.json; echo status $?
    cleave run s.json -o disk/run --quiet; echo status $?
    cat disk/out.mesh; ls -A disk disk/run)");
  SKIP_WITHOUT_MOUNT(outcome);
  EXPECT_EQ(outcome.out,
            "status 3\nstatus 3\nstatus 3\nstatus 3\nold\ndisk:\nout.mesh\nrun\n\ndisk/run:\n");
  EXPECT_NE(outcome.err.find("Read-only file system"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace cleave::app::test
