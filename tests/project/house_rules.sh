#!/usr/bin/env bash
# Cheap facts about the sources that a reader would notice first.
set -euo pipefail
cd "$1"
status=0
complain() { echo "house rule broken: $*"; status=1; }

files() { git ls-files "$@" | grep -v third_party; }
[ -d .git ] || [ -f .git ] || { echo "no git checkout here: nothing to look at"; exit 0; }

marks=$(files '*.hpp' '*.cpp' '*.sh' '*.py' '*.js' '*.html' '*.txt' '*.cmake' dev |
  grep -v house_rules.sh | xargs grep -nwE 'TODO|FIXME|XXX|HACK' || true)
[ -z "$marks" ] || complain "unfinished marks: $marks"
for file in $(files '*.hpp'); do
  head -1 "$file" | grep -qx '#pragma once' || complain "$file does not start with #pragma once"
done
printing=$(files 'topology/*' 'cutting/*' 'fem/*' | xargs grep -nE 'std::(cout|cerr|clog)|\bprintf\(' || true)
[ -z "$printing" ] || complain "library code prints: $printing"
upward=$(files 'topology/*' | xargs grep -nE 'cleave/(cutting|fem)/|"app/' || true)
[ -z "$upward" ] || complain "topology knows its users: $upward"
sideways=$(files 'cutting/*' | xargs grep -n 'cleave/fem/' || true; files 'fem/*' | xargs grep -n 'cleave/cutting/' || true)
[ -z "$sideways" ] || complain "cutting and fem know each other: $sideways"
long=$(files '*.hpp' '*.cpp' | xargs wc -l | awk '$2 != "total" && $1 > 500 { print $2 " (" $1 " lines)" }')
[ -z "$long" ] || complain "more than one idea in a file? $long"
exit $status
