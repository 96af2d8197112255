// What the user of a huge mesh sees: a bar on a terminal and nowhere else, Ctrl-C that leaves
// nothing behind, and a message when the memory does not suffice.
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <random>

#include "command_support.hpp"
#include "kuhn_cube.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

const char* const kBlade =
    R"({"blade": [[[0.45, -1, -1], [0.45, -1, 2]], [[0.45, 2, -1], [0.45, 2, 2]]]})";
const std::string kWipe = "\r\x1b[K";

class Huge : public CommandTest {
 protected:
  Huge() {
    write_cube(24);
    write("blade.json", kBlade);
    before_ = files();
  }

  void write_cube(std::uint64_t nodes) const {
    CubeSpec spec;
    spec.nodes = {nodes, nodes, nodes};
    spec.size = {1, 1, 1};
    WriteOptions options;
    options.binary = true;
    write_mesh(folder_ / "m.msh", kuhn_cube(spec), options);
  }

  /// Runs `cleave ARGS..` on a terminal of its own, and sends it `signal` after a while if there is
  /// one; `out` is what the terminal got.
  Outcome on_terminal(const std::vector<std::string>& args, int signal = 0,
                      std::chrono::microseconds after = {}) const {
    std::vector<std::string> words{CLEAVE_COMMAND};
    words.insert(words.end(), args.begin(), args.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) {
      ::signal(SIGINT, SIG_DFL);
      if (chdir(folder_.c_str()) == 0) execv(argv[0], argv.data());
      _exit(127);
    }
    if (signal != 0) {
      usleep(static_cast<useconds_t>(after.count()));
      kill(child, signal);
    }
    Outcome outcome;
    std::array<char, 4096> block;
    for (ssize_t count = 0; (count = ::read(terminal, block.data(), block.size())) > 0;)
      outcome.out.append(block.data(), static_cast<std::size_t>(count));
    int state = 0;
    waitpid(child, &state, 0);
    close(terminal);
    outcome.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    return outcome;
  }

  static std::string after_last_wipe(const std::string& text) {
    const auto wipe = text.rfind(kWipe);
    return wipe == std::string::npos ? text : text.substr(wipe + kWipe.size());
  }

  const std::vector<std::string> cut_{"cut", "m.msh", "-o", "out.msh", "--sweep", "blade.json"};
  std::vector<std::string> before_;
};

TEST_F(Huge, ATerminalShowsABarAndWipesIt) {
  for (const auto& [args, shown] :
       {std::pair{std::vector<std::string>{"check", "m.msh"}, "checking the cells"},
        std::pair{cut_, "cutting"}}) {
    const Outcome outcome = on_terminal(args);
    EXPECT_EQ(outcome.status, 0) << outcome.out;
    EXPECT_NE(outcome.out.find(" % reading m.msh"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(shown), std::string::npos) << outcome.out;
    EXPECT_EQ(after_last_wipe(outcome.out).find("[#"), std::string::npos) << outcome.out;
  }
}

TEST_F(Huge, NothingElseShowsOne) {
  for (const std::vector<std::string>& args : {std::vector<std::string>{"check", "m.msh"}, cut_}) {
    EXPECT_EQ(cleave(args).err.find('\x1b'), std::string::npos);
    std::vector<std::string> quiet = args;
    quiet.emplace_back("--quiet");
    EXPECT_EQ(on_terminal(quiet).out.find('\x1b'), std::string::npos);
  }
}

TEST_F(Huge, CtrlCAtAnyTimeLeavesNothingBehind) {
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(on_terminal(cut_).status, 0);
  const std::vector<std::string> complete = files();
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - start);
  std::mt19937 random(20001126);
  for (int i = 0; i < 12; ++i) {
    for (const std::string& name : complete)
      if (std::find(before_.begin(), before_.end(), name) == before_.end())
        std::filesystem::remove(folder_ / name);
    const int signal = i % 3 == 0 ? SIGTERM : SIGINT;
    const std::chrono::microseconds after(random() % static_cast<unsigned>(whole.count()));
    const Outcome outcome = on_terminal(cut_, signal, after);
    if (outcome.status == 0) {
      EXPECT_EQ(files(), complete);
      continue;
    }
    EXPECT_EQ(outcome.status, 128 + signal) << outcome.out;
    EXPECT_EQ(after_last_wipe(outcome.out).find('['), std::string::npos) << outcome.out;
    // Between two renames a file may be there that the other one belongs to; none is partial.
    for (const std::string& name : files())
      EXPECT_NE(std::find(complete.begin(), complete.end(), name), complete.end()) << name;
  }
}

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CLEAVE_TEST_TAKES_ALL_ADDRESSES
#endif
#endif

TEST_F(Huge, TooLittleMemoryIsSaidAndLeavesNothingBehind) {
#ifdef CLEAVE_TEST_TAKES_ALL_ADDRESSES
  GTEST_SKIP() << "the sanitizer takes more addresses than a limit allows";
#endif
  write_cube(40);  // so that the mesh counts beside the program
  std::size_t refused = 0;
  Outcome outcome;
  for (int megabytes = 64; megabytes < 65536; megabytes += megabytes / 8) {
    outcome = run({"sh", "-c",
                   "ulimit -v " + std::to_string(megabytes * 1024) +
                       "; exec " CLEAVE_COMMAND " cut m.msh -o out.msh --sweep blade.json"});
    if (outcome.status == 0) break;
    EXPECT_EQ(files(), before_);
    if (outcome.status != 3) continue;  // the program itself did not fit, or died before main
    ++refused;
    EXPECT_NE(outcome.err.find("not enough memory"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_GT(refused, 0U);
}

}  // namespace
}  // namespace cleave::app::test
