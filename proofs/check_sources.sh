#!/usr/bin/env bash
# Whether the proofs prove what they say, as far as it shows without reading them.
#
#   proofs/check_sources.sh                 checks the sources; needs no Coq
#   proofs/check_sources.sh BUILD           ... and what the theorems rest on; BUILD is the folder
#                                           of the compiled proofs
#   proofs/check_sources.sh --write BUILD   first writes assumptions.v and assumptions.out anew
#
# Exit status: 0 fine, 1 findings, one per line. The sources may hold no unfinished proof, no axiom
# under any name, no variable outside a section, and nothing that switches off a check of Coq. Every
# Theorem must be in assumptions.v, and Coq must print for it what assumptions.out holds: that it
# rests on nothing. At last faults are planted in copies, and each must be found: a check that
# cannot fail says nothing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

# Prints the sentences of a .v file, one a line, without comments (which nest) and strings.
sentences() {
  awk '
    { text = text $0 "\n" }
    END {
      for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1); two = substr(text, i, 2)
        if (quoted) { if (c == "\"") quoted = 0 }
        else if (c == "\"") { quoted = 1; if (depth == 0) out = out "_" }
        else if (two == "(*") { depth++; i++ }
        else if (two == "*)" && depth > 0) { depth--; i++; out = out " " }
        else if (depth == 0) {
          if (c == "." && substr(text, i + 1, 1) ~ /[ \t\n]|^$/) { print out "."; out = "" }
          else if (c !~ /[ \t\n]/) out = out c
          else if (out != "" && out !~ / $/) out = out " "
        }
      }
      if (out ~ /[^ ]/) print out
    }' "$1" | sed 's/^[-+*{} ]*//'
}

