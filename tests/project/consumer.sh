#!/usr/bin/env bash
# Installs the build and lets a project of somebody else find and use it, the README's example too.
set -euo pipefail
source_dir=$1 build_dir=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build_dir" --prefix "$work/prefix" >"$work/install.log"
awk '/^```cpp$/ { inside = 1; next } /^```$/ && inside { exit } inside' "$source_dir/README.md" \
  >"$work/readme_example.cpp"
[ -s "$work/readme_example.cpp" ] || { echo "README.md has no C++ example"; exit 1; }

cmake -S "$source_dir/tests/consumer" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DCMAKE_CXX_COMPILER="$compiler" -DREADME_EXAMPLE="$work/readme_example.cpp" >"$work/configure.log" ||
  { cat "$work/configure.log"; exit 1; }
cmake --build "$work/build"
for program in use_topology use_cutting use_fem readme_example; do
  "$work/build/$program" || { echo "$program failed"; exit 1; }
done
echo "consumer: found, built and ran with every module"
