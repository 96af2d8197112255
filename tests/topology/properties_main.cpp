// Runs the properties, then prints what they have met and fails if that leaves a gap.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <iostream>

#include "coverage.hpp"

namespace {

class CoverageTable : public ::testing::Environment {
 public:
  void TearDown() override {
    const auto& table = cleave::topology::coverage();
    const auto& params = rc::detail::configuration().testParams;
    std::cout << "\nRapidCheck: seed=" << params.seed << " max_success=" << params.maxSuccess
              << "\n\n";
    table.print(std::cout);
    for (const std::string& gap : table.gaps()) ADD_FAILURE() << gap;
  }
};

}  // namespace

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ::testing::AddGlobalTestEnvironment(new CoverageTable);  // GoogleTest takes ownership
  return RUN_ALL_TESTS();
}
