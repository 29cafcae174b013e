#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kills the editor at random moments while somebody draws: its journal has to lead to a document that there was, with all
that was told to be on the disk, and the work has to go on from there to the same end.

    python3 tests/tools/kill_journal.py build/dev/inkflate [KILLS]
"""
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time


def stroke(*points):
    return {"stroke": [list(point) for point in points]}


def key(name, **modifiers):
    return {"key": name, **modifiers}


def scribble(brush):
    return [brush, stroke((100, 700), (200, 760), (300, 700))]


def blob(x, y, size):
    """A shape in two overlapping strokes."""
    return [stroke((x - size, y), (x - size, y - size), (x, y - size), (x + size, y - size), (x + size, y + 5)),
            stroke((x + size, y - 5), (x + size, y + size), (x, y + size), (x - size, y + size), (x - size, y - 5))]


# Where the paper lies is not in a journal either. From the limits of the camera it comes back exactly to where it is at the start:
# px 500, 500 in the middle of the window, zoom 1.
MIDDLE = {"at": [500, 500]}
STEADY = [{"pinch": 1e-9, **MIDDLE}, {"wheel": [1e9, 1e9], **MIDDLE}, {"pinch": 1e9, **MIDDLE}, {"pinch": 1 / 64, **MIDDLE},
          {"wheel": [-999500, -999500], **MIDDLE}]


def units():
    """What is done, in pieces that do not depend on what is picked or selected: that is not in a journal."""
    brush, eraser = key("b"), key("e")
    result = []
    for i in range(6):
        first, second = blob(150 + 130 * i, 200 + 40 * (i % 3), 50)
        result += [[brush, first], [brush, second], [key("Enter")]]
        if i % 2 == 0:
            result += [scribble(brush), [key("z", ctrl=True)]]
        else:
            result += [scribble(brush), [eraser, stroke((200, 700), (200, 800))], scribble(brush)]
    result += [[key("z", ctrl=True)]] * 5 + [[key("y", ctrl=True)]] * 3
    first, second = blob(500, 600, 80)
    result += [[brush, first], [brush, second], [key("Enter")]]
    # Times that are exact, so that a stroke is the same wherever a run begins; too far apart for a double click.
    for i, event in enumerate(event for unit in result for event in unit if "stroke" in event):
        event.update(start=4 * i + 4, step=1 / 128)
    return result


def text_of(some_units):
    return "".join(json.dumps(event) + "\n" for event in STEADY + [event for unit in some_units for event in unit])


class Acknowledged:
    """What a run has told: for each step the number of lines in the journal, and the hash that they lead to."""

    def __init__(self, output):
        rows = [line.split() for line in output.split("\n")[:-1]]
        self.lines = [int(row[1]) for row in rows]
        self.hashes = {int(row[1]): row[2] for row in rows}


class Editor:
    def __init__(self, program, folder):
        self.program, self.folder = os.path.abspath(program), folder
        self.units = units()

    def words(self, events, *options):
        path = os.path.join(self.folder, "events.jsonl")
        with open(path, "w", encoding="utf-8") as file:
            file.write(events)
        return [self.program, "replay", path, "--quiet", "--acknowledge", *options]

    def run(self, events, *options):
        done = subprocess.run(self.words(events, *options), capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return Acknowledged(done.stdout)

    def run_until_killed(self, events, after_s, *options):
        """What it told before it was killed; None: it was done before."""
        process = subprocess.Popen(self.words(events, *options), stdout=subprocess.PIPE, text=True)
        time.sleep(after_s)
        process.send_signal(signal.SIGKILL)
        output, _ = process.communicate()
        return Acknowledged(output) if process.returncode == -signal.SIGKILL else None

    def hash(self, path):
        done = subprocess.run([self.program, "hash", path], capture_output=True, text=True, check=False)
        return done.stdout.split()[0] if done.returncode == 0 else f"refused: {done.stderr}"


def whole_lines(path):
    if not os.path.exists(path):
        return 0
    with open(path, "rb") as file:
        return file.read().count(b"\n")


class Judge:
    def __init__(self, editor):
        self.editor = editor
        self.journal = os.path.join(editor.folder, "journal")
        started = time.monotonic()
        self.clean = editor.run(text_of(editor.units), "--journal", self.journal, "--pace", "1")
        self.duration_s = time.monotonic() - started
        self.end = self.clean.hashes[self.clean.lines[-1]]
        # Where each unit ends, as the number of lines that the journal has then.
        ends, steps = [], len(STEADY)
        for unit in editor.units:
            steps += sum(len(event["stroke"]) + 1 if "stroke" in event else 2 for event in unit)
            ends.append(self.clean.lines[steps - 1])
        self.ends = ends

    def faults_of_kill(self, after_s):
        """What is wrong after one kill; None: it came too early or too late to matter."""
        if os.path.exists(self.journal):
            os.unlink(self.journal)
        told = self.editor.run_until_killed(text_of(self.editor.units), after_s, "--journal", self.journal, "--pace", "1")
        lines = whole_lines(self.journal)
        if told is None or lines == 0:
            return None
        faults = []
        if told.lines and lines < told.lines[-1]:
            faults.append(f"{told.lines[-1]} lines were told to be on the disk, there are {lines}")
        found, wanted = self.editor.hash(self.journal), self.clean.hashes.get(lines)
        if found != wanted:
            faults.append(f"{lines} lines lead to {found}, not {wanted}")
        rest = self.units_after(lines)
        again = self.editor.run(text_of(rest), "--recover", self.journal, "--journal", self.journal)
        if rest and again.hashes[again.lines[-1]] != self.end:
            faults.append(f"after {lines} lines the work goes on to another end")
        if rest and self.editor.hash(self.journal) != self.end:
            faults.append(f"after {lines} lines the journal that was gone on with leads to another end")
        return faults

    def units_after(self, lines):
        """Those that a journal of so many lines does not hold. Each is one entry, but for those that only pick a tool."""
        return [unit for unit, end in zip(self.editor.units, self.ends) if end > lines]


def main():
    kills = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    chance, faults, done, tries = random.Random(1), [], 0, 0
    with tempfile.TemporaryDirectory() as folder:
        judge = Judge(Editor(sys.argv[1], folder))
        while done < kills and tries < 3 * kills:
            tries += 1
            found = judge.faults_of_kill(chance.uniform(0.01, 0.95 * judge.duration_s))
            done += found is not None
            faults += found or []
    if done < kills:
        faults.append(f"only {done} of {tries} kills came while there was something to lose")
    for fault in faults[:20]:
        print(f"  {fault}")
    print(f"{kills - min(kills, len(faults))} passed, {len(faults)} failed")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
