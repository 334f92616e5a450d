"""What documents, comments and messages name exists:  check_documents.py TREE

- A document that any file names (NOTATION.md, samples/README.md) is in the tree; a section named behind it
  ("NOTATION.md, Effects") is a heading of it. A document named without its ending (NAMED_BARE) is refused.
- In documents and pictures: every wcut_name is in the code. In documents: links lead to files and headings; `path/file.c` in backticks exists; `path/file.c:function` is defined
  there; a test named in backticks (`cli_path`, `test_fit`) exists.
- NOTATION.md says where each of the equations (1) to (11) is, and where each effect is.
- DECISIONS.md lists every decision in its index, each with the files it speaks of.
- kernel/README.md names every room of kernel and io, and what it sees as arrows.txt does; README.md names every verb.
Prints a line for each fault, which says what to do, and ends with 1 where there was any.
"""
import os
import pathlib
import re
import sys

SOURCES = {".c", ".h", ".cpp", ".hpp", ".py", ".sh", ".awk", ".md", ".mjs", ".js", ".ts", ".css", ".txt", ".cmake", ".in", ".svg"}
SKIPPED = {"build", "node_modules", "dist", ".git"}
NAMED_BARE = r"\b(FORMATS|NOTATION|DECISIONS|MEASURED|CONTRIBUTING|MODEL|DIAGNOSIS|PEERS|INVERSE|HOUSE)\b(?!\.md)"
TOPS = r"(?:kernel|io|apps|tests|samples|\.ci)"
FILE = re.compile(rf"`({TOPS}/[\w./*-]*)(?::(\w+))?`")
TEST = re.compile(r"`((?:test|cli|house|exchange|fuzz|bench|install)_\w+)`")


def files_of(tree):
    for folder, folders, names in os.walk(tree):
        folders[:] = sorted(set(folders) - SKIPPED)
        for name in sorted(names):
            path = pathlib.Path(folder, name)
            if path.suffix in SOURCES and path.is_file():
                yield path


def comments_of(path, text):
    """the text of comments and messages alone: where a bare name in capitals is meant as a document"""
    if path.suffix not in {".c", ".h", ".cpp", ".hpp"}:
        return []
    return [(text.count("\n", 0, m.start()) + 1, m.group(0)) for m in re.finditer(r"/\*.*?\*/|//[^\n]*", text, re.S)]


def slug(heading):
    return re.sub(r"[^\w\- ]", "", re.sub(r"`", "", heading).lower()).replace(" ", "-")


def headings_of(text):
    outside = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
    return re.findall(r"^#+ (.+?)\s*$", outside, re.M)


