# SPDX-License-Identifier: Apache-2.0
"""Several source files as one text for clang-tidy, which spends most of its time in the headers that each includes.

clang-tidy 14 parses the standard library anew for each file and also matches every check against all of it. The files of
a unit share that. Their texts stand one after the other in the unit, not as #include lines: the analyzer looks only
at functions of the main file, and some checks also know it. What is unnamed in one file and declared in another gets
another name; where that is not enough the compiler complains, and the file has to be looked at alone.
"""
import dataclasses
import pathlib
import re

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
DECLARATION = re.compile(r"\b(?!operator\b)(\w+)\s*(?:[({=;\[]|:(?!:))")
NO_NAME = re.compile(r"(namespace|public|private)\b|[A-Z_0-9]+\(")  # a macro's name collides with nothing
ENTRY_POINTS = re.compile(r'^(?:extern "C" )?int (main|LLVMFuzzerTestOneInput)\(', re.MULTILINE)
MOST_LINES = 3000  # of a unit: beyond that little more is shared, and a file that spoils it costs more


@dataclasses.dataclass(frozen=True)
class Source:
    """A file with all that decides what clang-tidy says about it."""

    path: pathlib.Path
    flags: tuple  # of the compiler
    config: pathlib.Path  # the folder of the nearest .clang-tidy
    includes: tuple  # headers of ours, direct or not
    key: str  # differs when any of this differs in content

    def text(self):
        return self.path.read_text(encoding="utf-8")


def included_headers(path, folders, known):
    """All headers of ours that the file includes, direct or not; known: path -> the direct ones, filled on the way"""
    found, open_ends = set(), [path]
    while open_ends:
        current = open_ends.pop()
        if current not in known:
            names = INCLUDE.findall(current.read_text(encoding="utf-8"))
            places = ([folder / name for folder in (current.parent, *folders)] for name in names)
            known[current] = [next((place for place in tried if place.exists()), None) for tried in places]
        for header in known[current]:
            if header and header not in found:
                found.add(header)
                open_ends.append(header)
    return tuple(sorted(found))


def declared_names(text, unnamed):
    """What the text declares inside of unnamed namespaces, or else outside of them, as clang-format lays it out"""
    names, is_inside = set(), False
    for line in text.splitlines():
        if line == "namespace {":
            is_inside = True
        elif line == "}  // namespace":
            is_inside = False
        elif is_inside == unnamed and re.match(r"[A-Za-z_]", line) and not NO_NAME.match(line):
            name = DECLARATION.search(line.split("//")[0])
            names |= {name[1]} if name else set()
    return names


class Unit:
    """Files with equal flags and configuration, in one text."""

    def __init__(self, sources):
        self.sources = sources
        self.lines = []  # of the text
        self.owners = []  # (source, its line) for each line of the text
        headers = {source: declared_in(source.includes) for source in sources}
        taken = set().union(*headers.values())
        for source in sources:
            text = source.text()
            unnamed = declared_names(text, unnamed=True) | set(ENTRY_POINTS.findall(text))
            for name in unnamed & taken - headers[source]:
                # A member, or a name with its namespace, is another thing.
                text = re.sub(rf'(?<![\w.>:"/]){name}\b', f"{name}{len(self.lines)}", text)
            taken |= unnamed
            lines = text.splitlines()
            self.lines += lines
            self.owners += [(source, number) for number in range(1, len(lines) + 1)]

    def write(self, path):
        path.write_text("\n".join(self.lines) + "\n", encoding="utf-8")


def declared_in(headers):
    return set().union(*(declared_names(path.read_text(encoding="utf-8"), unnamed=False) for path in headers))


def make_units(sources, processors):
    """The files in about as few units as keep the processors busy, long ones first"""
    lines = {source: source.text().count("\n") for source in sources}
    most_lines = min(MOST_LINES, sum(lines.values()) // processors + 1)
    groups = {}
    for source in sorted(sources, key=lambda source: source.path):
        groups.setdefault((source.flags, source.config), []).append(source)
    units = []
    for group in groups.values():
        chosen, length = [], 0
        for source in group:
            if chosen and length + lines[source] > most_lines:
                units.append(Unit(chosen))
                chosen, length = [], 0
            chosen.append(source)
            length += lines[source]
        units.append(Unit(chosen))
    return sorted(units, key=lambda unit: -len(unit.lines))
