#pragma once
#include "command_support.hpp"

namespace cleave::app::test {

/// Commands that are to be done, or refused without a trace.
class CutTest : public CommandTest {
 protected:
  using Args = std::vector<std::string>;

  void done(const Args& args) const {
    const Outcome outcome = cleave(args);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }

  void refused(const Args& args, const std::string& word) const {
    const auto before = files();
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 3) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    EXPECT_EQ(files(), before);
  }
};

/// A tetrahedron divided by a vertex inside it; three of its inner facets, around one cell, are the
/// groups 7, 8 and 9.
inline std::string star() {
  return medit({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}},
               {{1, 2, 5, 7}, {2, 4, 5, 8}, {1, 4, 5, 9}},
               {{1, 2, 3, 5, 0}, {1, 4, 2, 5, 0}, {2, 4, 3, 5, 0}, {1, 3, 4, 5, 0}});
}

}  // namespace cleave::app::test
