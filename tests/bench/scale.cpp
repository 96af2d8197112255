// How far the core goes: Kuhn cubes that double in size, up to 200 million tetrahedra unless the
// command line says how many millions. Each is checked up to manifold, assembled, cut along five
// planes (a million facets in the largest) and stitched again; a table says what that costs and by
// which factor the time per tetrahedron, or facet, grows from row to row: linear is 1.
#include <malloc.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cleave/support/heap.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/incision.hpp"
#include "median.hpp"

namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace) nothing else is measured here

constexpr double kMillion = 1e6;
constexpr std::size_t kPlanes = 5;

/// A bar on one line of stderr, if that is a terminal; Ctrl-C ends the program and wipes it.
class Bar {
 public:
  explicit Bar(double work) : work_(work), shown_(isatty(STDERR_FILENO) == 1) {
    if (!shown_) return;
    struct sigaction wiping {};
    wiping.sa_handler = wipe_and_die;
    wiping.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &wiping, nullptr);
  }
  ~Bar() { wipe(); }
  Bar(const Bar&) = delete;
  Bar& operator=(const Bar&) = delete;

  void stage(const std::string& what) {
    if (!shown_) return;
    const double part = std::min(1.0, done_ / work_);
    const std::string full(static_cast<std::size_t>(24 * part), '#');
    std::fprintf(stderr, "\r\x1b[K[%-24s] %3.0f %% %s", full.c_str(), 100 * part, what.c_str());
  }
  void advance(double work) { done_ += work; }
  void wipe() const {
    if (shown_) std::fputs("\r\x1b[K", stderr);
  }

 private:
  static void wipe_and_die(int signal) {
    constexpr std::array<char, 4> kWipe = {'\r', '\x1b', '[', 'K'};
    if (write(STDERR_FILENO, kWipe.data(), kWipe.size()) >= 0) raise(signal);
    _exit(128 + signal);
  }

  double work_, done_ = 0;
  bool shown_;
};

/// The box of n x n x n cubes, six tetrahedra each, all positively oriented; cubes in the order of
/// their coordinates, z fastest.
struct Cube {
  std::size_t n;

  std::size_t cells() const { return 6 * n * n * n; }
  std::size_t first_cell(std::size_t x, std::size_t y, std::size_t z) const {
    return 6 * ((x * n + y) * n + z);
  }
  std::size_t plane(VertexId v) const { return v.value / ((n + 1) * (n + 1)); }  // its x

  CellSoup<3> soup() const {
    const std::array<std::size_t, 3> step{(n + 1) * (n + 1), n + 1, 1};
    // The orders of the axes on the way from the least to the greatest vertex of a cube. Of an odd
    // order the last two vertices change places.
    constexpr std::array<std::array<std::size_t, 3>, 6> kEvenThenOdd{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
    CellSoup<3> made;
    made.vertex_count = (n + 1) * (n + 1) * (n + 1);
    made.cells.reserve(cells());
    for (std::size_t cube = 0; cube < n * n * n; ++cube)
      for (std::size_t order = 0; order < 6; ++order) {
        std::size_t at = cube / (n * n) * step[0] + cube / n % n * step[1] + cube % n;
        Cell<3> cell{VertexId{static_cast<Index>(at)}};
        for (std::size_t i = 0; i < 3; ++i)
          cell[i + 1] = {static_cast<Index>(at += step[kEvenThenOdd[order][i]])};
        if (order >= 3) std::swap(cell[2], cell[3]);
        made.cells.push_back(cell);
      }
    return made;
  }

  /// The facets in the planes that divide the box into kPlanes + 1 slices.
  std::vector<HalfFacetId> facets_in_planes(const Complex<3>& k) const {
    std::vector<HalfFacetId> facets;
    facets.reserve(kPlanes * 2 * n * n);
    for (std::size_t p = 1; p <= kPlanes; ++p) {
      const std::size_t x = p * n / (kPlanes + 1);
      for (std::size_t c = first_cell(x, 0, 0); c < first_cell(x + 1, 0, 0); ++c) {
        const CellId cell{static_cast<Index>(c)};
        int off_plane = -1, count = 0;
        for (int i = 0; i < 4; ++i)
          if (plane(k.vertices(cell)[static_cast<std::size_t>(i)]) != x) off_plane = i, ++count;
        if (count == 1) facets.push_back(half_facet<3>(cell, off_plane));
      }
    }
    return facets;
  }
};

/// What one step took: processor time, and the most memory it held above `before`, in bytes.
struct Cost {
  double seconds = 0;
  std::size_t peak = 0;
};

template <class Step>
Cost cost_of(Step step) {
  support::forget_heap_peak();
  const double taken = seconds(step);
  return {taken, support::heap_peak()};
}

struct Measured {
  std::size_t cells = 0, facets = 0, held = 0;
  Cost check, assemble, cut, stitch;

