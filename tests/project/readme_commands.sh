#!/usr/bin/env bash
# Runs every command line that README.md and docs/*.md show in a `console` block after `$ cleave`,
# in a folder with the project's data/, in order of the page; a line `# exit N` before a command
# states the exit status it must have (0 otherwise). A `python` block that begins with `# NAME.py` is
# the file NAME.py there.
set -euo pipefail
source_dir=$1 build_dir=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PATH="$build_dir/bin:/usr/bin:$PATH"  # Debian's python3, which has Debian's meshio

count=0
for page in "$source_dir"/README.md "$source_dir"/docs/*.md; do
  folder="$work/$(basename "$page" .md)"
  mkdir -p "$folder"
  cp -r "$source_dir/data" "$folder/data"
  awk -v folder="$folder" '
    /^```python$/ { getline; name = ""; if (match($0, /^# [a-z_]+\.py/)) name = folder "/" substr($0, 3, RLENGTH - 2) }
    /^```$/ { name = "" }
    name != "" { print >name }' "$page"
  wanted=0
  while IFS= read -r line; do
    case "$line" in
      '# exit '*) wanted=${line#\# exit } ;;
      '$ '*)
        command=${line#\$ }
        case "$command" in
          ./dev* | git* | cd\ * | sudo* ) continue ;;  # these are what this test is part of
        esac
        status=0
        (cd "$folder" && bash -c "$command" >"$work/out" 2>&1 </dev/null) || status=$?
        if [ "$status" -ne "$wanted" ]; then
          echo "$(basename "$page"): exit $status, not $wanted: $command"
          tail -20 "$work/out"
          exit 1
        fi
        wanted=0
        count=$((count + 1))
        ;;
    esac
  done < <(awk '/^```console$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$page")
done
[ "$count" -ge 5 ] || { echo "only $count commands found in the pages"; exit 1; }
echo "$count commands of README.md and docs/ ran as they say"
