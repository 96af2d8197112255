#!/usr/bin/env bash
# Whether the proofs prove what they say, as far as it shows without reading them.
#
#   proofs/check_sources.sh                 checks the sources; needs no Coq
#   proofs/check_sources.sh BUILD           ... and what Coq says; BUILD is the folder of the
#                                           compiled proofs
#   proofs/check_sources.sh --write BUILD   first writes assumptions.v, assumptions.out,
#                                           statements.v and statements.out anew
#
# Exit status: 0 fine, 1 findings, one per line. BUILD is the real check: there Coq prints for every
# Theorem, and every lemma that the ledger names, what it rests on, and for the main ones what they
# state. Both must be what assumptions.out (nothing) and statements.out hold, so that a statement
# cannot change unseen. The check of the sources finds what Coq does not print, and finds the rest
# without Coq: a sentence may only begin with words that are listed here, so no axiom under any name,
# no unfinished proof, no switch of Coq, no change of what is extracted, no library that brings
# axioms. At last faults are planted in copies, and each must be found: a check that cannot fail
# says nothing.
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

# Writes all sentences of a folder, each after its file, to $scratch/said.
read_folder() {
  local file
  for file in "$1"/*.v; do
    sentences "$file" | sed "s/^/${file##*/} /"
  done >"$scratch/said"
}

