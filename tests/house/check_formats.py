"""Compare the keys of every file format in the code with kernel/FORMATS.md:  check_formats.py TREE

A section of FORMATS.md names the files whose keys it documents in a line "Source: `io/process/job_read.c`, ...".
- Every key or column in such a file stands in backticks in a section that names the file.
- Every key in a table's columns key, column, array, property and name stands in one of these files.
- Every file of io and apps that has keys is named by a section, but for the page's own data (NOT_DOCUMENTED).
Prints a line for each fault, which says what to do, and ends with 1 where there was any.
"""
import pathlib
import re
import sys

DOCUMENT = "kernel/FORMATS.md"

# the data of report.html belong to the page of the same version and are no interface
NOT_DOCUMENTED = ("io/report/", "apps/report")

# how a writer has a key in C; each pattern gives the key as its first group
WRITTEN = [
    r'\\"([A-Za-z]\w*)\\":',                             # "\"key\": "
    r'\b(?:wcut_)?(?:put|json)_\w+\(&?\w+, "([A-Za-z]\w*)"',  # put_half(&out, "lower", ...), json_text(out, "name", ...)
]

# how the tables of readers, writers and public headers have one
TABLED = [
    r'\bIN\(\w+, [\w.]+, "(\w+)"',                       # a reader's table: IN(type, member, "key", ...)
    r'\bIN_[A-Z]+\([\w.]+, "(\w+)"',                     # IN_JOB(member, "key", ...)
    r'\bPART\("(\w+)"',                                  # PART("key", ...)
    r'\{\s*"(\w+)", (?:\d+, \d+, )?(?:true|false)\b',    # {"key", true, read}, {"key", place, size, true}
    r'\{"(\w+)", "\w+", "\w*", (?:true|false)\}',        # a known column: {"heat_W_per_m", "heat", "W_per_m", true}
    r'#define INFO_\w+ "(\w+)"',                         # the choice of an effect
    r'\{"(\w+)", [a-z]->',                               # {"mean", s->mean}
    r'\{(?:POINT_DATA|CELL_\w+|POINTS|LINES), "(\w+)"',  # an array of a .vtp
    r'\{"(\w+)", [\d.]+(?:e-?\d+)?\}',                  # a unit: {"inch", 25.4}
    r'\bproperty (?:double|uchar) (\w+)',                # of a PLY
]
LISTED = r'\*const (?:name|key|said_of_\w+)\[\w*\](?:\[\w*\])? = \{([^}]*)\}'  # a list of keys: name[] = {"tx_mm", ...}
CHANNEL = r'\bX\(\w+, "(\w+)", "(\w*)", [01]\)'  # a recording's column: its stem and its unit
ENTRY = r'\bX\(\w+, "(\w+)"'  # another list of names in a public header
HEADER = r'"((?:[a-z][a-z0-9]*(?:_\w+)?,){2,}[\w.]*)(?:\\n)?"'  # the header row of a CSV


def keys_of(source, text):
    """keys and columns that a source reads or writes"""
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    text = re.sub(r'"\s*\n\s*"', "", text)  # a literal over several lines
    found = set()
    for pattern in WRITTEN:
        found.update(re.findall(pattern, text))
    if source.startswith("apps/"):
        return found
    for pattern in TABLED:
        found.update(re.findall(pattern, text))
    for listed in re.findall(LISTED, text):
        found.update(re.findall(r'"(\w+)"', listed))
    for row in re.findall(HEADER, text):
        found.update(re.findall(r"\w+", row[0] if isinstance(row, tuple) else row))
    columns = re.findall(CHANNEL, text)
    found.update(stem + ("_" + unit if unit else "") for stem, unit in columns)
    if not columns:
        found.update(re.findall(ENTRY, text))
    return {key for key in found if not key.isupper() and not key.isdigit()}


def words_of(source, text):
    """every word inside a string literal, and the columns of channels: what a documented key may come from"""
    found = keys_of(source, text)
    for literal in re.findall(r'"((?:[^"\\]|\\.)*)"', text):
        found.update(re.findall(r"[A-Za-z]\w*", literal.replace("\\n", " ")))
    return found


class Section:
    def __init__(self, title, line):
        self.title, self.line = title, line
        self.sources, self.words, self.rows = [], set(), []


def sections_of(document):
    """what each section of level two documents: its sources, the words in backticks, the keys of its tables"""
    found, fenced, in_source, columns = [], False, False, []
    for number, line in enumerate(document.splitlines(), 1):
        if line.startswith("```"):
            fenced = not fenced
        if fenced or line.startswith("```"):
            continue
        if line.startswith("## "):
            found.append(Section(line[3:].strip(), number))
        if not found:
            continue
        here = found[-1]
        in_source = line.startswith("Source: ") or (in_source and line.strip() != "")
        spans = re.findall(r"`([^`]*)`", line)
        if in_source:
            here.sources += spans
            continue
        for span in spans:
            here.words.update(re.findall(r"[A-Za-z]\w*", span))
        cells = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("|") else []
        if not cells:
            columns = []
        elif not columns:  # the head of a table
            columns = [k for k, cell in enumerate(cells) if re.match(r"(key|column|array|property|name)\b", cell)] or [-1]
            continue
        for k in columns:
            for span in re.findall(r"`([^`]*)`", cells[k]) if 0 <= k < len(cells) else []:
                here.rows += [(word, number) for word in re.findall(r"\b[A-Za-z]\w*", span) if not word.isupper()]
    return found


def check_sections(tree, sections, faults):
    """sources exist, and rows are keys of theirs; gives the sections of each source"""
    named = {}
    for section in sections:
        known = set()
        for source in section.sources:
            path = tree / source
            if not path.is_file():
                faults.append(f"{DOCUMENT}:{section.line}: section {section.title} names {source}, which does not "
                              "exist: write the file's new path into its Source line")
                continue
            named.setdefault(source, []).append(section)
            known |= words_of(source, path.read_text())
        for word, line in section.rows if known else []:
            if word not in known:
                faults.append(f"{DOCUMENT}:{line}: `{word}` is in none of {', '.join(section.sources)}: "
                              "rename or remove the row")
    return named


def check_source(source, keys, sections, faults):
    """every key of a source stands in one of its sections"""
    if not sections:
        faults.append(f"{source}: has keys ({', '.join(sorted(keys)[:6])}) that no section of {DOCUMENT} documents: "
                      f"add `{source}` to the Source line of the section of its format, or a new section with rows "
                      "| `key` | value, unit | range | default | meaning | and a fenced example")
        return
    words = set().union(*(section.words for section in sections))
    titles = " or ".join(section.title for section in sections)
    for key in sorted(keys - words):
        faults.append(f"{source}: key \"{key}\" is not in {DOCUMENT}: add a row "
                      f"| `{key}` | value, unit | range | default | meaning | to section {titles}, and the key to the "
                      "section's example")


def main():
    tree, faults, count = pathlib.Path(sys.argv[1]), [], 0
    named = check_sections(tree, sections_of((tree / DOCUMENT).read_text()), faults)
    files = {p.relative_to(tree).as_posix() for folder in ("io", "apps") for p in (tree / folder).rglob("*.c")}
    for source in sorted(files | set(named)):
        keys = keys_of(source, (tree / source).read_text())
        if keys and not source.startswith(NOT_DOCUMENTED):
            check_source(source, keys, named.get(source, []), faults)
            count += len(keys)
    for fault in faults:
        print(fault)
    print(f"{count} keys, {len(faults)} faults")
    return 1 if faults or not count else 0


sys.exit(main())
