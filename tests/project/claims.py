#!/usr/bin/env python3
"""Whether proofs/CLAIMS.md, the ledger, says nothing that the sources do not hold.

    tests/project/claims.py SOURCE_DIR

Every row must point to theorems, functions, tests, pages and pictures that exist, and have what its
verdict needs; every theorem it names must be in proofs/assumptions.v, which prints what it rests
on. Reads the sources alone, so it needs neither Coq nor a build. Then spoils copies of the ledger,
one fault each, and wants every fault found: a check that cannot fail says nothing.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

VERDICTS = ["proved", "tested", "measured", "refuted", "exact replacement", "open"]
STATEMENTS = r"Theorem|Lemma|Corollary|Proposition|Remark|Fact|Example"
MEANINGS = r"Definition|Fixpoint|Function|Inductive|Record|Variant|Structure|Notation"
SPEECH = "Settled by"  # with these words an open row says what would close it


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def without_coq_comments(text):
    """Comments nest; a name that only a comment mentions is no name."""
    out, depth, at = [], 0, 0
    while at < len(text):
        two = text[at:at + 2]
        if two == "(*":
            depth, at = depth + 1, at + 2
        elif two == "*)" and depth > 0:
            depth, at = depth - 1, at + 2
        else:
            if depth == 0:
                out.append(text[at])
            at += 1
    return "".join(out)


def without_cpp_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL)


def slug(heading):
    """The anchor that a heading of Markdown gets."""
    kept = re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower())
    return kept.strip().replace(" ", "-")


class Sources:
    """What a row may point to. `proofs` is a folder of its own, so that a spoiled copy can be read."""

    def __init__(self, root, proofs):
        self.root, self.proofs = root, proofs
        self.statements, self.meanings = {}, {}
        for name in sorted(os.listdir(proofs)):
            if name.endswith(".v"):
                text = without_coq_comments(read(os.path.join(proofs, name)))
                self.statements[name] = self.declared(STATEMENTS, text)
                self.meanings[name] = self.declared(MEANINGS, text)
        assumptions = without_coq_comments(read(os.path.join(proofs, "assumptions.v")))
        self.printed = set(re.findall(r"Print\s+Assumptions\s+(\w+\.[\w']+)\.", assumptions))
        self.tests = self.read_tests()
        self.commands = set(re.findall(r"^  ([a-z]+) ", read(os.path.join(root, "dev")), re.MULTILINE))

    @staticmethod
    def declared(words, text):
        return set(re.findall(rf"\b(?:{words})\s+([A-Za-z_][\w']*)", text))

    def read_tests(self):
        tests = set()
        for folder, _, names in os.walk(os.path.join(self.root, "tests")):
            for name in names:
                path = os.path.join(folder, name)
                if name.endswith(".cpp"):
                    text = without_cpp_comments(read(path))
                    macros = "TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP"
                    tests |= {f"{suite}.{case}" for suite, case in
                              re.findall(rf"\b(?:{macros})\(\s*(\w+)\s*,\s*(\w+)", text)}
                elif name == "CMakeLists.txt":
                    text = read(path)
                    tests |= set(re.findall(r"\badd_test\(\s*NAME\s+([\w.]+)", text))
                    tests |= {"project." + script for script in
                              re.findall(r"^\s*cleave_project_test\((\w+)", text, re.MULTILINE)}
        return tests

    def code(self, path):
        """`topology/unglue.hpp` is the public header <cleave/topology/unglue.hpp>."""
        module, _, rest = path.partition("/")
        for place in [os.path.join(self.root, module, "include", "cleave", module, rest),
                      os.path.join(self.root, path)]:
            if rest and os.path.isfile(place):
                return without_cpp_comments(read(place))
        return None

    def declares(self, path, name):
        """Whether the file declares a function, or a type, or a member function of a type."""
        text = self.code(path)
        if text is None:
            return False
        *types, last = name.split("::")
        found = all(re.search(rf"\b(?:class|struct|enum class)\s+{t}\b", text) for t in types)
        return found and re.search(rf"\b{last}\s*\(|\b(?:class|struct|enum class)\s+{last}\b", text)

    def has_page(self, link):
        path, _, anchor = link.partition("#")
        path = os.path.join(self.root, "proofs", path)
        if not os.path.isfile(path):
            return False
        return not anchor or anchor in map(slug, re.findall(r"^#+ (.*)$", read(path), re.MULTILINE))


class Row:
    """A row of a table: its cells by the names of their columns, and what they point to."""

    def __init__(self, line, columns, sources):
        self.cells = dict(zip(columns, (cell.strip() for cell in line.strip().strip("|").split("|"))))
        self.line, self.columns = line, columns
        self.name = next(iter(self.cells.values()))
        self.verdicts = [word.strip() for word in self.cells.get("verdict", "").split(",")]
        self.evidence = self.cells.get(columns[-1], "")
        self.theorems, self.meanings, self.code, self.tests, self.unknown = [], [], [], [], []
        for token in re.findall(r"`([^`]*)`", self.evidence):
            coq = re.fullmatch(r"(\w+\.v):([A-Za-z_][\w']*)", token)
            cpp = re.fullmatch(r"([\w./-]+\.(?:hpp|cpp|hh|h)):([\w:]+)", token)
            if coq and coq[2] in sources.meanings.get(coq[1], ()):
                self.meanings.append((coq[1], coq[2]))
            elif coq:
                self.theorems.append((coq[1], coq[2]))
            elif cpp:
                self.code.append((cpp[1], cpp[2]))
            elif re.fullmatch(r"[A-Z]\w*\.[A-Z]\w*|(?:project|proofs)\.\w+", token):
                self.tests.append(token)
            elif not (token.startswith("./dev ") and token.split()[1] in sources.commands):
                self.unknown.append(token)
        self.pictures = re.findall(r"!\[[^\]]*\]\(([^)]*)\)", self.evidence)
        self.pages = re.findall(r"(?<!!)\[[^\]]*\]\(([^)]*)\)", self.evidence)


def rows_of(text, sources):
    """All rows of all tables; a table begins with a line of names and a line of dashes."""
    lines = text.split("\n")
    columns, rows = [], []
    for at, line in enumerate(lines):
        if not line.startswith("|"):
            columns = []
        elif at + 1 < len(lines) and re.fullmatch(r"[|\- ]+", lines[at + 1]):
            columns = [cell.strip() for cell in line.strip().strip("|").split("|")]
        elif not re.fullmatch(r"[|\- ]+", line):
            rows.append(Row(line, columns, sources))
    return rows


def what_a_row_points_to(row, sources):
    for file, name in row.theorems:
        if name not in sources.statements.get(file, ()):
            yield f"no theorem {name} in proofs/{file}"
        elif f"{file[:-2]}.{name}" not in sources.printed:
            yield f"theorem {name} is not in proofs/assumptions.v"
    for path, name in row.code:
        if not sources.declares(path, name):
            yield f"no {name} in {path}"
    for test in row.tests:
        if test not in sources.tests:
            yield f"no test {test}"
    for picture in row.pictures:
        if not os.path.isfile(os.path.join(sources.proofs, picture)):
            yield f"no picture {picture}"
    for page in row.pages:
        if not sources.has_page(page):
            yield f"no page or heading {page}"
    for token in row.unknown:
        yield f"`{token}` is neither a theorem, a function, a test nor a command"


def what_a_verdict_needs(row):
    for word in row.verdicts:
        if word not in VERDICTS:
            yield f"'{word}' is no verdict; there are: {', '.join(VERDICTS)}"
    if "proved" in row.verdicts and not row.theorems:
        yield "proved, but by which theorem?"
    if "tested" in row.verdicts and not row.tests:
        yield "tested, but by which test?"
    if "measured" in row.verdicts and not (row.pages or row.tests):
        yield "measured, but where?"
    if "refuted" in row.verdicts and not row.pictures:
        yield "refuted, but no picture of the counterexample"
    if "refuted" in row.verdicts and not (row.theorems or row.tests):
        yield "refuted, but neither a theorem nor a test keeps the counterexample"
    if "exact replacement" in row.verdicts and not (row.theorems or row.tests):
        yield "an exact replacement, but neither proved nor tested"
    if "open" in row.verdicts and SPEECH not in row.evidence:
        yield f"open, and no words '{SPEECH} ..' say what would close it"
    if "open" in row.verdicts and len(row.verdicts) > 1:
        yield "open is a verdict alone"


def complaints(root, proofs):
    """All that is wrong with the ledger in the folder `proofs`, one line each."""
    sources = Sources(root, proofs)
    rows = rows_of(read(os.path.join(proofs, "CLAIMS.md")), sources)
    found, seen = [], set()
    for row in rows:
        if len(row.cells) != len(row.columns) or "verdict" not in row.cells:
            found.append(f"{row.name}: a row with other columns than its table")
            continue
        if row.name in seen:
            found.append(f"{row.name}: two rows have this id")
        seen.add(row.name)
        found += [f"{row.name}: {what}" for what in what_a_row_points_to(row, sources)]
        found += [f"{row.name}: {what}" for what in what_a_verdict_needs(row)]
    found += [f"no row for T{i}" for i in range(1, 14) if f"T{i}" not in seen]
    shown = {picture for row in rows for picture in row.pictures}
    drawn = os.path.join(proofs, "pictures")
    found += [f"no row shows pictures/{name}" for name in sorted(os.listdir(drawn))
              if name.endswith(".svg") and f"pictures/{name}" not in shown]
    return found, rows


def stale_snippets(page, proofs):
    """What the text of docs/correctness.md quotes from the proofs and they do not hold."""
    squeeze = lambda text: " ".join(text.split())
    held = [squeeze(without_coq_comments(read(os.path.join(proofs, name))))
            for name in os.listdir(proofs) if name.endswith(".v")]
    quoted = re.findall(r"^```coq\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    statements = [line for block in quoted for line in re.split(r"\.\n", block) if line.strip()]
    return [f"docs/correctness.md quotes what no proof holds: {squeeze(line)}" for line in statements
            if not any(squeeze(line) in text for text in held)]


def stale_pictures(proofs):
    """The pictures that their script would draw otherwise."""
    home = os.path.join(proofs, "pictures")
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, os.path.join(home, "counterexamples.py"), folder]
        if subprocess.run(command, check=False).returncode != 0:
            return ["proofs/pictures/counterexamples.py fails"]
        drawn, kept = ({name: read(os.path.join(place, name)) for name in os.listdir(place)
                        if name.endswith(".svg")} for place in (folder, home))
    return [f"pictures/{name} is not what its script draws" for name in sorted({**drawn, **kept})
            if drawn.get(name) != kept.get(name)]


def edit(name, old, new):
    """A spoiling: in this file of the copy, `new` for `old`, once."""
    def act(proofs):
        path = os.path.join(proofs, name)
        text = read(path)
        assert old in text, (name, old)
        with open(path, "w", encoding="utf-8") as out:
            out.write(text.replace(old, new, 1))
    return act


def substitute(name, pattern, new):
    """A spoiling: in this file of the copy, `new` for whatever matches."""
    def act(proofs):
        path = os.path.join(proofs, name)
        text, count = re.subn(pattern, new, read(path))
        assert count > 0, (name, pattern)
        with open(path, "w", encoding="utf-8") as out:
            out.write(text)
    return act


def spoilings(rows):
    """Faults: what it is, the complaint it must bring, and how a copy of proofs/ gets it."""

    def first(property_):
        return next(row for row in rows if property_(row))

    def in_row(row, old, new):
        assert old in row.line, (row.name, old)
        return edit("CLAIMS.md", row.line, row.line.replace(old, new))

    def verdict(row, word):
        cells = row.line.split("|")
        cells[1 + row.columns.index("verdict")] = f" {word} "
        return edit("CLAIMS.md", row.line, "|".join(cells))

    def without(row, what):
        """The row without what it points to in this way."""
        return edit("CLAIMS.md", row.line, re.sub(what, "", row.line))

    proved = first(lambda row: row.verdicts == ["proved"] and row.code)
    tested = first(lambda row: row.verdicts == ["tested"])
    refuted = first(lambda row: "refuted" in row.verdicts)
    measured = first(lambda row: row.verdicts == ["measured"] and row.pages)
    open_ = first(lambda row: row.verdicts == ["open"] and not row.pages and not row.tests)
    t7 = first(lambda row: row.name == "T7")
    file, theorem = proved.theorems[0]
    path, function = proved.code[0]
    test, picture, page = tested.tests[0], refuted.pictures[0], measured.pages[0]
    return [
        ("a theorem that does not exist", "no theorem",
         in_row(proved, f"{file}:{theorem}`", f"{file}:{theorem}_`")),
        ("a file of proofs that does not exist", "no theorem",
         in_row(proved, f"`{file}:", f"`no_{file}:")),
        ("a theorem that only a comment has", "no theorem",
         substitute(file, rf"\b({STATEMENTS})\s+{theorem}\b", rf"(* \1 {theorem} *) Lemma other")),
        ("a theorem whose assumptions nobody prints", "is not in proofs/assumptions.v",
         substitute("assumptions.v", rf"\.{theorem}\.", ".other.")),
        ("a function that does not exist", "no no_such_function",
         in_row(proved, f"{path}:{function}`", f"{path}:no_such_function`")),
        ("a source file that does not exist", f"no {function} in no/",
         in_row(proved, f"`{path}:", f"`no/{path}:")),
        ("a test that does not exist", "no test", in_row(tested, f"`{test}`", f"`{test}Not`")),
        ("a picture that does not exist", "no picture",
         lambda proofs: os.remove(os.path.join(proofs, picture))),
        ("a picture that no row shows", "no row shows", lambda proofs: shutil.copy(
            os.path.join(proofs, picture), os.path.join(proofs, "pictures", "unused.svg"))),
        ("a heading that does not exist", "no page or heading", in_row(measured, page, page + "-not")),
        ("a name in no known form", "is neither",
         in_row(proved, f"{file}:{theorem}`", f"{file} {theorem}`")),
        ("a row of T1 to T13 that is missing", "no row for T7",
         edit("CLAIMS.md", t7.line + "\n", "")),
        ("an id used twice", "two rows have this id",
         edit("CLAIMS.md", t7.line, t7.line + "\n" + t7.line)),
        ("a row with a cell too few", "other columns", edit("CLAIMS.md", t7.line, "| T7 | proved |")),
        ("a verdict that is none", "is no verdict", verdict(proved, "correct")),
        ("proved by nothing", "proved, but", without(proved, r"`\w+\.v:\w+`")),
        ("tested by nothing", "tested, but", without(tested, r"`\w+\.[A-Za-z]\w*`")),
        ("measured nowhere", "measured, but", verdict(open_, "measured")),
        ("refuted without a picture", "no picture of", without(refuted, r"!\[[^\]]*\]\([^)]*\)")),
        ("refuted without a counterexample", "neither a theorem", without(refuted, r"`[^`]*`")),
        ("replaced by nothing that is checked", "neither proved", verdict(open_, "exact replacement")),
        ("open without a word on what would close it", "open, and no", without(open_, SPEECH)),
    ]


def faults_that_pass(root, proofs, rows):
    """The spoilings that nobody would notice."""
    with tempfile.TemporaryDirectory() as folder:
        copy = os.path.join(folder, "proofs")
        shutil.copytree(os.path.join(proofs, "pictures"), os.path.join(copy, "pictures"))
        substitute(os.path.join("pictures", "strip.svg"), "<circle ", "<circle  ")(copy)
        if not stale_pictures(copy):
            yield "the check lets pass: a picture that its script does not draw"
    if not stale_snippets("```coq\nDefinition corner := 0.\n```\n", proofs):
        yield "the check lets pass: a definition quoted wrongly"
    for what, expected, act in spoilings(rows):
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, "proofs")
            shutil.copytree(proofs, copy, ignore=shutil.ignore_patterns("*.vo*", "*.glob", ".*"))
            act(copy)
            if not any(expected in line for line in complaints(root, copy)[0]):
                yield f"the check lets pass: {what}"


def main():
    root = os.path.abspath(sys.argv[1])
    proofs = os.path.join(root, "proofs")
    found, rows = complaints(root, proofs)
    found += stale_pictures(proofs)
    page = read(os.path.join(root, "docs", "correctness.md"))
    found += stale_snippets(page, proofs)
    if not found:
        found = list(faults_that_pass(root, proofs, rows))
    for line in found:
        print("claims:", line)
    if found:
        sys.exit(1)
    count = {word: sum(word in row.verdicts for row in rows) for word in VERDICTS}
    print(f"claims: {len(rows)} rows:", ", ".join(f"{n} {word}" for word, n in count.items()))


if __name__ == "__main__":
    main()
