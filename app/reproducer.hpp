#pragma once
#include <filesystem>
#include <string>

#include "body.hpp"

namespace cleave::app {

/// Writes what is needed to do a cut again whose verification failed: the cells with their signs
/// and the facets asked for, as JSON {"schema": "cleave-reproducer/1", "message", "dimension",
/// "vertex_count", "cells", "signs", "cut"}. Cells are tuples of 0-based ids of the regularised
/// complex, "cut" lists half-facets (D+1)*cell + i. Throws OutputError.
template <int D>
void write_reproducer(const std::filesystem::path& path, const topology::Complex<D>& before,
                      const topology::FacetSet& cut, const std::string& message);

}  // namespace cleave::app
