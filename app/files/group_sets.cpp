#include "files/group_sets.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <string>
#include <system_error>

namespace cleave::app {
namespace {

/// Drops the sets no element has, which were steps on the way to larger ones. The empty set stays.
void drop_unused(GroupSets& all) {
  std::vector<std::uint32_t> renamed(all.sets.size(), 0);
  for (const std::uint32_t set : all.of_element) renamed[set] = 1;
  std::size_t kept = 1;
  for (std::size_t s = 1; s < all.sets.size(); ++s) {
    if (renamed[s] == 0) continue;
    renamed[s] = static_cast<std::uint32_t>(kept);
    if (kept != s) all.sets[kept] = std::move(all.sets[s]);
    ++kept;
  }
  renamed[0] = 0;
  all.sets.resize(kept);
  for (std::uint32_t& set : all.of_element) set = renamed[set];
}

}  // namespace

GroupSets group_sets(std::size_t count, const std::vector<Group>& groups) {
  GroupSets result;
  result.of_element.assign(count, 0);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::map<std::uint32_t, std::uint32_t> with_g;  // a set and the same one with group g
    for (const Index element : groups[g].elements) {
      std::uint32_t& set = result.of_element[element];
      const auto [known, is_new] = with_g.try_emplace(set, 0);
      if (is_new) {
        known->second = static_cast<std::uint32_t>(result.sets.size());
        auto larger = result.sets[set];
        larger.push_back(g);
        result.sets.push_back(std::move(larger));
      }
      set = known->second;
    }
  }
  drop_unused(result);
  return result;
}

std::vector<Group> groups_of(const Mesh& mesh, int dimension) {
  std::vector<Group> result;
  for (const Group& group : mesh.groups)
    if (group.dimension == dimension) result.push_back(group);
  return result;
}

std::vector<std::int32_t> distinct_tags(const std::vector<Group>& groups, std::int32_t least) {
  std::vector<std::int32_t> tags(groups.size(), 0);
  std::set<std::int32_t> used;
  const auto keeps = [&](std::size_t g) {
    const std::int32_t tag = groups[g].tag;
    return tag != 0 && tag >= least && used.insert(tag).second;
  };
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (keeps(g)) tags[g] = groups[g].tag;
  std::int32_t next = 1;
  for (std::int32_t& tag : tags) {
    if (tag != 0) continue;
    while (!used.insert(next).second) ++next;
    tag = next;
  }
  return tags;
}

std::int32_t tag_of_name(const std::string& name) {
  std::int32_t tag = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data(), end, tag);
  return error == std::errc{} && rest == end && std::to_string(tag) == name ? tag : 0;
}

void GroupCollector::add(int dimension, std::int32_t tag, Index element) {
  if (last_ == nullptr || last_->dimension != dimension || last_->tag != tag)
    last_ = &group(dimension, tag);
  if (last_->elements.empty() || last_->elements.back() != element)
    last_->elements.push_back(element);
}

void GroupCollector::name(int dimension, std::int32_t tag, std::string name) {
  group(dimension, tag).name = std::move(name);
}

std::vector<Group> GroupCollector::finish() {
  std::vector<Group> result;
  for (auto& [key, group] : groups_) {
    if (group.name.empty()) group.name = std::to_string(group.tag);
    result.push_back(std::move(group));
  }
  groups_.clear();
  last_ = nullptr;
  return result;
}

Group& GroupCollector::group(int dimension, std::int32_t tag) {
  Group& result = groups_[{dimension, tag}];
  result.dimension = dimension;
  result.tag = tag;
  return result;
}

}  // namespace cleave::app
