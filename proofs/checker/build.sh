#!/usr/bin/env bash
# build.sh [OUT]: extracts the checker from the compiled proofs and builds OUT/cleave-certify.
# Needs coqc and ocamlopt (Debian's coq package brings both) and the .vo files of proofs/.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-$here/_build}
mkdir -p "$out"
out=$(cd "$out" && pwd)
cp "$here"/*.ml "$here"/*.mli "$out"
cd "$out"
coqc -Q "$here/.." Cleave -w -extraction -o "$out/extract.vo" "$here/../extract.v"
strict=(-w +a-4-9-40..42-44-45-70 -warn-error +a)
ocamlopt -c verified.mli verified.ml
ocamlopt -c "${strict[@]}" certificate.mli certificate.ml main.ml
ocamlopt -o cleave-certify verified.cmx certificate.cmx main.cmx
