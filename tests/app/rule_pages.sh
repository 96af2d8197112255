#!/usr/bin/env bash
# docs/checks is what the program app_rule_pages writes: pictures and texts cannot differ from what
# the command does. To bring it up to date: build/dev/tests/app/app_rule_pages docs/checks
set -euo pipefail
program=$1 pages=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$program" "$work/checks"
diff -r "$work/checks" "$pages"
for picture in "$pages"/*.svg; do
  xmllint --noout "$picture"
done
