#include "cleave/topology/properties.hpp"

#include <algorithm>
#include <stdexcept>

namespace cleave::topology {

void VertexProperties::require_new(std::string_view name, std::size_t values) const {
  if (has(name))
    throw std::invalid_argument("there is a property \"" + std::string(name) + "\" already");
  if (values != vertex_count_)
    throw std::invalid_argument("property \"" + std::string(name) + "\" has " +
                                std::to_string(values) + " values for " +
                                std::to_string(vertex_count_) + " vertices");
}

detail::AnyVertexProperty* VertexProperties::find_any(std::string_view name) const {
  const auto at = std::find_if(properties_.begin(), properties_.end(),
                               [&](const auto& property) { return property->name() == name; });
  return at == properties_.end() ? nullptr : at->get();
}

void VertexProperties::throw_missing(std::string_view name) const {
  throw std::invalid_argument(
      (has(name) ? "values of another type has property \"" : "there is no property \"") +
      std::string(name) + "\"");
}

std::vector<std::string> VertexProperties::names() const {
  std::vector<std::string> names;
  names.reserve(properties_.size());
  for (const auto& property : properties_) names.push_back(property->name());
  return names;
}

bool VertexProperties::remove(std::string_view name) {
  return std::erase_if(properties_,
                       [&](const auto& property) { return property->name() == name; }) != 0;
}

void VertexProperties::prepare(const Relabelling& change) {
  detail::require_value_each(vertex_count_, change);
  groups_.fill(change.merges);
  for (const auto& property : properties_) property->prepare(change, groups_);
}

void VertexProperties::follow(const Relabelling& change) {
  prepare(change);
  for (const auto& property : properties_) property->commit(change);
  vertex_count_ = change.vertices_after;
}

void VertexProperties::require_mergeable(std::span<const Merge> merges) {
  Relabelling change;
  change.clear(vertex_count_);
  change.merges.assign(merges.begin(), merges.end());
  prepare(change);
}

}  // namespace cleave::topology
