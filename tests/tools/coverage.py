#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How much of src/ the tests run, by folder: coverage.py BUILD_FOLDER [--files FOLDER]

BUILD_FOLDER was built by the preset `coverage` and its programs have run; `./test --coverage` does both. --files shows
each file of a folder and the lines that no test reaches. Prints "P passed, F failed" at the end: the folders that
have to reach a bar. A branch counts twice, once for each way; those inside of CHECK do not count, since the way that
is never taken stands for a bug of ours.
"""
import argparse
import collections
import dataclasses
import json
import pathlib
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = ("tests/unit_tests", "tests/property_tests", "inkflate")
LEAST_LINES, LEAST_BRANCHES = 0.90, 0.80
# What a user's work depends on and no picture shows when it is wrong.
HELD_FOLDERS = ("document", "editor")


@dataclasses.dataclass
class Reached:
    """Lines and branches: how many there are, and how many a test reaches."""

    lines: int = 0
    lines_reached: int = 0
    branches: int = 0
    branches_reached: int = 0

    def add(self, other):
        for field in dataclasses.fields(self):
            setattr(self, field.name, getattr(self, field.name) + getattr(other, field.name))

    def is_enough(self):
        enough_lines = self.lines_reached >= LEAST_LINES * self.lines > 0
        return enough_lines and self.branches_reached >= LEAST_BRANCHES * self.branches

    def row(self, name):
        def part(reached, total):
            return f"{reached / total:7.1%}" if total else "      -"

        return (
            f"{name:40} {self.lines:7} {part(self.lines_reached, self.lines)}"
            f" {self.branches:7} {part(self.branches_reached, self.branches)}"
        )


def export(folder):
    """(path in src/, llvm-cov's file with its summary, branches and segments)"""
    merged = folder / "merged.profdata"
    profiles = sorted((folder / "profiles").glob("*.profraw"))
    if not profiles:
        sys.exit(f"{folder}/profiles is empty: run ./test --coverage")
    subprocess.run(["llvm-profdata-14", "merge", "-o", merged, *profiles], check=True)
    programs = [folder / program for program in PROGRAMS if (folder / program).exists()]
    command = ["llvm-cov-14", "export", programs[0], *(word for program in programs[1:] for word in ("-object", program))]
    command += [f"-instr-profile={merged}", "-skip-functions", "-skip-expansions"]
    files = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)["data"][0]["files"]
    for file in files:
        # A compiler cache names sources from the build folder on: build/coverage/../../src.
        path = (folder / file["filename"]).resolve()
        if path.is_relative_to(TOP / "src"):
            yield path.relative_to(TOP / "src"), file


def reached_in(file):
    # A template has its branches once for each instance.
    ways = collections.Counter()
    for line, column, end_line, end_column, taken, not_taken, *_ in file["branches"]:
        ways[line, column, end_line, end_column, True] += taken
        ways[line, column, end_line, end_column, False] += not_taken
    lines = file["summary"]["lines"]
    return Reached(lines["count"], lines["covered"], len(ways), sum(count > 0 for count in ways.values()))


def unreached_lines(file):
    """As "3-7 12", from llvm-cov's segments: [line, column, count, has_count, is_entry, is_gap], each up to the next"""
    lines = set()
    for (line, _, count, has_count, _, is_gap), (end, end_column, *_) in zip(file["segments"], file["segments"][1:]):
        if has_count and count == 0 and not is_gap:
            lines.update(range(line, end + (end_column > 1)))
    runs = []
    for line in sorted(lines):
        if runs and runs[-1][1] == line - 1:
            runs[-1][1] = line
        else:
            runs.append([line, line])
    return " ".join(f"{first}" if first == last else f"{first}-{last}" for first, last in runs)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build_folder", type=pathlib.Path)
    parser.add_argument("--files", metavar="FOLDER", help="of src/, as in src/FOLDER")
    options = parser.parse_args()

    print(f"{'src/':40} {'lines':>7} {'reached':>7} {'ways':>7} {'reached':>7}")
    folders = collections.defaultdict(Reached)
    for path, file in export(options.build_folder):
        reached = reached_in(file)
        folders[path.parts[0]].add(reached)
        if options.files == path.parts[0] and reached.lines:
            print(f"{reached.row(str(path))}  {unreached_lines(file)}")
    if options.files:
        return 0
    held = [folders[name].is_enough() for name in HELD_FOLDERS]
    for name, reached in sorted(folders.items()):
        print(reached.row(name) + ("" if name not in HELD_FOLDERS or reached.is_enough() else "  too little"))
    print(f"{held.count(True)} passed, {held.count(False)} failed")
    return 0 if all(held) else 1


if __name__ == "__main__":
    sys.exit(main())
