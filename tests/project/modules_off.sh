#!/usr/bin/env bash
# Modules can be switched off, and what stays needs none of the libraries of what went.
set -euo pipefail
source_dir=$1 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# configure_without NAME OPTIONS..: configures with these options and the libraries forbidden.
configure() {
  local name=$1
  shift
  cmake -S "$source_dir" -B "$work/$name" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_BUILD_TYPE=None -DCLEAVE_TESTS=OFF "$@" >"$work/$name.log" 2>&1 ||
    { cat "$work/$name.log"; exit 1; }
}
forbid() { local p; for p in "$@"; do printf -- '-DCMAKE_DISABLE_FIND_PACKAGE_%s=ON ' "$p"; done; }

configure topology -DCLEAVE_CUTTING=OFF -DCLEAVE_FEM=OFF -DCLEAVE_APP=OFF \
  $(forbid Eigen3 VTK CLI11 fmt nlohmann_json)
cmake --build "$work/topology"
configure no_fem -DCLEAVE_FEM=OFF -DCLEAVE_APP=OFF $(forbid Eigen3 VTK CLI11 fmt nlohmann_json)
configure no_cutting -DCLEAVE_CUTTING=OFF -DCLEAVE_APP=OFF $(forbid VTK CLI11 fmt nlohmann_json)
if cmake -S "$source_dir" -B "$work/wrong" -DCLEAVE_FEM=OFF >"$work/wrong.log" 2>&1; then
  echo "the command was configured without the module fem that it needs"
  exit 1
fi
grep -q 'CLEAVE_APP needs' "$work/wrong.log"
echo "modules: topology builds alone; cutting and fem do without each other"
