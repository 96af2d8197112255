#include "glob.hpp"

#include <algorithm>
#include <vector>

namespace cleave::app {

bool glob_matches(std::string_view pattern, std::string_view text) {
  // reached[i]: the pattern so far matches the first i characters of the text.
  std::vector<bool> reached(text.size() + 1, false);
  reached[0] = true;
  for (std::size_t p = 0; p < pattern.size(); ++p) {
    const char c = pattern[p];
    if (c == '*') {
      const bool any = p + 1 < pattern.size() && pattern[p + 1] == '*';
      if (any) ++p;
      for (std::size_t i = 0; i < text.size(); ++i)
        if (reached[i] && (any || text[i] != '/')) reached[i + 1] = true;
      // `**/` matches nothing as well: "a/**/b" speaks of a/b too.
      if (any && p + 1 < pattern.size() && pattern[p + 1] == '/') {
        ++p;
        std::vector<bool> next(text.size() + 1, false);
        for (std::size_t i = 0; i <= text.size(); ++i)
          next[i] = reached[i] && (i == 0 || text[i - 1] == '/');
        reached.swap(next);
      }
      continue;
    }
    for (std::size_t i = text.size(); i > 0; --i)
      reached[i] = reached[i - 1] && (c == '?' ? text[i - 1] != '/' : text[i - 1] == c);
    reached[0] = false;
  }
  return reached.back();
}

bool glob_names(std::string_view pattern, const std::filesystem::path& file,
                const std::filesystem::path& folder) {
  if (pattern.substr(0, 2) == "./") pattern.remove_prefix(2);
  while (!pattern.empty() && pattern.back() == '/') pattern.remove_suffix(1);
  std::error_code ignored;
  const auto whole = [&](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
  };
  const std::filesystem::path from_folder =
      whole(file).lexically_relative(whole(folder.empty() ? "." : folder));
  std::string so_far;
  for (const std::filesystem::path& part : from_folder) {
    so_far += (so_far.empty() ? "" : "/") + part.string();
    const bool of_one_name = pattern.find('/') == std::string_view::npos;
    if (glob_matches(pattern, of_one_name ? part.string() : so_far)) return true;
  }
  return false;
}

}  // namespace cleave::app
