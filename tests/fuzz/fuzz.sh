#!/usr/bin/env bash
# fuzz.sh BUILD SECONDS [TARGET..]: fuzzes each target (all, if none is named) for so long, one per
# processor at a time. Reads tests/fuzz/corpus, collects more inputs under BUILD/fuzz/TARGET, leaves
# what it finds in BUILD/fuzz/TARGET.found and each log beside it. Exit 1 if anything is found.
# CLEAVE_FUZZ_SEED is what the inputs are made from; without it each run makes others.
set -euo pipefail
here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
build=$(realpath "$1") seconds=$2
shift 2
[ $# -gt 0 ] || set -- $(ls "$here/corpus")

one() {
  local target=$1 work=$build/fuzz/$1 found=$build/fuzz/$1.found log=$build/fuzz/$1.log dict
  mkdir -p "$work" "$found" "$TMPDIR/$target"
  dict=$TMPDIR/$target.dict
  for name in $(sed -n 's/^# also: //p' "$here/dictionaries/$target.dict") "$target"; do
    cat "$here/dictionaries/$name.dict"
  done >"$dict"
  # A leak, an input that takes a minute or 2 GB, and whatever a sanitizer says are findings, too.
  if CLEAVE_FUZZ_TARGET=$target TMPDIR=$TMPDIR/$target \
    LSAN_OPTIONS=suppressions=$here/../support/vtk_leaks.supp:print_suppressions=0 "$build/tests/fuzz/fuzz" \
    -seed="${CLEAVE_FUZZ_SEED:-0}" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=2048 -malloc_limit_mb=512 -max_len=8192 \
    -dict="$dict" -artifact_prefix="$found/" -print_final_stats=1 \
    "$work" "$here/corpus/$target" >"$log" 2>&1; then
    printf '%-12s %s\n' "$target" "$(awk '/number_of_executed_units/ { n = $2 }
      / cov: / { for (i = 1; i < NF; ++i) if ($i == "cov:") cov = $(i + 1) }
      /^Done/ { s = $(NF - 1) } END { print n, "inputs in", s, "s; branches met:", cov }' "$log")"
  else
    printf '%-12s FOUND something; the end of %s:\n' "$target" "$log"
    tail -n 60 "$log"
    return 1
  fi
}

# In memory, if there is such a place: targets write small files all the time.
TMPDIR=$(mktemp -d -p "$([ -w /dev/shm ] && echo /dev/shm || echo "${TMPDIR:-/tmp}")" cleave-XXXXXX)
trap 'rm -rf "$TMPDIR"' EXIT
export -f one
export here build seconds TMPDIR
mkdir -p "$build/fuzz"
printf '%s\n' "$@" | xargs -P "$(nproc)" -I{} bash -euo pipefail -c 'one {}'
