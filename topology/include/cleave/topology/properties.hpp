#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cleave/topology/carry_over.hpp"
#include "cleave/topology/relabelling.hpp"

namespace cleave::topology {

class VertexProperties;

namespace detail {

/// An array of VertexProperties, whatever its type.
class AnyVertexProperty {
 public:
  explicit AnyVertexProperty(std::string name) : name_(std::move(name)) {}
  virtual ~AnyVertexProperty() = default;
  AnyVertexProperty(const AnyVertexProperty&) = delete;
  AnyVertexProperty& operator=(const AnyVertexProperty&) = delete;

  const std::string& name() const { return name_; }

 private:
  friend class topology::VertexProperties;
  virtual void prepare(const Relabelling& change, const MergeGroups& groups) = 0;
  virtual void commit(const Relabelling& change) noexcept = 0;

  std::string name_;
};

}  // namespace detail

/// A value per vertex, with a name; made by VertexProperties::add. It stays where it is as long as
/// it is not removed.
template <class T>
class VertexProperty : public detail::AnyVertexProperty {
 public:
  std::size_t size() const { return values_.size(); }

  /// For T = bool a proxy, as of std::vector<bool>. Requires that the vertex exists.
  typename std::vector<T>::reference operator[](VertexId vertex) { return values_[vertex.value]; }
  typename std::vector<T>::const_reference operator[](VertexId vertex) const {
    return values_[vertex.value];
  }

  const std::vector<T>& values() const { return values_; }

  /// All values, to be written. Valid until the property follows a change. Not for T = bool.
  std::span<T> span() { return values_; }

 protected:
  VertexProperty(std::string name, std::vector<T> values)
      : AnyVertexProperty(std::move(name)), values_(std::move(values)) {}

  std::vector<T> values_;
};

namespace merging {

/// As Mean, with the weights of another property of the same VertexProperties, as they are when
/// the merge happens. That one must not be removed before.
struct MeanBy {
  const VertexProperty<double>& weights;
  template <class T>
  T operator()(const std::vector<T>& values, std::span<const VertexId> vertices) const {
    return Mean{weights.values()}(values, vertices);
  }
};

}  // namespace merging

/// Arrays of values per vertex, found by name and type, that survive cuts and stitches: all of them
/// follow a change in one call, or none does. Each has the merging policy it was added with (see
/// carry_over.hpp). Cells, half-facets and corners never change their numbers, so plain arrays do
/// for these.
class VertexProperties {
 public:
  /// For a complex whose vertex ids are below `vertex_count`.
  explicit VertexProperties(std::size_t vertex_count) : vertex_count_(vertex_count) {}

  VertexProperties(VertexProperties&&) = default;
  VertexProperties& operator=(VertexProperties&&) = default;

  std::size_t vertex_count() const { return vertex_count_; }

  /// Adds an array: `values`, one per vertex. Throws std::invalid_argument if it has another number
  /// of values, or if there is a property of this name. T is moved and made by default without
  /// exceptions. The policy is kept, so what it refers to must live as long.
  template <class T, class Merging = merging::Equal>
  VertexProperty<T>& add(std::string name, std::vector<T> values, Merging merge = {}) {
    require_new(name, values.size());
    auto made = std::make_unique<Merged<T, Merging>>(std::move(name), std::move(values), merge);
    VertexProperty<T>& property = *made;
    properties_.push_back(std::move(made));
    return property;
  }

  /// The same with the same value for each vertex.
  template <class T, class Merging = merging::Equal>
  VertexProperty<T>& add_constant(std::string name, const T& value, Merging merge = {}) {
    return add(std::move(name), std::vector<T>(vertex_count_, value), std::move(merge));
  }

  /// The property of this name and type, or null.
  template <class T>
  VertexProperty<T>* find(std::string_view name) {
    return dynamic_cast<VertexProperty<T>*>(find_any(name));
  }
  template <class T>
  const VertexProperty<T>* find(std::string_view name) const {
    return dynamic_cast<const VertexProperty<T>*>(find_any(name));
  }

  /// The same; throws std::invalid_argument if there is none.
  template <class T>
  VertexProperty<T>& get(std::string_view name) {
    if (VertexProperty<T>* const property = find<T>(name)) return *property;
    throw_missing(name);
  }
  template <class T>
  const VertexProperty<T>& get(std::string_view name) const {
    if (const VertexProperty<T>* const property = find<T>(name)) return *property;
    throw_missing(name);
  }

  /// Whether there is a property of this name, of any type.
  bool has(std::string_view name) const { return find_any(name) != nullptr; }

  /// All names, in the order in which they were added.
  std::vector<std::string> names() const;

  /// Removes the property of this name; references to it end. Whether there was one.
  bool remove(std::string_view name);

  /// Makes all arrays follow a change of the complex. Throws std::invalid_argument if it is one of
  /// a complex with another number of vertices, what the policies throw, and std::bad_alloc; all
  /// arrays are unchanged then. Allocates nothing once as large a change has been followed. Time:
  /// per array, that of carry_over.
  void follow(const Relabelling& change);

  /// Throws what follow would throw on a change with these merges alone, and changes nothing: to
  /// refuse a stitch beforehand, with Incision::planned_merges.
  void require_mergeable(std::span<const Merge> merges);

 private:
  template <class T, class Merging>
  class Merged final : public VertexProperty<T> {
   public:
    Merged(std::string name, std::vector<T> values, Merging merge)
        : VertexProperty<T>(std::move(name), std::move(values)), merge_(std::move(merge)) {}

   private:
    void prepare(const Relabelling& change, const detail::MergeGroups& groups) override {
      carrying_.prepare(this->values_, change, groups, merge_);
    }
    void commit(const Relabelling& change) noexcept override {
      carrying_.commit(this->values_, change);
    }

    Merging merge_;
    detail::Carrying<T> carrying_;
  };

  void require_new(std::string_view name, std::size_t values) const;
  detail::AnyVertexProperty* find_any(std::string_view name) const;
  [[noreturn]] void throw_missing(std::string_view name) const;
  void prepare(const Relabelling& change);

  std::size_t vertex_count_;
  std::vector<std::unique_ptr<detail::AnyVertexProperty>> properties_;
  detail::MergeGroups groups_;
};

}  // namespace cleave::topology
