#include "command_support.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>

namespace cleave::app::test {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

CommandTest::CommandTest() {
  std::string name = (std::filesystem::temp_directory_path() / "cleave-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for tests");
  folder_ = name;
}

CommandTest::~CommandTest() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

Outcome CommandTest::cleave(const std::vector<std::string>& args) const {
  std::vector<std::string> command{CLEAVE_COMMAND};
  command.insert(command.end(), args.begin(), args.end());
  return run(command);
}

Outcome CommandTest::run(const std::vector<std::string>& command) const {
  return finish(start(command));
}

int CommandTest::start(const std::vector<std::string>& command) const {
  std::vector<char*> argv;
  for (const std::string& arg : command) argv.push_back(const_cast<char*>(arg.c_str()));
  argv.push_back(nullptr);
  const std::string out = folder_.string() + ".out", err = folder_.string() + ".err";
  const pid_t child = fork();
  if (child != 0) return child;
  signal(SIGINT, SIG_DFL);  // a test that runs in the background ignores it
  const int to_out = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int to_err = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (chdir(folder_.c_str()) == 0 && dup2(to_out, 1) == 1 && dup2(to_err, 2) == 2)
    execvp(argv[0], argv.data());
  _exit(127);
}

Outcome CommandTest::finish(int child) const {
  const std::string out = folder_.string() + ".out", err = folder_.string() + ".err";
  int state = 0;
  waitpid(child, &state, 0);
  Outcome outcome{WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state), content(out),
                  content(err)};
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return outcome;
}

void CommandTest::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string CommandTest::read(const std::string& name) const {
  EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name << " is missing";
  return content(folder_ / name);
}

std::vector<std::string> CommandTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string CommandTest::data(const std::string& name) { return CLEAVE_DATA "/" + name; }

std::string medit(const std::vector<Point>& points, const std::vector<Tuple>& triangles,
                  const std::vector<Tuple>& tetrahedra) {
  std::ostringstream out;
  out.precision(17);
  out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << points.size() << '\n';
  for (const Point& p : points) out << p[0] << ' ' << p[1] << ' ' << p[2] << " 0\n";
  const auto section = [&](const char* keyword, const std::vector<Tuple>& tuples) {
    if (tuples.empty()) return;
    out << keyword << '\n' << tuples.size() << '\n';
    for (const Tuple& tuple : tuples) {
      for (const int v : tuple) out << v << ' ';
      out << '\n';
    }
  };
  section("Triangles", triangles);
  section("Tetrahedra", tetrahedra);
  out << "End\n";
  return out.str();
}

namespace {

const std::vector<Point> kFivePoints{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
const std::vector<Tuple> kTwoCells{{1, 2, 3, 4, 1}, {1, 3, 2, 5, 1}};

}  // namespace

std::string two_tetrahedra() { return medit(kFivePoints, {}, kTwoCells); }

std::string two_tetrahedra_with_groups() {
  return medit(kFivePoints, {{1, 2, 3, 7}, {1, 2, 4, 8}}, kTwoCells);
}

std::string band(int n, bool twisted) {
  std::vector<Point> points;
  std::vector<Tuple> triangles;
  for (int i = 0; i < n; ++i)
    for (const double z : {0.0, 0.5})
      points.push_back({std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), z});
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i + 1, b = a + 1;
    int c = a + 2, d = a + 3;
    if (i == n - 1) {
      c = twisted ? 2 : 1;
      d = twisted ? 1 : 2;
    }
    triangles.push_back({a, b, c, 0});
    triangles.push_back({c, b, d, 0});
  }
  return medit(points, triangles, {});
}

std::string solid_band(int n) {
  std::vector<Point> points;
  std::vector<Tuple> tetrahedra;
  for (int i = 0; i < n; ++i) {
    const double x = std::cos(2 * M_PI * i / n), y = std::sin(2 * M_PI * i / n);
    points.push_back({x, y, 0});
    points.push_back({x, y, 0.5});
    points.push_back({1.5 * x, 1.5 * y, 0.25});
  }
  for (int i = 0; i < n; ++i) {
    const int a = 3 * i + 1, b = a + 1, c = a + 2;
    int d = a + 3, e = a + 4, f = a + 5;
    if (i == n - 1) {
      d = 2;  // the last triangle is the first one, two of its vertices swapped
      e = 1;
      f = 3;
    }
    tetrahedra.push_back({a, b, c, d, 0});
    tetrahedra.push_back({b, c, d, e, 0});
    tetrahedra.push_back({c, d, e, f, 0});
  }
  return medit(points, {}, tetrahedra);
}

std::string suspended_annulus() {
  constexpr int kCorners = 6;
  std::vector<Point> points{{0, 0, 1}, {0, 0, -1}};
  std::vector<Tuple> cells;
  for (const double radius : {1.0, 2.0})
    for (int i = 0; i < kCorners; ++i)
      points.push_back({radius * std::cos(2 * M_PI * i / kCorners),
                        radius * std::sin(2 * M_PI * i / kCorners), 0});
  for (int i = 0; i < kCorners; ++i) {
    const int a = 3 + i, b = 3 + (i + 1) % kCorners, c = a + kCorners, d = b + kCorners;
    for (const int apex : {1, 2}) {
      cells.push_back(apex == 1 ? Tuple{a, c, d, apex, 0} : Tuple{c, a, d, apex, 0});
      cells.push_back(apex == 1 ? Tuple{a, d, b, apex, 0} : Tuple{d, a, b, apex, 0});
    }
  }
  return medit(points, {}, cells);
}

std::string solid_torus_with_moebius_band() {
  // Section i has a centre and four corners that turn by half a turn on the way round, so that
  // corner j of the last section is corner j+2 of the first.
  constexpr int kSections = 8;
  std::vector<Point> points;
  for (int i = 0; i < kSections; ++i) {
    const double angle = 2 * M_PI * i / kSections;
    const auto add = [&](double outwards, double up) {
      points.push_back({(3 + outwards) * std::cos(angle), (3 + outwards) * std::sin(angle), up});
    };
    add(0, 0);
    for (int j = 0; j < 4; ++j)
      add(std::cos(angle / 2 + j * M_PI / 2), std::sin(angle / 2 + j * M_PI / 2));
  }
  const auto centre = [](int i) { return 5 * (i % kSections) + 1; };
  const auto corner = [&](int i, int j) {
    return centre(i) + 1 + (i == kSections ? j + 2 : j) % 4;
  };
  std::vector<Tuple> band, cells;
  for (int i = 0; i < kSections; ++i) {
    for (int j = 0; j < 4; ++j) {
      const int low = std::min(j, (j + 1) % 4), high = std::max(j, (j + 1) % 4);
      const int a = centre(i), b = corner(i, low), c = corner(i, high);
      const int d = centre(i + 1), e = corner(i + 1, low), f = corner(i + 1, high);
      cells.push_back({a, b, c, f, 0});
      cells.push_back({a, b, e, f, 0});
      cells.push_back({a, d, e, f, 0});
    }
    for (const int j : {0, 2}) {
      band.push_back({centre(i), corner(i, j), corner(i + 1, j), 9});
      band.push_back({centre(i), centre(i + 1), corner(i + 1, j), 9});
    }
  }
  return medit(points, band, cells);
}

}  // namespace cleave::app::test
