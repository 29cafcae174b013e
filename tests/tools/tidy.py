#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs clang-tidy on what changed since it last found nothing: tidy.py BUILD_FOLDER...

A source file is looked at again when it, a header of ours that it includes, its flags, the configuration or clang-tidy
differs from the last clean run. The stamps lie in the user's cache, so that another copy of the sources knows them
as well. Prints "P passed, F failed" at the end. How files are put together for speed is told in tidy_units.py.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time

from tidy_units import Source, Unit, included_headers, make_units

TOP = pathlib.Path(__file__).resolve().parents[2]
WORK = TOP / "build" / "tidy"
STAMPS = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "inkflate" / "tidy"
PROCESSORS = len(os.sched_getaffinity(0))
STAMP_LIFE_S = 60 * 24 * 3600
FINDING = re.compile(r"^(/[^:]+):(\d+):(\d+): (?:warning|error): ")
CANNOT_COMPILE = "[clang-diagnostic-error]"


def digest(data):
    return hashlib.sha256(data).hexdigest()


def compiler_flags(command):
    """The command without compiler, input and output"""
    words = shlex.split(command)
    words = words[next(i for i, word in enumerate(words) if word.startswith("-")) :]
    return tuple(words[: words.index("-o")])


def config_of(path):
    """The folder of the .clang-tidy that counts for a file, and what all that it inherits from hold"""
    folders = [folder for folder in path.parents if folder.is_relative_to(TOP) and (folder / ".clang-tidy").exists()]
    return folders[0], "".join(digest((folder / ".clang-tidy").read_bytes()) for folder in folders)


def all_sources(folders):
    """Each file of ours that is compiled in one of the build folders"""
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    found, direct, hashes = {}, {}, {}
    for entry in (entry for folder in folders for entry in json.loads((folder / "compile_commands.json").read_text())):
        path = pathlib.Path(entry["file"]).resolve()
        if path in found or path.is_relative_to(TOP / "build"):
            continue
        flags = compiler_flags(entry["command"])
        include_folders = [pathlib.Path(flag[2:]) for flag in flags if flag.startswith(f"-I{TOP}")]
        includes = included_headers(path, include_folders, direct)
        config, config_text = config_of(path)
        # Another copy of the sources, in another place, has the same key.
        parts = [version, config_text, " ".join(flags).replace(str(TOP), ".")]
        for file in (path, *includes):
            if file not in hashes:
                hashes[file] = digest(file.read_bytes())
            parts.append(f"{file.relative_to(TOP)} {hashes[file]}")
        found[path] = Source(path, flags, config, includes, digest("\n".join(parts).encode()))
    return list(found.values())


def run_tidy(unit):
    """[(places, text)] for each finding; places are the sources that it keeps from being clean"""
    # Beside a copy of the tree's configurations, so that clang-tidy finds the one that counts.
    folder = WORK / unit.sources[0].config.relative_to(TOP)
    path = folder / f"{unit.sources[0].path.stem}_{unit.sources[0].key[:8]}.cpp"
    unit.write(path)
    command = ["clang-tidy", "--quiet", str(path), "--", *unit.sources[0].flags]
    done = subprocess.run(command, capture_output=True, text=True)
    path.unlink()

    def place(line):
        source, number = unit.owners[int(line) - 1]
        return f"{source.path.relative_to(TOP)}:{number}"

    findings = []
    for line in done.stdout.splitlines():
        match = FINDING.match(line)
        if match and match[1] == str(path):
            findings.append(([unit.owners[int(match[2]) - 1][0]], []))
        elif match:
            header = pathlib.Path(match[1]).resolve()
            findings.append(([source for source in unit.sources if header in source.includes] or unit.sources, []))
        if findings:
            line = re.sub(rf"^{re.escape(str(path))}:(\d+)", lambda found: place(found[1]), line)
            findings[-1][1].append(line.replace(f"{TOP}/", ""))
    if done.returncode != 0 and not findings:
        findings.append((unit.sources, [f"{CANNOT_COMPILE} {done.stdout}{done.stderr}"]))
    return [(places, "\n".join(text)) for places, text in findings]


def taken_apart(unit, in_the_way):
    """Smaller units: a few files that are in the way alone, or else, as when two headers do not get on, in halves"""
    if len(in_the_way) < 4:
        parts = [[source] for source in unit.sources if source in in_the_way]
        parts.append([source for source in unit.sources if source not in in_the_way])
    else:
        half = len(unit.sources) // 2
        parts = [unit.sources[:half], unit.sources[half:]]
    return [Unit(sources) for sources in parts if sources]


def look(units, report):
    """Reports what clang-tidy finds and gives the failed sources; units that cannot be one text are taken apart."""
    failed, again = set(), []
    with concurrent.futures.ThreadPoolExecutor(max_workers=PROCESSORS) as pool:
        for unit, findings in zip(units, pool.map(run_tidy, units)):
            in_the_way = {source for places, text in findings if CANNOT_COMPILE in text for source in places}
            if in_the_way and len(unit.sources) > 1:
                again += taken_apart(unit, in_the_way)
                continue
            for places, text in findings:
                failed.update(places)
                report(text)
            for source in set(unit.sources) - failed:
                (STAMPS / source.key).touch()
    return failed | look(again, report) if again else failed


def copy_configurations(sources):
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    for folder in {folder for source in sources for folder in (source.config, *source.config.parents)}:
        if folder.is_relative_to(TOP) and (folder / ".clang-tidy").exists():
            place = WORK / folder.relative_to(TOP)
            place.mkdir(parents=True, exist_ok=True)
            shutil.copy(folder / ".clang-tidy", place)


def main(folders):
    sources = all_sources([pathlib.Path(folder).resolve() for folder in folders])
    STAMPS.mkdir(parents=True, exist_ok=True)
    for stamp in STAMPS.iterdir():
        if time.time() - stamp.stat().st_mtime > STAMP_LIFE_S:
            stamp.unlink(missing_ok=True)
    todo = [source for source in sources if not (STAMPS / source.key).exists()]
    for source in sources:
        if source not in todo:
            (STAMPS / source.key).touch()
    copy_configurations(sources)
    units = make_units(todo, PROCESSORS)
    print(f"{len(todo)} of {len(sources)} files to look at, in {len(units)} units", flush=True)
    failed = look(units, report=lambda text: print(text, flush=True))
    print(f"{len(sources) - len(failed)} passed, {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    if not shutil.which("clang-tidy") or len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
