#!/usr/bin/env bash
# Installs the build and lets a project of somebody else find and use it, the README's example too.
set -euo pipefail
source_dir=$1 build_dir=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build_dir" --prefix "$work/prefix" >"$work/install.log"
# The first C++ block of each of these pages is a whole program.
examples=
for page in README docs/topology; do
  program="$work/$(basename "$page")_example.cpp"
  awk '/^```cpp$/ { inside = 1; next } /^```$/ && inside { exit } inside' "$source_dir/$page.md" >"$program"
  [ -s "$program" ] || { echo "$page.md has no C++ example"; exit 1; }
  examples="$examples;$program"
done

cmake -S "$source_dir/tests/consumer" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DCMAKE_CXX_COMPILER="$compiler" -DPAGE_EXAMPLES="${examples#;}" >"$work/configure.log" ||
  { cat "$work/configure.log"; exit 1; }
cmake --build "$work/build"
for program in use_topology use_cutting use_fem README_example topology_example; do
  "$work/build/$program" || { echo "$program failed"; exit 1; }
done

# The programs of the guides are a project of their own, too.
cmake -S "$source_dir/examples" -B "$work/examples" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DCMAKE_CXX_COMPILER="$compiler" >"$work/configure.log" || { cat "$work/configure.log"; exit 1; }
cmake --build "$work/examples"
for program in seams crack network space_time; do
  "$work/examples/example_$program" >/dev/null || { echo "example $program failed"; exit 1; }
done
echo "consumer: found, built and ran with every module"
