// Reading and writing of mesh files beside gmsh's reading of the same file. Seconds are of
// processor time, the median of three; gmsh's without what it takes to start. Files go to the
// folder for temporary files and are removed.
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "kuhn_cube.hpp"
#include "median.hpp"
#include "mesh_file.hpp"

namespace cleave::bench {
namespace {

using app::MshVersion;

struct Form {
  const char* name;
  const char* extension;
  app::WriteOptions options;
};

const Form kForms[] = {{"msh 4.1 text", ".msh", {MshVersion::k41, false}},
                       {"msh 4.1 binary", ".msh", {MshVersion::k41, true}},
                       {"msh 2.2 text", ".msh", {MshVersion::k22, false}},
                       {"msh 2.2 binary", ".msh", {MshVersion::k22, true}},
                       {"mesh", ".mesh", {}}};

/// A cube of n^3 boxes, its cells in one group, with coordinates of all digits.
app::Mesh cube(std::uint64_t n) {
  app::CubeSpec spec;
  spec.nodes = {n + 1, n + 1, n + 1};
  spec.size = {1, 1.1, 1.3};
  app::Mesh mesh = app::kuhn_cube(spec);
  app::Group body{"body", 3, 1, {}};
  for (std::uint32_t cell = 0; cell < mesh.cells().size(); ++cell) body.elements.push_back(cell);
  mesh.groups = {body};
  for (std::uint64_t& number : mesh.vertex_numbers) ++number;
  for (std::uint64_t& number : mesh.elements[3].numbers) ++number;
  return mesh;
}

/// The processor time of gmsh while it reads `file` and ends, in seconds; 0 if there is no gmsh.
double seconds_of_gmsh(const std::string& file) {
  const pid_t child = fork();
  if (child == 0) {
    execlp("gmsh", "gmsh", "-v", "0", "-parse_and_exit", file.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child)
    throw std::runtime_error("no process");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return 0;
  const auto of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return of(usage.ru_utime) + of(usage.ru_stime);
}

template <class Measure>
double median_of_three(Measure measure) {
  return median({measure(), measure(), measure()});
}

void files(benchmark::State& state, const Form& form) {
  const auto stem =
      std::filesystem::temp_directory_path() / ("cleave-files-bench-" + std::to_string(getpid()));
  const std::string file = stem.string() + form.extension, empty = stem.string() + ".geo";
  for (auto _ : state) {
    double write = 0;
    {
      const app::Mesh mesh = cube(static_cast<std::uint64_t>(state.range(0)));
      write = median_of_three(
          [&] { return seconds([&] { app::write_mesh(file, mesh, form.options); }); });
    }
    const double read = median_of_three(
        [&] { return seconds([&] { benchmark::DoNotOptimize(app::read_mesh(file)); }); });
    std::fclose(std::fopen(empty.c_str(), "w"));
    const double start = median_of_three([&] { return seconds_of_gmsh(empty); });
    const double gmsh = median_of_three([&] { return seconds_of_gmsh(file); }) - start;
    const auto size = static_cast<double>(std::filesystem::file_size(file));
    state.counters["MB"] = 1e-6 * size;
    state.counters["write_s"] = write;
    state.counters["read_s"] = read;
    state.counters["read_MB_per_s"] = 1e-6 * size / read;
    state.counters["gmsh_s"] = gmsh;
    state.counters["read_per_gmsh"] = gmsh > 0 ? read / gmsh : 0;
  }
  std::filesystem::remove(file);
  std::filesystem::remove(app::groups_path(file));
  std::filesystem::remove(empty);
}

const bool kRegistered = [] {
  for (const Form& form : kForms)
    benchmark::RegisterBenchmark(("files/" + std::string(form.name)).c_str(), files, form)
        ->Arg(32)
        ->Arg(100)
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
  return true;
}();

}  // namespace
}  // namespace cleave::bench
