#!/usr/bin/env bash
# Whether the pictures of the guides are what the programs draw now.
set -euo pipefail
pictures=$1 programs=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 "$pictures/guides.py" "$programs" "$work"
for name in seams crack; do
  cmp "$work/guide-$name.svg" "$pictures/guide-$name.svg"
done
