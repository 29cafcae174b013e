#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs clang-tidy on what changed since it last found nothing: tidy.py BUILD_FOLDER...

A source file is looked at again when it, a header of ours that it includes, its compile command or the
configuration differs from the last clean run; the stamps lie in build/tidy. What a file includes is known from
ninja, so the folders have to be built. Prints "P passed, F failed" at the end.
"""
import concurrent.futures
import hashlib
import json
import pathlib
import shutil
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
STAMPS = TOP / "build" / "tidy"


def digest(data):
    return hashlib.sha256(data).hexdigest()


def included_files(folder):
    """object file -> the files it was made from, as ninja remembers them"""
    text = subprocess.run(["ninja", "-C", folder, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    files, current = {}, None
    for line in text.splitlines():
        if line.startswith("    "):
            path = pathlib.Path(folder, line.strip()).resolve()
            if path.is_relative_to(TOP) and not path.is_relative_to(TOP / "build"):
                files[current].append(path)
        elif ": #deps" in line:
            current = line.split(": #deps")[0]
            files[current] = []
    return files


def jobs(folder):
    """(source, build folder, key) for each file of ours that this folder compiles"""
    base = digest((TOP / ".clang-tidy").read_bytes())
    includes = included_files(folder)
    hashes = {}
    for entry in json.loads(pathlib.Path(folder, "compile_commands.json").read_text()):
        source = pathlib.Path(entry["file"]).resolve()
        if source.is_relative_to(TOP / "build"):
            continue
        output = entry["command"].split(" -o ")[1].split(" ")[0]
        parts = [base, entry["command"]]
        for path in sorted(set(includes.get(output, [])) | {source}):
            if path not in hashes:
                hashes[path] = digest(path.read_bytes()) if path.exists() else "gone"
            parts.append(f"{path} {hashes[path]}")
        yield source, folder, digest("\n".join(parts).encode())


def check(job):
    source, folder, key = job
    done = subprocess.run(["clang-tidy", "--quiet", "-p", folder, str(source)], capture_output=True, text=True)
    if done.returncode == 0:
        (STAMPS / key).touch()
        return True
    print(f"{source.relative_to(TOP)}:\n{done.stdout or done.stderr}", flush=True)
    return False


def main(folders):
    chosen = {}
    for folder in folders:
        for source, where, key in jobs(folder):
            chosen.setdefault(source, (source, where, key))
    STAMPS.mkdir(parents=True, exist_ok=True)
    keys = {key for _, _, key in chosen.values()}
    for stamp in STAMPS.iterdir():
        if stamp.name not in keys:
            stamp.unlink()
    todo = [job for job in sorted(chosen.values()) if not (STAMPS / job[2]).exists()]
    print(f"{len(todo)} of {len(chosen)} files to look at", flush=True)
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        failed = list(pool.map(check, todo)).count(False)
    print(f"{len(chosen) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    if not shutil.which("clang-tidy") or len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
