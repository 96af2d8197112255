#include "page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "page_bar.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::json;

std::string page_of(const PageData& data) {
  std::ostringstream out;
  write_page(out, data);
  return out.str();
}

/// What stands between `open` and the next `close`.
std::string between(const std::string& text, const std::string& open, const std::string& close) {
  const auto begin = text.find(open);
  EXPECT_NE(begin, text.npos) << open;
  const auto from = begin + open.size();
  return text.substr(from, text.find(close, from) - from);
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++count;
  return count;
}

Json data_of(const std::string& page) {
  return Json::parse(
      between(page, "<script type=\"application/json\" id=\"page-data\">", "</script>"));
}

/// RFC 4648, the slow way: six bits at a time.
std::string from_base64(const std::string& text) {
  static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  EXPECT_EQ(text.size() % 4, 0U);
  std::vector<bool> bits;
  for (const char c : text) {
    if (c == '=') break;
    const auto value = digits.find(c);
    EXPECT_NE(value, digits.npos) << c;
    for (int bit = 5; bit >= 0; --bit) bits.push_back((value >> bit & 1U) != 0);
  }
  std::string bytes;
  for (std::size_t i = 0; i + 8 <= bits.size(); i += 8) {
    unsigned byte = 0;
    for (std::size_t bit = 0; bit < 8; ++bit) byte = 2 * byte + (bits[i + bit] ? 1U : 0U);
    bytes += static_cast<char>(byte);
  }
  return bytes;
}

template <class Number>
std::vector<Number> numbers(const Json& base64) {
  const auto bytes = from_base64(base64.get<std::string>());
  std::vector<Number> result(bytes.size() / sizeof(Number));
  if (!result.empty()) std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

std::string file(const std::string& name) {
  std::ifstream in(std::string(CLEAVE_PAGE_ASSETS) + "/" + name, std::ios::binary);
  EXPECT_TRUE(in) << name;
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Page, TextIsEscaped) {
  auto data = bar_cut_in_two();
  data.summary = {"<img src=x onerror=alert(1)>", "a & b", "c"};
  data.states[0].label = "</script><!-- <script>";
  const auto page = page_of(data);
  EXPECT_EQ(between(page, "<title>", "</title>"), "Bar &lt;cut&gt; in two &amp; &quot;bent&quot;");
  EXPECT_NE(page.find(">&lt;img src=x onerror=alert(1)&gt;</p>"), page.npos);
  EXPECT_NE(page.find("<li>a &amp; b</li><li>c</li>"), page.npos);
  const auto json = data_of(page);
  EXPECT_EQ(json["title"], data.title);
  EXPECT_EQ(json["states"][0]["label"], "</script><!-- <script>");
  EXPECT_EQ(json["materials"][1], "right </script>");
  // Every script element there is was written by us, and is closed.
  EXPECT_EQ(occurrences(page, "<script"), 4U);
  EXPECT_EQ(occurrences(page, "</script"), 4U);
  EXPECT_EQ(occurrences(page, "<!--"), 0U);
  EXPECT_EQ(occurrences(page, "</style"), 1U);
  EXPECT_EQ(occurrences(page, "{{"), 0U);
}

TEST(Page, BytesThatAreNoTextBecomeReplacementCharacters) {
  auto data = bar_cut_in_two();
  data.materials[0] = "l\xE9vre";
  EXPECT_EQ(data_of(page_of(data))["materials"][0], "l\xEF\xBF\xBDvre");
}

TEST(Page, NeedsNothingBesideIt) {
  const auto page = page_of(bar_cut_in_two());
  const auto map =
      Json::parse(between(page, "<script type=\"importmap\">", "</script>"))["imports"];
  for (const auto& [name, address] : map.items())
    EXPECT_EQ(address.get<std::string>().rfind("data:text/javascript;base64,", 0), 0U) << name;
  for (const auto* word : {"<link", "src=", "@import", "url(", "fetch("})
    EXPECT_EQ(occurrences(page, word), 0U) << word;
}

TEST(Page, HoldsThreeAsItsPackageHasIt) {
  const auto page = page_of(bar_cut_in_two());
  const auto map =
      Json::parse(between(page, "<script type=\"importmap\">", "</script>"))["imports"];
  const auto module = [&](const std::string& name) {
    const std::string head = "data:text/javascript;base64,";
    return from_base64(map.at(name).get<std::string>().substr(head.size()));
  };
  EXPECT_EQ(module("three"), file("third_party/three/three.module.min.js"));
  EXPECT_EQ(module("three/OrbitControls.js"), file("third_party/three/OrbitControls.js"));
  EXPECT_EQ(module("cleave/main.js"), file("main.js"));
  EXPECT_NE(page.find("Copyright © 2010-2023 three.js authors"), page.npos);
}

TEST(Page, DataComeBackAsTheyWere) {
  const auto data = bar_cut_in_two();
  const auto json = data_of(page_of(data));
  EXPECT_EQ(numbers<std::uint32_t>(json["cells"]), data.states[0].cells);
  EXPECT_EQ(numbers<std::uint32_t>(json["materialOfCell"]), data.material_of_cell);
  EXPECT_EQ(numbers<std::uint64_t>(json["cellNumbers"]), data.cell_numbers);
  const auto points = numbers<float>(json["points"]);
  ASSERT_EQ(points.size(), data.points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points[i] + json["origin"][i % 3].get<double>(), data.points[i]);
  ASSERT_EQ(json["states"].size(), data.states.size());
  for (std::size_t s = 0; s < data.states.size(); ++s) {
    const auto& state = json["states"][s];
    auto cells = data.states[0].cells;
    const auto corners = numbers<std::uint32_t>(state["renamedCorners"]);
    const auto vertices = numbers<std::uint32_t>(state["theirVertices"]);
    for (std::size_t i = 0; i < corners.size(); ++i) cells[corners[i]] = vertices[i];
    EXPECT_EQ(cells, data.states[s].cells);
    EXPECT_EQ(numbers<std::uint32_t>(state["opened"]), data.states[s].opened);
    EXPECT_EQ(numbers<std::uint32_t>(state["shut"]), data.states[s].shut);
    EXPECT_EQ(state["pieces"], data.states[s].pieces);
    EXPECT_EQ(state["outcome"], data.states[s].outcome);
    if (data.states[s].displacement.empty()) {
      EXPECT_TRUE(state["displacement"].is_null());
      continue;
    }
    const auto u = numbers<float>(state["displacement"]);
    ASSERT_EQ(u.size(), data.states[s].displacement.size());
    for (std::size_t i = 0; i < u.size(); ++i)
      EXPECT_EQ(u[i], static_cast<float>(data.states[s].displacement[i]));
  }
}

TEST(Page, LaterStatesStoreOnlyWhatTheCutRenamed) {
  const auto data = bar_cut_in_two();
  const auto json = data_of(page_of(data));
  EXPECT_TRUE(numbers<std::uint32_t>(json["states"][0]["renamedCorners"]).empty());
  const auto renamed = numbers<std::uint32_t>(json["states"][1]["renamedCorners"]);
  EXPECT_GT(renamed.size(), 0U);
  EXPECT_LT(renamed.size(), data.states[0].cells.size() / 20);
}

TEST(Page, AnUnknownSampleIsAGap) {
  const auto json = data_of(page_of(bar_cut_in_two()))["solves"][0];
  EXPECT_EQ(json["iteration"].size(), 65U);
  EXPECT_EQ(json["residual"][0], 1.0);
  EXPECT_TRUE(json["energyError"][64].is_null());
  EXPECT_FALSE(json["energyError"][60].is_null());
}

TEST(Page, PlainCellNumbersAreLeftOut) {
  auto data = bar_cut_in_two();
  for (std::size_t c = 0; c < data.cell_numbers.size(); ++c) data.cell_numbers[c] = c + 1;
  EXPECT_TRUE(data_of(page_of(data))["cellNumbers"].is_null());
}

TEST(Page, SameDataSameBytes) { EXPECT_EQ(page_of(bar_cut_in_two()), page_of(bar_cut_in_two())); }

TEST(Page, PointsFarFromTheOriginKeepTheirDigits) {
  auto data = bar_cut_in_two();
  for (auto& x : data.points) x += 4.0e7;  // a 32-bit float there is only good to 4
  const auto json = data_of(page_of(data));
  const auto points = numbers<float>(json["points"]);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points[i] + json["origin"][i % 3].get<double>(), data.points[i]);
}

