#pragma once
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

/// The command `cleave` as users meet it: a process with a folder of its own.
namespace cleave::app::test {

struct Outcome {
  int status = -1;  // exit status; 128 + n if signal n ended the process
  std::string out, err;
};

/// Every test runs in an empty folder, which goes with it.
class CommandTest : public testing::Test {
 protected:
  CommandTest();
  ~CommandTest() override;

  /// Runs `cleave ARGS..` in the folder.
  Outcome cleave(const std::vector<std::string>& args) const;

  /// Runs another program, found on PATH, in the folder.
  Outcome run(const std::vector<std::string>& command) const;

  /// The same in two parts: `start` returns the process, `finish` waits for its end. One at a time.
  int start(const std::vector<std::string>& command) const;
  Outcome finish(int child) const;

  /// Writes a file into the folder.
  void write(const std::string& name, const std::string& text) const;

  /// The bytes of a file in the folder; fails the test if there is none.
  std::string read(const std::string& name) const;

  /// What is in the folder, sorted.
  std::vector<std::string> files() const;

  /// A file of the project's data folder.
  static std::string data(const std::string& name);

  std::filesystem::path folder_;
};

using Point = std::array<double, 3>;
using Tuple = std::vector<int>;

/// A Medit file. Vertices are numbered from 1; a triangle's or tetrahedron's last entry is its
/// reference.
std::string medit(const std::vector<Point>& points, const std::vector<Tuple>& triangles,
                  const std::vector<Tuple>& tetrahedra);

/// Two tetrahedra on the facet (1 2 3), apices 4 and 5.
std::string two_tetrahedra();

/// The same with the common facet in group 7 and the facet (1 2 4) in group 8.
std::string two_tetrahedra_with_groups();

/// A strip of n boxes of two triangles each; closed to a Moebius band if `twisted`, to an annulus's
/// shape otherwise. Coordinates are on a circle, the band's width along z.
std::string band(int n, bool twisted);

/// A closed ring of n prisms of three tetrahedra each whose ends are identified with a reflection,
/// so that no orientation exists. n >= 5.
std::string solid_band(int n);

/// The suspension of an annulus: cells around its two apices form one part each, but the link of an
/// apex is an annulus, so that it is cut-regular and no manifold.
std::string suspended_annulus();

/// A solid torus, some of its cells mirrored, that a Moebius band of facets, group 9, cuts through.
std::string solid_torus_with_moebius_band();

}  // namespace cleave::app::test
