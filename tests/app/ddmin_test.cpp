#include "ddmin.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace cleave::app::test {
namespace {

using Items = std::vector<int>;

Items first(int n) {
  Items items(static_cast<std::size_t>(n));
  std::iota(items.begin(), items.end(), 0);
  return items;
}

bool has(const Items& items, int wanted) {
  return std::find(items.begin(), items.end(), wanted) != items.end();
}

TEST(Ddmin, FindsTheItemsThatMatterInTheirOrder) {
  const auto fails = [](const Items& some) {
    return has(some, 3) && has(some, 77) && has(some, 78);
  };
  EXPECT_EQ(ddmin(first(100), fails), (Items{3, 77, 78}));
}

TEST(Ddmin, NeedsNothingIfNothingFails) {
  EXPECT_EQ(ddmin(first(10), [](const Items&) { return true; }), Items{});
  EXPECT_EQ(ddmin(Items{}, [](const Items&) { return true; }), Items{});
}

TEST(Ddmin, KeepsEverythingThatIsNeeded) {
  EXPECT_EQ(ddmin(first(17), [](const Items& some) { return some.size() == 17; }), first(17));
  EXPECT_EQ(ddmin(first(1), [](const Items& some) { return some.size() == 1; }), first(1));
}

TEST(Ddmin, AsksFewQuestionsForOneItemOfMany) {
  int asked = 0;
  const auto fails = [&](const Items& some) {
    ++asked;
    return has(some, 61234);
  };
  EXPECT_EQ(ddmin(first(100000), fails), Items{61234});
  EXPECT_LE(asked, 1 + 2 * 17);
}

// Whatever the question is, no single item can be left out of the answer.
TEST(Ddmin, IsOneMinimalForQuestionsThatAreNotMonotone) {
  for (int modulus = 2; modulus < 12; ++modulus)
    for (int n = 1; n < 60; ++n) {
      const Items all = first(n);
      const int wanted = std::accumulate(all.begin(), all.end(), 1) % modulus;
      const auto fails = [&](const Items& some) {
        return std::accumulate(some.begin(), some.end(), 1) % modulus == wanted &&
               (has(some, n / 2) || some.size() > 5);
      };
      ASSERT_TRUE(fails(all));
      const Items least = ddmin(all, fails);
      ASSERT_TRUE(fails(least));
      for (std::size_t i = 0; i < least.size(); ++i) {
        Items fewer = least;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        ASSERT_FALSE(fails(fewer)) << "modulus " << modulus << ", " << n << " items";
      }
    }
}

}  // namespace
}  // namespace cleave::app::test
