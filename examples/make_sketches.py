#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the example sketches.

  python3 examples/make_sketches.py              write all of examples/sketches and examples/characters
  python3 examples/make_sketches.py goose crab   write only these
  python3 examples/make_sketches.py --check      exit with 1 if a file differs from what would be made

The output is the same to the byte on every machine and with every Python from 3.8 on.
"""

import argparse
import sys
from pathlib import Path

from sketching.sheet import Sheet
from sketching.svg import document
from subjects import birds, fantasy, figures, insects, kitchen, mammals, pets, reptiles, sea, shapes

TOP = Path(__file__).resolve().parent

SKETCHES = {
    "goose": birds.goose,
    "vase": shapes.vase,
    "blob": shapes.blob,
    "noisy_vase": shapes.noisy_vase,
    "spiral": shapes.spiral,
    "butterfly": insects.butterfly,
    "mouse": mammals.mouse,
    "alligator": reptiles.alligator,
    "dove": birds.dove,
    "seahorse": sea.seahorse,
    "crab": sea.crab,
    "octopus": sea.octopus,
    "giraffe": figures.giraffe,
    "monster": figures.monster,
    "letter_s": figures.letter_s,
    "person": figures.person,
}

CHARACTERS = {
    "dog": pets.dog,
    "snail": pets.snail,
    "mug": kitchen.mug,
    "robot": fantasy.robot,
    "dragon": fantasy.dragon,
}

SUBJECTS = {**SKETCHES, **CHARACTERS}


def made(name):
    """The text of one example file."""
    subject = SUBJECTS[name]
    sheet = Sheet(name, subject.__doc__.strip().splitlines()[0])
    subject(sheet)
    return document(sheet).encode()


def differing(names):
    """The files that are missing or differ, and those that nothing makes."""
    found = [n for n in names if not file_of(n).exists() or file_of(n).read_bytes() != made(n)]
    known = [file_of(name) for name in SUBJECTS]
    return found + [f.stem for f in sorted(TOP.glob("*/*.svg")) if f not in known]


def file_of(name):
    return TOP / ("sketches" if name in SKETCHES else "characters") / f"{name}.svg"


def main():
    parser = argparse.ArgumentParser(description="Makes the example sketches.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="only these (default: all)")
    parser.add_argument("--check", action="store_true", help="write nothing, compare")
    options = parser.parse_args()
    unknown = [name for name in options.names if name not in SUBJECTS]
    if unknown:
        parser.error(f"no such sketch: {', '.join(unknown)}; known: {', '.join(SUBJECTS)}")
    names = options.names or list(SUBJECTS)
    if options.check:
        wrong = differing(names)
        for name in wrong:
            print(f"{file_of(name)}: differs; run python3 examples/make_sketches.py", file=sys.stderr)
        return 1 if wrong else 0
    for name in names:
        file_of(name).parent.mkdir(exist_ok=True)
        file_of(name).write_bytes(made(name))
    return 0


if __name__ == "__main__":
    sys.exit(main())