  std::size_t peak() const { return std::max({check.peak, assemble.peak, cut.peak, stitch.peak}); }
};

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

Measured measure(const Cube& cube, Bar& bar) {
  Measured measured;
  measured.cells = cube.cells();
  const auto cells = static_cast<double>(cube.cells());
  const auto stage = [&](const char* what, double part) {
    bar.stage(std::to_string(static_cast<int>(cells / kMillion)) + " million: " + what);
    bar.advance(part * cells);
  };
  stage("making", 0.1);
  CellSoup<3> soup = cube.soup();
  stage("checking", 0.5);
  bool sound = false;
  measured.check = cost_of([&] { sound = check(soup, Level::manifold).empty(); });
  require(sound, "the cube is found wrong");
  stage("assembling", 0.3);
  Complex<3> k;
  measured.assemble = cost_of([&] { k = assemble(std::move(soup)); });
  measured.held = support::heap_bytes();
  stage("cutting", 0.1);
  Incision<3> incision(std::move(k));
  const FacetSet facets = incision.facets(cube.facets_in_planes(incision.complex()));
  measured.facets = facets.size();
  Relabelling change;
  measured.cut = cost_of([&] { change = incision.cut(facets); });
  require(change.opened.size() == kPlanes * 2 * cube.n * cube.n && change.shut.empty(),
          "the cut has not opened the planes");
  require(change.splits.size() == kPlanes * (cube.n + 1) * (cube.n + 1),
          "the cut has not split the vertices in the planes");
  measured.stitch = cost_of([&] { incision.stitch(facets, change); });
  require(change.merges.size() == kPlanes * (cube.n + 1) * (cube.n + 1),
          "the stitch has not merged the copies");
  return measured;
}

std::size_t available_bytes() {
  std::ifstream info("/proc/meminfo");
  std::string word;
  std::size_t kilobytes = 0;
  while (info >> word)
    if (word == "MemAvailable:" && info >> kilobytes) return 1024 * kilobytes;
  return std::numeric_limits<std::size_t>::max();  // nobody knows
}

double resident_gigabytes() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1 << 20);
}

void print_head() {
  std::printf(
      "%d-bit ids; bytes are per tetrahedron, of the peak all that is held then; x: growth of "
      "the time per tetrahedron or facet since the row above\n"
      "    tets |        check up to manifold |           assemble           |  held |   facets |"
      "        cut     |     stitch     | largest so far\n"
      "     [M] |     [s]     x [Mtet/s] peak |    [s]     x [Mtet/s]  peak  |       |          |"
      " [ns/facet]   x | [ns/facet]   x |   [GiB]\n",
      kIdBits);
}

void print_row(const Measured& now, const Measured& before) {
  const auto cells = static_cast<double>(now.cells);
  const auto facets = static_cast<double>(now.facets);
  const auto growth = [](const Cost& a, std::size_t size, const Cost& b, std::size_t size_before) {
    if (size_before == 0) return std::string("-");
    std::array<char, 32> text{};
    std::snprintf(
        text.data(), text.size(), "%.2f",
        a.seconds / static_cast<double>(size) / (b.seconds / static_cast<double>(size_before)));
    return std::string(text.data());
  };
  const auto per_tet = [&](std::size_t bytes) { return static_cast<double>(bytes) / cells; };
  const std::string check = growth(now.check, now.cells, before.check, before.cells);
  const std::string assemble = growth(now.assemble, now.cells, before.assemble, before.cells);
  const std::string cut = growth(now.cut, now.facets, before.cut, before.facets);
  const std::string stitch = growth(now.stitch, now.facets, before.stitch, before.facets);
  std::printf(
      "%8.2f | %7.2f %5s %8.1f %4.0f | %6.2f %5s %8.1f %5.0f  | %5.1f | %8zu |"
      " %8.0f %5s | %8.0f %5s | %7.2f\n",
      cells / kMillion, now.check.seconds, check.c_str(), cells / now.check.seconds / kMillion,
      per_tet(now.check.peak), now.assemble.seconds, assemble.c_str(),
      cells / now.assemble.seconds / kMillion, per_tet(now.assemble.peak), per_tet(now.held),
      now.facets, 1e9 * now.cut.seconds / facets, cut.c_str(), 1e9 * now.stitch.seconds / facets,
      stitch.c_str(), resident_gigabytes());
  std::fflush(stdout);
}

/// Cubes of which each has twice the cells of the one before it; the last has at least `most`, the
/// first about `least`.
std::vector<Cube> doubling(double least, double most) {
  std::vector<Cube> cubes;
  for (double cells = most; cells > least / 1.5 || cubes.empty(); cells /= 2)
    cubes.push_back({static_cast<std::size_t>(std::ceil(std::cbrt(cells / 6)))});
  std::reverse(cubes.begin(), cubes.end());
  return cubes;
}

int run(double least, double most) {
  const std::vector<Cube> cubes = doubling(least, most);
  double work = 0;
  for (const Cube& cube : cubes) work += static_cast<double>(cube.cells());
  Bar bar(work);
  bar.wipe();
  print_head();
  Measured before;
  for (const Cube& cube : cubes) {
    malloc_trim(0);  // so that what was held last does not count as taken
    const double wanted = before.cells == 0 ? 0
                                            : static_cast<double>(before.peak()) *
                                                  static_cast<double>(cube.cells()) /
                                                  static_cast<double>(before.cells);
    if (wanted > static_cast<double>(available_bytes())) {
      bar.wipe();
      std::fprintf(stderr,
                   "scale: the next cube needs %.1f GiB, and there are %.1f: it is left out\n",
                   wanted / (1 << 30), static_cast<double>(available_bytes()) / (1 << 30));
      return 1;
    }
    const Measured now = measure(cube, bar);
    bar.wipe();
    print_row(now, before);
    before = now;
  }
  return 0;
}

}  // namespace
}  // namespace cleave::bench

int main(int argc, char** argv) {
  const double most = argc > 1 ? std::atof(argv[1]) : 200;
  const double least = argc > 2 ? std::atof(argv[2]) : 0.4;
  if (argc > 3 || !(most > 0) || !(least > 0)) {
    std::fputs("usage: scale [MOST [LEAST]], in millions of tetrahedra; 200 and 0.4\n", stderr);
    return 2;
  }
  try {
    return cleave::bench::run(least * cleave::bench::kMillion, most * cleave::bench::kMillion);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "scale: %s\n", e.what());
    return 1;
  }
}
