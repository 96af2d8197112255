#!/usr/bin/env bash
# The cuts of the two demo scenes, through C++ and the checker extracted from the proofs. Each scene is
# cut twice: by `cleave run`, and stroke by stroke by `cleave cut`, which writes a certificate. The
# certificate of the first is that of the second with the cells that `run` wrote. Skipped where the
# checker has not been built.
set -euo pipefail
source_dir=$1 cleave=$2 conformance=$3 checker=$4
[ -x "$checker" ] || { echo "there is no $checker; ./dev proofs builds it"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# The strokes of a scene, each as a sweep, and the scene without all that is no cut.
take_apart() {
  /usr/bin/python3 - "$source_dir/data" "$1" <<'PYTHON'
import json, os, sys
data, name = sys.argv[1:]
with open(os.path.join(data, name + ".scene.json")) as file:
    scene = json.load(file)
mesh = scene["mesh"]
if "file" in mesh:
    mesh["file"] = os.path.join(data, mesh["file"])
with open(name + ".scene.json", "w") as file:
    json.dump({"mesh": mesh, "strokes": scene["strokes"], "output": {"page": False}}, file)
for number, stroke in enumerate(scene["strokes"]):
    assert set(stroke) <= {"name", "comment", "blade"}, "a stroke that cleave cut would do otherwise"
    with open(f"{name}.{number:02}.sweep.json", "w") as file:
        json.dump({"blade": stroke["blade"]}, file)
PYTHON
}

# The rows of cells in a Medit file, without the reference.
tetrahedra() { awk '/^Tetrahedra/ { rows = 1; next } rows && NF == 5 { print $1, $2, $3, $4 }' "$1"; }

for scene in liver cube; do
  take_apart "$scene"
  "$cleave" run "$scene.scene.json" -o "$scene" --quiet >/dev/null 2>&1
  cp "$scene/state-000.vtu" "$scene.vtu"  # the mesh before all strokes
  for sweep in "$scene".*.sweep.json; do
    "$cleave" cut "$scene.vtu" -o "$scene.vtu" --sweep "$sweep" --certificate "$scene.cert" \
      --quiet 2>/dev/null
  done
  "$cleave" convert "$scene/final.vtu" "$scene-run.mesh" --quiet 2>/dev/null
  { sed '/^after$/q' "$scene.cert"; tetrahedra "$scene-run.mesh"; echo end; } >"$scene-run.cert"
  [ "$("$cleave" certify "$scene.cert")" = accepted ]
done
"$conformance" files "$checker" liver.cert liver-run.cert cube.cert cube-run.cert
