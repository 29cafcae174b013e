#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge.py [--all] [--print] [--red-over-blue] FILE...: what programs of others say of model files.

Without --all only the quick judges speak: the glTF validator and ADMesh. With it also assimp, Blender, Godot, three.js and
PrusaSlicer. --print: the files are meant to be printed, so each is one part. --red-over-blue: models wear red above, blue below.
The last line counts; exits 1 if a judge said no.
"""
import argparse
import sys
from pathlib import Path

import importers
import validators


def with_suffix(paths, *suffixes):
    return [path for path in paths if path.suffix.lower() in suffixes]


def sessions(options):
    """One call for each judge that has files to judge."""
    paths = options.files
    glb, stl = with_suffix(paths, ".glb"), with_suffix(paths, ".stl")
    prints = stl + with_suffix(paths, ".3mf")
    yield lambda: validators.gltf_validator(glb)
    yield lambda: validators.admesh(stl, options.print)
    if not options.all:
        return
    yield lambda: importers.assimp(paths)
    if glb:
        yield lambda: importers.blender(glb)
        yield lambda: importers.godot(glb)
        yield lambda: importers.three(glb, options.red_over_blue)
    yield lambda: validators.prusa_slicer(prints, options.print)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--print", action="store_true")
    parser.add_argument("--red-over-blue", action="store_true")
    parser.add_argument("files", nargs="+", type=Path)
    verdicts = []
    for session in sessions(parser.parse_args()):
        for verdict in session():
            print(verdict, flush=True)
            verdicts.append(verdict)
    bad = sum(not verdict.is_good for verdict in verdicts)
    print(f"{len(verdicts) - bad} passed, {bad} failed")
    return 1 if bad or not verdicts else 0


if __name__ == "__main__":
    sys.exit(main())