# Prints the sentences that may not be in the sources.
forbidden() {
  awk '
    function find(what) { print file ": " what ": " substr(said, 1, 70) }
    $1 != file { if (depth != 0) find("a section is left open"); file = $1; depth = 0 }
    { said = substr($0, length($1) + 2); words = said
      gsub(/[^A-Za-z0-9_'"'"']/, " ", words); words = " " words " " }
    words ~ / (Admitted|admit|Admit|Abort|give_up|bypass_check|native_compute) / { find("unfinished"); next }
    said ~ /^[a-z0-9[(]/ { next }  # a step of a proof

    { sub(/^(Local|Global) /, "", said); first = said; sub(/[^A-Za-z].*/, "", first) }
    first ~ /^(Variables?|Hypothes[ie]s|Let)$/ { if (depth == 0) find("outside a section"); next }
    first == "Section" { depth++; next }
    first == "End" { depth--; next }
    first ~ /^(Theorem|Lemma|Corollary|Remark|Fact|Example|Proof|Qed|Defined)$/ { next }
    first ~ /^(Definition|Fixpoint|Record|Structure|Inductive|Variant|Canonical|Coercion)$/ { next }
    first ~ /^(Notation|Implicit|Arguments)$/ { next }
    said ~ /^(Set Implicit Arguments|Unset Strict Implicit|Unset Printing Implicit Defensive) ?\.$/ { next }
    said ~ /^(Open Scope ring_scope ?\.$|Hint Resolve )/ { next }
    said ~ /^From Cleave Require (Import |Export )?[a-z0-9_ ]+\.$/ { next }
    said ~ /^From mathcomp Require Import( (all_ssreflect|all_algebra|fingroup|perm))+ ?\.$/ { next }
    said ~ /^From Coq Require Import( (PArith|FMapPositive))+ ?\.$/ { next }
    said ~ /^Import( (GRing|Num|Order)\.T?Theory)+ ?\.$/ { next }
    file == "extract.v" && said == "From Coq Require Import Extraction ExtrOcamlBasic." { next }
    file == "extract.v" && said ~ /^Extraction _ [a-z0-9_. ]+\.$/ { next }
    file == "assumptions.v" && first ~ /^(Locate|Print)$/ { next }
    file == "statements.v" && (first == "Check" || said == "Set Printing Width 100.") { next }
    { find("not allowed") }' "$scratch/said"
}

# Prints what the sources in a folder may not hold, one finding a line.
findings_in() {
  local folder=$1 file
  read_folder "$folder"
  forbidden
  grep -vxE -e '-Q \. Cleave' -e '-arg -w -arg -notation-overridden,-ambiguous-paths,-extraction' \
    -e '[a-z0-9_]+\.v' "$folder/_CoqProject" | sed 's/^/_CoqProject: not allowed: /' || true
  for file in "$folder"/*.v; do
    grep -qxF "${file##*/}" "$folder/_CoqProject" || echo "${file##*/}"
  done | grep -vxE 'assumptions\.v|statements\.v|extract\.v' | sed 's/$/: not in _CoqProject/' || true
  printed "$folder" >"$scratch/printed"
  { theorems "$folder"; in_ledger "$folder"; } | grep -vxFf "$scratch/printed" |
    sed 's/$/: not in assumptions.v/' || true
  checked "$folder" >"$scratch/checked"
  main_statements "$folder" | grep -vxFf "$scratch/checked" | sed 's/$/: not in statements.v/' || true
  grep '\.v$' "$folder/_CoqProject" | sort >"$scratch/listed"
  { grep '^|' "$folder/README.md" || true; } | grep -oE '[a-z0-9_]+\.v' |
    grep -vxE 'assumptions\.v|statements\.v|extract\.v' | sort | diff "$scratch/listed" - |
    sed -n -e 's/^< \(.*\)/\1: not in the table of README.md/p' \
      -e 's/^> \(.*\)/README.md: no such file, or twice in the table: \1/p' || true
}

# Prints the statements of these kinds as file.name, in the order of _CoqProject.
declared() {
  local folder=$1 kinds=$2 file
  grep '\.v$' "$folder/_CoqProject" | while read -r file; do
    sed -nE "s/^${file%.v}\.v (Local |Global )?($kinds) ([A-Za-z_][A-Za-z0-9_']*).*/${file%.v}.\3/p" "$scratch/said"
  done
}

theorems() { declared "$1" Theorem; }

# Prints the statements that the ledger names as evidence, as file.name; with a second argument those
# of its first tables: T1 to T13, the certificate, selection and names.
in_ledger() {
  declared "$1" 'Theorem|Lemma|Corollary|Remark|Fact' >"$scratch/declared"
  awk -v main="${2:-}" 'main && /^## What the paper says/ { exit } { print }' "$1/CLAIMS.md" |
    { grep -oE "\`[a-z0-9_]+\.v:[A-Za-z_][A-Za-z0-9_']*\`" || true; } | tr -d '`' |
    sed 's/\.v:/./' | sort -u | { grep -xFf "$scratch/declared" || true; }
}

# Prints what must be in statements.v: all that theorems.v states, and what the ledger rests on.
main_statements() {
  { declared "$1" 'Theorem|Fact' | { grep '^theorems\.' || true; }; in_ledger "$1" main; } |
    awk '!seen[$0]++'
}

# Prints what assumptions.v prints the assumptions of, and what statements.v states, as file.name.
printed() { sed -nE "s/^Print Assumptions (.*)\.$/\1/p" "$1/assumptions.v"; }
checked() { sed -nE "s/^Check (.*)\.$/\1/p" "$1/statements.v"; }

# Prints what Coq says of assumptions.v, and of statements.v.
assumptions() { say_of assumptions "$1" | fold_lines; }
statements() { say_of statements "$1"; }
say_of() { coqc -q -w none -Q "$2" Cleave -o "$scratch/$1.vo" "$here/$1.v"; }

# One theorem a line: its name, and what it rests on.
fold_lines() {
  awk '/^Constant / { if (line != "") print line; line = $2 ":"; next } { sub(/^ +/, ""); line = line " " $0 }
       END { if (line != "") print line }' | sed -E 's/ \(shorter name[^)]*\)//'
}

# Prints the head of a written file, up to its first sentence, and what it has to import.
head_of() {
  sed -n '/^Print\|^Locate\|^From\|^Set\|^Check/q;p' "$here/$1.v"
  grep '\.v$' "$here/_CoqProject" | sed -E 's/(.*)\.v/From Cleave Require \1./'
}

write() {
  local build=$1 name
  read_folder "$here"
  {
    head_of assumptions
    { theorems "$here"; in_ledger "$here"; } | awk '!seen[$0]++' | while read -r name; do
      printf 'Locate %s.\nPrint Assumptions %s.\n' "$name" "$name"
    done
  } >"$scratch/assumptions.v"
  {
    head_of statements
    echo 'From mathcomp Require Import all_ssreflect all_algebra fingroup perm.'
    echo 'Set Printing Width 100.'
    main_statements "$here" | sed 's/.*/Check &./'
  } >"$scratch/statements.v"
  for name in assumptions statements; do
    mv "$scratch/$name.v" "$here/$name.v"
    "$name" "$build" >"$scratch/out"
    mv "$scratch/out" "$here/$name.out"
  done
}

# Plants faults in copies of the sources and prints those that nobody finds. Each has what must be
# found, the file that gets it, and the text to add there.
faults_that_pass() {
  local expected file text copy=$scratch/copy
  while IFS='|' read -r expected file text; do
    rm -rf "$copy"
    mkdir "$copy"
    cp "$here"/{copies,extract,assumptions,statements}.v "$copy"
    printf '%s\n' '-Q . Cleave' copies.v >"$copy/_CoqProject"
    echo '`copies.v:T1_card`' >"$copy/CLAIMS.md"
    echo '| `copies.v` | `extract.v` |' >"$copy/README.md"
    printf '%b\n' "$text" >>"$copy/$file"
    findings_in "$copy" >"$scratch/found"
    if [ "$expected" = nothing ]; then
      [ ! -s "$scratch/found" ] || echo "the check complains of: $text"
    else
      grep "$expected" "$scratch/found" >/dev/null || echo "the check lets pass: $text"
    fi
  done <<'FAULTS'
unfinished|copies.v|Lemma wrong : False.\nProof. Admitted.
unfinished|copies.v|Lemma wrong : False.\nProof.\nadmit.\nDefined.
unfinished|copies.v|Lemma wrong : False. Abort.
unfinished|copies.v|Admit Obligations.
unfinished|copies.v|#[bypass_check(guard)] Fixpoint f (n : nat) : False := f n.
not allowed|copies.v|Axiom wrong : False.
not allowed|copies.v|(* a comment (* in a comment *) *) Local Axiom wrong : False.
not allowed|copies.v|Parameters wrong : False.
not allowed|copies.v|Definition s := "(*". Conjecture wrong : False.
not allowed|copies.v|Declare Module X : DecidableType.
not allowed|copies.v|Module Type X. End X.
not allowed|copies.v|Primitive wrong := #int63_add.
not allowed|copies.v|Declare ML Module "extraction_plugin".
not allowed|copies.v|Unset Guard Checking.
not allowed|copies.v|Set Definitional UIP.
not allowed|copies.v|Time Variable wrong : False.
not allowed|copies.v|#[global] Theorem wrong : False.
not allowed|copies.v|Program Theorem wrong : False.
not allowed|copies.v|Require Import Classical.
not allowed|copies.v|From Coq Require Import PArith Reals.
not allowed|copies.v|From Coq.Logic Require Import FunctionalExtensionality.
not allowed|copies.v|Extract Constant copy => "0".
not allowed|extract.v|Extract Constant certify_exec.certify_exec => "(fun _ _ _ _ -> Accepted)".
not allowed|extract.v|Extract Inlined Constant certify_exec.certify_exec => "wrong".
not allowed|extract.v|Extract Inductive certify_exec.verdict => "bool" [ "true" "false" ].
not allowed|extract.v|Extraction Implicit certify_exec.certify_exec [n].
not allowed|extract.v|Extraction Blacklist List.
not allowed|extract.v|Extraction NoInline certify_exec.certify_exec.
not allowed|_CoqProject|-arg -type-in-type
not allowed|_CoqProject|-R . Other
outside a section|copies.v|Hypothesis wrong : False.
outside a section|copies.v|Section S . End S.\nVariable wrong : False.
not in assumptions|copies.v|Theorem nobody_prints : True.\nProof. exact I. Qed.
copies.mem_copy: not in assumptions|CLAIMS.md|`copies.v:mem_copy`
copies.mem_copy: not in statements|CLAIMS.md|`copies.v:mem_copy`
stray.v: not in _CoqProject|stray.v|Theorem stray : True.\nProof. exact I. Qed.
not in the table of README|_CoqProject|assumptions.v
README.md: no such file|README.md|| `gone.v` | a row
nothing|copies.v|(* Admitted. Axiom (* nested *) Parameter *) Definition s := "Admitted. Abort.".
nothing|copies.v|Section S.\nVariable fine : nat.\nHypothesis too : fine = 0.\nEnd S.
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
  for file in assumptions statements; do
    "$file" "$(cd "$1" && pwd)" >"$scratch/out"
    diff "$here/$file.out" "$scratch/out" | sed -n "s/^\\([<>]\\)/$file.out \\1/p" >>"$scratch/findings" || true
  done
fi
if [ -s "$scratch/findings" ]; then
  cat "$scratch/findings"
  exit 1
fi
echo "proofs: $(grep -c . "$here/assumptions.out") theorems rest on nothing but Coq," \
  "$(grep -c '^Check' "$here/statements.v") state what they did"
