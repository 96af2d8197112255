#include "files/abaqus_types.hpp"

#include <algorithm>
#include <array>

namespace cleave::app {
namespace {

struct Names {
  AbaqusType type;
  std::string_view names;  // separated by blanks
};

constexpr std::array<Names, 8> kTypes{{
    {{1, false, false, 2},
     "T2D2 T2D2H T2D2T T3D2 T3D2H T3D2T B21 B21H B23 B23H B31 B31H B31OS B33 B33H R2D2 RB2D2 RB3D2 "
     "DC1D2"},
    {{1, true, false, 3}, "T2D3 T2D3H T3D3 T3D3H B22 B22H B32 B32H B32OS"},
    {{2, false, false, 3},
     "CPS3 CPS3T CPE3 CPE3H CPE3T CPEG3 CAX3 CAX3H CAX3T S3 S3R S3RS S3T S3RT STRI3 DS3 M3D3 R3D3 "
     "SFM3D3 DC2D3 DCAX3 AC2D3 ACAX3"},
    {{2, true, false, 6},
     "CPS6 CPS6M CPS6MT CPE6 CPE6H CPE6M CPE6MH CPEG6 CAX6 CAX6H CAX6M CAX6MH STRI65 S6 DS6 M3D6 "
     "SFM3D6 DC2D6 DCAX6 AC2D6 ACAX6"},
    {{3, false, false, 4}, "C3D4 C3D4H C3D4T C3D4P DC3D4 AC3D4"},
    {{3, true, false, 10},
     "C3D10 C3D10H C3D10HS C3D10I C3D10M C3D10MH C3D10MT C3D10T DC3D10 AC3D10"},
    {{2, false, true, 4}, "COH2D4 COH2D4P COHAX4"},
    {{3, false, true, 6}, "COH3D6 COH3D6P"},
}};

}  // namespace

const AbaqusType* abaqus_type(std::string_view name) {
  for (const Names& entry : kTypes) {
    std::string_view rest = entry.names;
    while (!rest.empty()) {
      const auto blank = std::min(rest.find(' '), rest.size());
      if (rest.substr(0, blank) == name) return &entry.type;
      rest.remove_prefix(std::min(blank + 1, rest.size()));
    }
  }
  return nullptr;
}

}  // namespace cleave::app
