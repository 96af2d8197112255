#!/usr/bin/env bash
# The GitHub Action and the pre-commit hook, as far as they run without either: the definitions are
# read, and their steps run on the project's meshes.
set -euo pipefail
source_dir=$1 build_dir=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PATH="$build_dir/bin:$PATH"
cp -r "$source_dir/data" "$work/data"
mkdir -p "$work/data/drafts"
echo nothing >"$work/data/drafts/broken.mesh"
cd "$work"

/usr/bin/python3 - "$source_dir" "$work" <<'PYTHON'
import os, re, sys, yaml
source, work = sys.argv[1:]
action = yaml.safe_load(open(source + "/action.yml"))
hook, = yaml.safe_load(open(source + "/.pre-commit-hooks.yaml"))
assert action["runs"]["using"] == "composite"
steps = {step.get("id", step["name"]): step for step in action["runs"]["steps"]}
inputs = action["inputs"]
for step in action["runs"]["steps"]:
    for name in re.findall(r"inputs\.(\w+)", str(step)):
        assert name in inputs, name
    assert "shell" in step or "uses" in step, step["name"]
for value in steps["check"]["env"].values():  # never pasted into the script itself
    assert re.fullmatch(r"\$\{\{ inputs\.\w+ \}\}", value), value
assert "${{" not in steps["check"]["run"]
open(work + "/check_step.sh", "w").write(steps["check"]["run"])
assert "dev\" build" in steps["Build cleave"]["run"] and os.access(source + "/dev", os.X_OK)
pattern = re.compile(hook["files"])
for name in ("a.mesh", "x/b.MSH", "c.vtu", "d.vtk", "e.msh.gz", "f.inp", "g.inp.gz", "h.node", "h.ele"):
    assert pattern.search(name), name
for name in ("a.mesh.groups.json", "b.cpp", "mesh", "c.vtu.gz", "d.vtk.gz", "e.ele.gz"):
    assert not pattern.search(name), name
assert hook["language"] == "system"
open(work + "/hook_entry", "w").write(hook["entry"])
PYTHON

# Runs the step as GitHub does; leaves the exit status that it tells in $told.
check_step() {
  : >outputs
  env GITHUB_OUTPUT="$work/outputs" "$@" bash --noprofile --norc -eo pipefail check_step.sh >log 2>&1 ||
    { cat log; echo "the step of the action failed"; exit 1; }
  told=$(sed -n 's/^status=//p' outputs)
}
expect() { [ "$told" = "$1" ] || { cat log; echo "the action tells status $told, not $1"; exit 1; }; }

inputs=(MESHES=data EXCLUDE= REQUIRE= CONFIG= SARIF=cleave.sarif JUNIT=)
check_step "${inputs[@]}"
expect 3  # the draft
check_step "${inputs[@]}" EXCLUDE=drafts JUNIT=cleave.xml
expect 1  # the liver
[ -s cleave.sarif ] && [ -s cleave.xml ] || { echo "the action left no report"; exit 1; }
check_step "${inputs[@]}" MESHES=$'data/fault.msh\n' EXCLUDE=$'drafts\nliver*' REQUIRE=manifold
expect 0

hook() { $(cat hook_entry) "$@" >log 2>&1; }
hook data/fault.msh || { cat log; echo "the hook refuses a sound mesh"; exit 1; }
if hook --require manifold data/fault.msh data/liver-16k.mesh; then
  echo "the hook takes a mesh with errors"
  exit 1
fi
echo "ci definitions: the action's step and the hook ran as they say"