struct Misfit {
  const char* name;
  std::function<void(PageData&)> make;
};

class PageMisfit : public testing::TestWithParam<Misfit> {};

TEST_P(PageMisfit, IsRefusedByNameAndNothingIsWritten) {
  auto data = bar_cut_in_two();
  GetParam().make(data);
  std::ostringstream out;
  try {
    write_page(out, data);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string_view(error.what()).find(GetParam().name), std::string_view::npos)
        << error.what();
  }
  EXPECT_TRUE(out.str().empty());
}

INSTANTIATE_TEST_SUITE_P(
    Page, PageMisfit,
    testing::Values(
        Misfit{"states is empty", [](PageData& d) { d.states.clear(); }},
        Misfit{"states[0].cells is empty", [](PageData& d) { d.states[0].cells.clear(); }},
        Misfit{"states[0].cells has", [](PageData& d) { d.states[0].cells.pop_back(); }},
        Misfit{"states[0].cells[5]", [](PageData& d) { d.states[0].cells[5] = 425; }},
        Misfit{"states[2].cells has", [](PageData& d) { d.states[2].cells.resize(8); }},
        Misfit{"states[2].cells[", [](PageData& d) { d.states[2].displacement.resize(3 * 425); }},
        Misfit{"states[3].displacement has",
               [](PageData& d) { d.states[3].displacement.pop_back(); }},
        Misfit{"states[3].displacement[7]",
               [](PageData& d) { d.states[3].displacement[7] = std::nan(""); }},
        Misfit{"states[1].opened[0]", [](PageData& d) { d.states[1].opened[0] = 4 * 1536; }},
        Misfit{"states[1].shut[0]", [](PageData& d) { d.states[1].shut[0] = 4 * 1536; }},
        Misfit{"points[2]",
               [](PageData& d) { d.points[2] = std::numeric_limits<double>::infinity(); }},
        Misfit{"points[0]", [](PageData& d) { d.points[0] = 1e39; }},
        Misfit{"material_of_cell", [](PageData& d) { d.material_of_cell.pop_back(); }},
        Misfit{"material_of_cell[1]", [](PageData& d) { d.material_of_cell[1] = 2; }},
        Misfit{"cell_numbers", [](PageData& d) { d.cell_numbers.pop_back(); }},
        Misfit{"findings[1].marks[0] needs",
               [](PageData& d) { d.findings[1].marks[0].vertices.clear(); }},
        Misfit{"findings[1].marks[1].vertices[1]",
               [](PageData& d) { d.findings[1].marks[1].vertices[1] = 425; }}));

}  // namespace
}  // namespace cleave::app
