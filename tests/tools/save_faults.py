#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Interrupts saves of a project at every system call and makes every one of them fail: the file has to be the old or the
new one, whole, and an error has to be told. Needs strace; what needs rights that are missing is left out and said.

    python3 tests/tools/save_faults.py build/dev/inkflate
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

SQUARE = """<svg xmlns="http://www.w3.org/2000/svg" width="200" height="200" fill="none" stroke="black">
<path d="M50 50H150V150H50Z"/></svg>"""
OLD, OLDER = b"old" * 1000, b"older" * 1000
ERRORS = ("ENOSPC", "EIO", "EDQUOT", "EROFS")
FAILING_CALLS = ("openat", "write", "fsync", "close", "rename", "link", "unlink", "fchmod")


class Save:
    """A save over an old file, in a folder of its own."""

    def __init__(self, program, folder):
        self.program, self.folder = os.path.abspath(program), folder
        self.reset()
        self.run([])
        self.new = self.read("a.inkflate")
        assert self.new not in (None, OLD), "the save works when nothing stops it"

    def read(self, name):
        path = os.path.join(self.folder, name)
        if not os.path.exists(path):
            return None
        with open(path, "rb") as file:
            return file.read()

    def reset(self):
        for name in os.listdir(self.folder):
            os.unlink(os.path.join(self.folder, name))
        for name, content in (("s.svg", SQUARE.encode()), ("a.inkflate", OLD), ("a.inkflate~", OLDER)):
            with open(os.path.join(self.folder, name), "wb") as file:
                file.write(content)

    def run(self, wrapper, **options):
        words = wrapper + [self.program, "convert", "s.svg", "-o", "a.inkflate"]
        environment = dict(os.environ, ASAN_OPTIONS="detect_leaks=0")
        return subprocess.run(words, cwd=self.folder, env=environment, capture_output=True, check=False, **options)

    def calls(self):
        """The names of the system calls of a save in order, and the index of the first one that belongs to the save."""
        self.reset()
        log = self.folder + ".log"
        self.run(["strace", "-f", "-o", log])
        with open(log, encoding="utf-8", errors="replace") as file:
            lines = [re.match(r"\d+ +(\w+)\((.*)", line) for line in file]
        os.unlink(log)
        calls = [(match[1], match[2]) for match in lines if match]
        first = next(i for i, (_, rest) in enumerate(calls) if ".tmp" in rest)
        return [name for name, _ in calls], first

    def is_whole(self):
        return self.read("a.inkflate") in (OLD, self.new) and self.read("a.inkflate~") in (OLD, OLDER)

    def leftovers(self):
        return [name for name in os.listdir(self.folder) if ".tmp" in name]


def nth_calls(calls):
    """Each call as (name, its number among those of that name), as strace counts them."""
    seen = {}
    for index, name in enumerate(calls):
        seen[name] = seen.get(name, 0) + 1
        yield index, name, seen[name]


def kill_everywhere(save):
    calls, first = save.calls()
    points = inside = 0
    bad, states = [], {"old": 0, "new": 0}
    for index, name, number in nth_calls(calls):
        if name in ("execve", "exit_group"):
            continue
        save.reset()
        run = save.run(["strace", "-f", "-o", "/dev/null", "-e", f"inject={name}:signal=KILL:when={number}"])
        points += 1
        inside += index >= first
        states["old" if save.read("a.inkflate") == OLD else "new"] += 1
        if run.returncode not in (-9, 137) or not save.is_whole():
            bad.append(f"{name} {number}: status {run.returncode}")
    print(f"killed at {points} system calls, {inside} of them in the save: "
          f"{states['old']} old, {states['new']} new, {len(bad)} torn or not killed")
    return points, bad


def fail_everywhere(save):
    calls, first = save.calls()
    points, bad, states = 0, [], {"error told, old file": 0, "done, new file": 0}
    for index, name, number in nth_calls(calls):
        if index < first or name not in FAILING_CALLS:
            continue
        for error in ERRORS:
            save.reset()
            run = save.run(["strace", "-f", "-o", "/dev/null", "-e", f"inject={name}:error={error}:when={number}"])
            points += 1
            is_new = save.read("a.inkflate") == save.new
            told = run.returncode == 4 and run.stderr.count(b"\n") == 1
            # A failing unlink leaves what it should have taken away.
            is_clean = name == "unlink" or not save.leftovers()
            is_good = is_clean and save.is_whole() and ((run.returncode == 0 and is_new) or (told and not is_new))
            states["done, new file" if is_new else "error told, old file"] += is_good
            if not is_good:
                bad.append(f"{name} {number} {error}: status {run.returncode}, {run.stderr!r}")
    print(f"made {points} system calls of the save fail: " + ", ".join(f"{n} {s}" for s, n in states.items()) +
          f", {len(bad)} wrong")
    return points, bad


def judge_refusal(save, what, run, bad):
    is_good = run.returncode == 4 and save.read("a.inkflate") == OLD and run.stderr.startswith(b"inkflate: ")
    print(f"{what}: status {run.returncode}, {run.stderr.decode().strip()}")
    if not is_good or save.leftovers():
        bad.append(what)
    return 1


def real_disks(program, scratch):
    """A disk without room, and folders that cannot be written."""
    points, bad = 0, []
    disk = os.path.join(scratch, "disk")
    os.mkdir(disk)
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "none", disk], capture_output=True, check=False).returncode != 0:
        print("full and read-only disks: left out, nothing can be mounted here")
        return points, bad
    try:
        save = Save(program, disk)
        save.reset()
        filler = os.path.join(disk, "filler")
        with open(filler, "wb", buffering=0) as file:
            try:
                while True:
                    file.write(b"x" * 1024)
            except OSError:
                pass
        points += judge_refusal(save, "full disk", save.run([]), bad)
        os.unlink(filler)
        save.reset()
        subprocess.run(["mount", "-o", "remount,ro", disk], check=True)
        points += judge_refusal(save, "read-only disk", save.run([]), bad)
        subprocess.run(["mount", "-o", "remount,rw", disk], check=True)
        if shutil.which("setpriv"):
            os.chmod(disk, 0o555)
            user = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
            points += judge_refusal(save, "read-only folder", save.run(user), bad)
    finally:
        subprocess.run(["umount", disk], check=False)
    return points, bad


def main():
    if not shutil.which("strace"):
        sys.exit("strace is missing: apt-get install strace")
    total, faults = 0, []
    with tempfile.TemporaryDirectory() as scratch:
        os.chmod(scratch, 0o755)
        folder = os.path.join(scratch, "folder")
        os.mkdir(folder)
        save = Save(sys.argv[1], folder)
        for points, bad in (kill_everywhere(save), fail_everywhere(save), real_disks(sys.argv[1], scratch)):
            total += points
            faults += bad
    for fault in faults[:20]:
        print(f"  {fault}")
    print(f"{total - len(faults)} passed, {len(faults)} failed")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