# Prints what the sources in a folder may not hold, one finding a line.
findings_in() {
  local folder=$1 file
  for file in "$folder"/*.v; do
    sentences "$file" | awk -v file="${file##*/}" '
      function find(what) { print file ": " what ": " substr($0, 1, 70) }
      { line = " " $0; gsub(/[^A-Za-z0-9_'"'"']/, " ", line); line = line " " }
      line ~ / (Admitted|admit|Abort|give_up) / { find("unfinished") }
      line ~ / (Axiom|Axioms|Parameter|Parameters|Conjecture|Conjectures) / { find("axiom") }
      line ~ / (Guard|Positivity|Universe) Checking | bypass_check | Type In Type / { find("unchecked") }
      $1 == "Section" { sections++ }
      $1 == "Section" || $1 == "Module" && line !~ /:=/ { opened[$2] = $1 }
      $1 == "End" { name = $2; sub(/\.$/, ".", name); if (opened[name] == "Section") sections-- }
      sections == 0 && line ~ /^ ((Local|Global|Polymorphic) )?(Variable|Variables|Hypothesis|Hypotheses|Context) / {
        find("outside a section") }'
  done
  for file in "$folder"/*.v; do
    grep -qxF "${file##*/}" "$folder/_CoqProject" || echo "${file##*/}"
  done | grep -vxE 'assumptions\.v|extract\.v' | sed 's/$/: not in _CoqProject/' || true
  printed "$folder" >"$scratch/printed"
  theorems "$folder" | grep -vxFf "$scratch/printed" | sed 's/$/: not in assumptions.v/' || true
}

# Prints the theorems of a folder as file.name, in the order of _CoqProject.
theorems() {
  local folder=$1 file
  grep '\.v$' "$folder/_CoqProject" | while read -r file; do
    [ "$file" != assumptions.v ] || continue
    sentences "$folder/$file" | sed -nE "s/^(Local |Global )?Theorem ([A-Za-z_][A-Za-z0-9_']*).*/${file%.v}.\2/p"
  done
}

# Prints the lemmas that the ledger names as evidence, as file.name.
in_ledger() {
  local file name
  { grep -oE "\`[a-z0-9_]+\.v:[A-Za-z_][A-Za-z0-9_']*\`" "$here/CLAIMS.md" || true; } |
    tr -d '`' | sed 's/\.v:/ /' | sort -u | while read -r file name; do
    if sentences "$here/$file.v" | grep -E "^(Lemma|Corollary|Remark|Fact) ${name}[^A-Za-z0-9_']" >/dev/null; then
      echo "$file.$name"
    fi
  done
}

# Prints what assumptions.v prints the assumptions of, as file.name.
printed() {
  sed -nE "s/^Print Assumptions (.*)\.$/\1/p" "$1/assumptions.v"
}

# Prints what Coq says of assumptions.v.
assumptions() {
  coqc -q -w none -Q "$1" Cleave -o "$scratch/assumptions.vo" "$here/assumptions.v" | fold_lines
}

# One theorem a line: its name, and what it rests on.
fold_lines() {
  awk '/^Constant / { if (line != "") print line; line = $2 ":"; next } { sub(/^ +/, ""); line = line " " $0 }
       END { if (line != "") print line }' | sed -E 's/ \(shorter name[^)]*\)//'
}

write() {
  local build=$1 name
  {
    sed -n '/^Print\|^Locate\|^From Cleave/q;p' "$here/assumptions.v"
    grep '\.v$' "$here/_CoqProject" | grep -vxE 'extract\.v|assumptions\.v' | sed -E 's/(.*)\.v/From Cleave Require \1./'
    { theorems "$here"; in_ledger; } | awk '!seen[$0]++' | while read -r name; do
      printf 'Locate %s.\nPrint Assumptions %s.\n' "$name" "$name"
    done
  } >"$scratch/assumptions.v"
  mv "$scratch/assumptions.v" "$here/assumptions.v"
  assumptions "$build" >"$scratch/out"
  mv "$scratch/out" "$here/assumptions.out"
}

# Plants faults in copies of the sources and prints those that nobody finds.
faults_that_pass() {
  local fault text expected copy=$scratch/copy
  while IFS='|' read -r expected text; do
    rm -rf "$copy"
    mkdir "$copy"
    cp "$here"/copies.v "$here"/_CoqProject "$here"/assumptions.v "$copy"
    echo copies.v >"$copy/_CoqProject"
    printf '%b\n' "$text" >>"$copy/copies.v"
    fault=$(findings_in "$copy" | grep -c "^copies.*: $expected" || true)
    if [ "$expected" = nothing ]; then
      [ -z "$(findings_in "$copy")" ] || echo "the check complains of: $text"
    else
      [ "$fault" -gt 0 ] || echo "the check lets pass: $text"
    fi
  done <<'FAULTS'
unfinished|Lemma wrong : False.\nProof. Admitted.
unfinished|Lemma wrong : False.\nProof.\nadmit.\nDefined.
unfinished|Lemma wrong : False. Abort.
axiom|Axiom wrong : False.
axiom|(* a comment (* in a comment *) *) Local Axiom wrong : False.
axiom|Parameters wrong : False.
axiom|Definition s := "(*". Conjecture wrong : False.
unchecked|Unset Guard Checking.
unchecked|#[bypass_check(guard)] Fixpoint f (n : nat) : False := f n.
outside a section|Hypothesis wrong : False.
outside a section|Section S. End S.\nVariable wrong : False.
not in assumptions|Theorem nobody_prints : True.\nProof. exact I. Qed.
nothing|(* Admitted. Axiom (* nested *) Parameter *) Definition s := "Admitted. Abort.".
nothing|Section S.\nVariable fine : nat.\nHypothesis too : fine = 0.\nEnd S.
FAULTS
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

if [ "${1:-}" = --write ]; then
  write "$(cd "${2:?BUILD}" && pwd)"
  shift
fi

findings_in "$here" >"$scratch/findings"
[ -s "$scratch/findings" ] || faults_that_pass >>"$scratch/findings"
grep -v ': Closed under the global context$' "$here/assumptions.out" |
  sed 's/^/assumptions.out: rests on something: /' >>"$scratch/findings" || true
if [ -n "${1:-}" ]; then
  assumptions "$(cd "$1" && pwd)" >"$scratch/out"
  diff "$here/assumptions.out" "$scratch/out" | sed -n 's/^\([<>]\)/assumptions.out \1/p' >>"$scratch/findings" || true
fi
if [ -s "$scratch/findings" ]; then
  cat "$scratch/findings"
  exit 1
fi
echo "proofs: $(grep -c . "$here/assumptions.out") theorems rest on nothing but Coq"