class Checker:
    def __init__(self, tree):
        self.tree, self.faults, self.count = tree, [], 0
        self.files = list(files_of(tree))
        self.documents = {p for p in self.files if p.suffix == ".md"}
        code = [p for p in self.files if p.suffix in {".c", ".h", ".cpp"} and p.relative_to(tree).parts[0] != "tests"]
        self.names = set().union(*(re.findall(r"\bwcut_\w+", p.read_text()) for p in code))
        self.tests = {p.stem for p in (tree / "tests").rglob("*") if p.suffix in {".c", ".sh"}}

    def fault(self, path, line, what):
        self.faults.append(f"{path.relative_to(self.tree).as_posix()}:{line}: {what}")

    def find_document(self, named, near):
        for folder in (near.parent, self.tree, self.tree / "kernel"):
            if (folder / named).is_file():
                return folder / named
        same = [p for p in self.documents if p.relative_to(self.tree).as_posix().endswith("/" + named)]
        return same[0] if same else None

    # documents that any file names
    def check_named_documents(self, path, text):
        for m in re.finditer(r"(?<![\w*/$])([\w./-]*\w\.md)\b(?:, ([A-Z]\w+(?: \w+)?))?", text):
            line = text.count("\n", 0, m.start()) + 1
            if m.group(1).startswith("tree/"):  # planted by a house test
                continue
            found = self.find_document(m.group(1).lstrip("/"), path)
            self.count += 1
            if not found:
                self.fault(path, line, f"{m.group(1)} is not in the repository: name a document that is, or write it")
            elif m.group(2) and path.suffix in {".c", ".h", ".cpp"}:
                words = [h.lower() for h in headings_of(found.read_text())]
                bold = re.findall(r"\*\*([^*]+?)\.\*\*", found.read_text())
                first, both = m.group(2).split()[0].lower(), m.group(2).lower()
                if not any(h == both or h.startswith(first) for h in words + [b.lower() for b in bold]):
                    self.fault(path, line, f"{m.group(1)} has no section \"{m.group(2)}\": name one that it has")
        for line, comment in comments_of(path, text):
            for m in re.finditer(NAMED_BARE, comment):
                self.fault(path, line + comment.count("\n", 0, m.start()),
                           f"the comment names {m.group(1)}: write {m.group(1)}.md with its section if it is in the "
                           "repository, or say the thing itself")

    # what documents name
    def check_document(self, path, text):
        outside = re.sub(r"^```.*?^```", lambda m: re.sub(r"[^\n]", " ", m.group(0)), text, flags=re.S | re.M)
        for m in re.finditer(r"\]\(([^)\s]+)\)", outside):
            line, target = text.count("\n", 0, m.start()) + 1, m.group(1)
            if re.match(r"\w+:", target):
                continue
            self.count += 1
            name, _, anchor = target.partition("#")
            to = path if not name else (path.parent / name)
            if not to.exists():
                self.fault(path, line, f"link to {target}: no such file")
            elif anchor and to.suffix == ".md" and anchor not in map(slug, headings_of(to.read_text())):
                self.fault(path, line, f"link to {target}: no such heading in {to.name}")
        for m in FILE.finditer(outside):
            line, (name, function) = text.count("\n", 0, m.start()) + 1, m.groups()
            self.count += 1
            found = list(self.tree.glob(name.rstrip("/"))) if "*" in name else [self.tree / name]
            if not found or not found[0].exists():
                self.fault(path, line, f"`{name}` does not exist: write the file's new name")
            elif function and not re.search(rf"^[\w ][\w *]*\b{function}\(", found[0].read_text(), re.M):
                self.fault(path, line, f"`{name}` defines no function {function}: write its new name or file")
        for m in TEST.finditer(outside):
            line = text.count("\n", 0, m.start()) + 1
            self.count += 1
            if m.group(1) not in self.tests | {"bench_table"}:
                self.fault(path, line, f"`{m.group(1)}`: there is no such test in tests/: write its new name")

    def check_names(self, path, text):
        for m in re.finditer(r"\bwcut_[a-z0-9_]*[a-z0-9]\b(?!_|\*)", text):
            self.count += 1
            if m.group(0) not in self.names:
                self.fault(path, text.count("\n", 0, m.start()) + 1, f"{m.group(0)} is nowhere in the code: write its new name")

    def check_notation(self):
        path = self.tree / "kernel/NOTATION.md"
        text = path.read_text()
        rows = re.findall(r"^\| \((\d+)\)(?: to \((\d+)\))? \|.*\| ([^|]*) \|$", text, re.M)
        there = {n for first, last, where in rows if FILE.search(where) for n in range(int(first), int(last or first) + 1)}
        for n in set(range(1, 12)) - there:
            self.fault(path, 1, f"equation ({n}) has no row | ({n}) | equation | `file:function` |")
        listed = re.findall(r'X\(\w+, "(\w+)"', (self.tree / "kernel/include/wirecut/effects.h").read_text())
        for name in listed:
            rows = re.findall(rf"^\| .*`{name}`.*\|$", text, re.M)  # a symbol may have the same name
            if not any(FILE.search(row.rsplit(" | ", 1)[-1]) for row in rows):
                self.fault(path, 1, f"effect {name} has no row | `{name}` | equation | neutral | plausible, source | "
                                    "`file:function` | in section Effects")

    def check_decisions(self):
        path = self.tree / "kernel/DECISIONS.md"
        text = path.read_text()
        index = text[: text.find("\n## 20")]
        for number, line in enumerate(text.splitlines(), 1):
            m = re.match(r"## (20\d\d-\d\d-\d\d) (.+)", line)
            if not m:
                continue
            link = f"](#{slug(line[3:].strip())})"
            row = [r for r in index.splitlines() if link in r]
            if not row:
                self.fault(path, number, "not in the index: add a row to the table By room: "
                                         f"| room | [{m.group(2)}{link} | `file`, .. |")
            elif not FILE.search(row[0].split(link)[1]) and "`CMakeLists.txt`" not in row[0]:
                self.fault(path, number, "its row in the index names no file: add `path/file.c` in the last column")

    def check_rooms(self):
        path = self.tree / "kernel/README.md"
        text = path.read_text()
        rooms = [p for top in ("kernel", "io") for p in (self.tree / top).iterdir() if p.is_dir() and p.name != "include"]
        for room in rooms:
            name = room.relative_to(self.tree).as_posix()
            if f"`{name}`" not in text:
                self.fault(path, 1, f"room `{name}` has no row: add what it is for and what it sees")
        for line in (self.tree / "tests/house/arrows.txt").read_text().splitlines():
            if line.startswith("#") or ":" not in line:
                continue
            room, sees = (part.strip() for part in line.split(":", 1))
            allowed = {word for word in sees.split() if not word.startswith("<")}
            row = re.search(rf"^\| `{room}` \|.*\| ([^|]*) \|$", text, re.M)
            said = set(re.findall(r"[\w/]+", row.group(1))) if row else set()
            if row and allowed and said != allowed:
                self.fault(path, 1, f"room `{room}`: it sees {', '.join(sorted(allowed))} by tests/house/arrows.txt, "
                                    "the last column says otherwise")

    def check_verbs(self):
        path = self.tree / "README.md"
        listed = re.search(r"#define APP_VERB_LIST\(X\)(.*?)\n\n", (self.tree / "apps/command.h").read_text(), re.S)
        for verb in re.findall(r"X\((\w+)\)", listed.group(1)):
            if f"| `wirecut {verb} " not in path.read_text():
                self.fault(path, 1, f"verb {verb} has no row: add | `wirecut {verb} ... -o DIR` | what it does |")

    def run(self):
        for path in self.files:
            text = path.read_text(errors="replace")
            self.check_named_documents(path, text)
            if path.suffix == ".md":
                self.check_document(path, text)
            if path.suffix in {".md", ".svg"}:
                self.check_names(path, text)
        self.check_notation()
        self.check_decisions()
        self.check_rooms()
        self.check_verbs()


def main():
    checker = Checker(pathlib.Path(sys.argv[1]).resolve())
    checker.run()
    for fault in checker.faults:
        print(fault)
    print(f"{checker.count} names, {len(checker.faults)} faults")
    return 1 if checker.faults or not checker.count else 0


sys.exit(main())
