# SPDX-License-Identifier: Apache-2.0
"""Judges that import: Blender, Godot, assimp and three.js must find in a file what it says it holds."""
import json
import os
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from model_file import glb_counts, triangle_count
from verdict import HERE, Verdict, compare, run


def expected_of(path, names):
    """The counts that a file promises; of a damaged one, that it has any."""
    try:
        counts = glb_counts(path)
    except (ValueError, KeyError, IndexError, AssertionError):
        return {"loaded": True}
    return {name: counts[name] for name in names}


def verdict_of(judge, path, expected, found):
    if found is None:
        return Verdict(judge, path, False, "cannot load it")
    is_good, said = compare(expected, found)
    return Verdict(judge, path, is_good, said)


def marked_lines(text, mark):
    return [json.loads(line[len(mark):]) for line in text.splitlines() if line.startswith(mark)]


def blender(paths):
    """Blender's importer, in one run for all files."""
    command = ["blender", "-b", "--factory-startup", "--python-exit-code", "7", "--python", HERE / "blender_counts.py", "--"]
    # It looks for Python along PATH; its NumPy belongs to the system's.
    surroundings = dict(os.environ, PATH="/usr/bin:/bin")
    _, text = run(command + paths, timeout_s=300, env=surroundings)
    found = {line["file"]: line for line in marked_lines(text, "COUNTS ")}
    names = ["vertices", "triangles", "materials", "images"]
    return [verdict_of("Blender", path, expected_of(path, names), found.get(str(path))) for path in paths]


def godot(paths, import_limit_s=60):
    """Godot imports a project's files when its editor starts. Debian's build may never end by itself, so it is ended."""
    with tempfile.TemporaryDirectory() as name:
        project = Path(name)
        for file in ["project.godot", "count.gd"]:
            shutil.copy(HERE / "godot" / file, project)
        for i, path in enumerate(paths):
            shutil.copy(path, project / f"{i}.glb")
        surroundings = dict(os.environ, HOME=name)
        editor = subprocess.Popen(["godot3-server", "--editor", "--quit", "--path", name], env=surroundings,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        limit = time.monotonic() + import_limit_s
        while len(list(project.glob("*.glb.import"))) < len(paths) and time.monotonic() < limit and editor.poll() is None:
            time.sleep(0.2)
        try:
            editor.wait(timeout=2)
        except subprocess.TimeoutExpired:
            editor.kill()
            editor.wait()
        files = [f"{i}.glb" for i in range(len(paths))]
        _, text = run(["godot3-server", "--path", name, "-s", "count.gd"] + files, env=surroundings)
    found = {line["file"]: line for line in marked_lines(text, "COUNTS ")}
    names = ["vertices", "triangles", "materials", "images"]
    return [verdict_of("Godot", path, expected_of(path, names), found.get(f"{i}.glb")) for i, path in enumerate(paths)]


ASSIMP_NAMES = {"vertices": "Vertices", "triangles": "Faces", "materials": "Materials", "images": r"Textures \(embed.\)"}


def assimp(paths):
    verdicts = []
    for path in paths:
        status, text = run(["assimp", "info", path])
        found = None
        if status == 0:
            figures = {name: re.search(rf"^{word}: *(\d+)", text, re.M) for name, word in ASSIMP_NAMES.items()}
            found = {name: int(match[1]) for name, match in figures.items() if match}
        if path.suffix.lower() == ".glb":
            expected = expected_of(path, list(ASSIMP_NAMES))
        else:
            expected = {"triangles": triangle_count(path)}
        verdicts.append(verdict_of("assimp", path, expected, found))
    return verdicts


def three(paths, is_red_over_blue=False):
    """three.js in headless Chromium. Of a model that wears red above and blue below, it must see it so."""
    _, text = run(["node", HERE / "see_glb.mjs"] + paths, timeout_s=300)
    found = {line["file"]: line for line in marked_lines(text, "")} if text.startswith("{") else {}
    verdicts = []
    for path in paths:
        seen = found.get(str(path), {})
        seen["images"] = seen.get("textures")
        expected = expected_of(path, ["vertices", "triangles", "images"])
        verdict = verdict_of("three.js", path, expected, seen if seen.get("loaded") else None)
        upper, lower = seen.get("upper"), seen.get("lower")
        verdict.said += f"; above it sees {upper}, below {lower}"
        is_seen = bool(upper and lower)
        if is_seen and is_red_over_blue and seen["images"]:
            is_seen = upper[0] > 2 * upper[2] and lower[2] > 2 * lower[0]
        verdict.is_good = verdict.is_good and is_seen
        verdicts.append(verdict)
    return verdicts
