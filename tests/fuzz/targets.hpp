#pragma once
#include <string>

#include "target.hpp"

namespace cleave::fuzz {

/// What a format keeps of a mesh that was read from it.
enum class Keeps { everything, cells };

void fuzz_mesh(const std::string& extension, Keeps keeps, Bytes bytes);
void fuzz_request(Bytes bytes);
void fuzz_record(Bytes bytes);
void fuzz_certificate(Bytes bytes);
void fuzz_config(Bytes bytes);
void fuzz_scene(Bytes bytes);
void fuzz_topology(Bytes bytes);

}  // namespace cleave::fuzz
