#pragma once
#include "mesh.hpp"

namespace cleave::fuzz {

/// Aborts unless everything in `mesh` that is a place is one, and lists that go together are
/// equally long: what the rest of the program relies on, whatever was in the file.
void require_places(const app::Mesh& mesh);

/// Aborts unless both hold the same points (bit for bit, but for the payload of NaN) and cells, in
/// the same order.
void require_same_cells(const app::Mesh& a, const app::Mesh& b);

/// The same, and for elements of every dimension and groups. Numbers and fields, which formats keep
/// to a different degree, are not compared.
void require_same_content(const app::Mesh& a, const app::Mesh& b);

}  // namespace cleave::fuzz
