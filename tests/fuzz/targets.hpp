#pragma once
#include <string>

#include "target.hpp"

namespace cleave::fuzz {

void fuzz_mesh(const std::string& extension, Bytes bytes);
void fuzz_request(Bytes bytes);
void fuzz_scene(Bytes bytes);
void fuzz_topology(Bytes bytes);

}  // namespace cleave::fuzz
