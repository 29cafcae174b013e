#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""planted_faults.py [--all] GOOD.glb GOOD.stl: damages good files in every way that a judge is there for; the judge must say no.

GOOD.glb wears red above and blue below; GOOD.stl is one part. Without --all only the quick judges are tried.
The last line counts; exits 1 if a judge let a fault pass.
"""
import argparse
import struct
import sys
import tempfile
from pathlib import Path

import importers
import validators
from model_file import open_glb, save_glb

FACET = 50


def facets_of(path):
    data = path.read_bytes()
    return [data[84 + FACET * i:84 + FACET * (i + 1)] for i in range(struct.unpack_from("<I", data, 80)[0])]


def save_stl(path, facets):
    path.write_bytes(b"planted fault".ljust(80) + struct.pack("<I", len(facets)) + b"".join(facets))


def turned(facet):
    """Seen from the other side: two corners swapped and the normal reversed, so that it agrees with them."""
    normal = struct.pack("<3f", *(-part for part in struct.unpack_from("<3f", facet)))
    return normal + facet[12:24] + facet[36:48] + facet[24:36] + facet[48:]


def moved(facet, shift):
    numbers = list(struct.unpack_from("<12f", facet))
    for corner in (3, 6, 9):
        numbers[corner] += shift
    return struct.pack("<12f", *numbers) + facet[48:]


STL_FAULTS = {
    "hole": lambda facets: facets[1:],
    "flipped_facet": lambda facets: [turned(facets[0])] + facets[1:],
    "doubled_facet": lambda facets: facets + facets[:1],
    "two_parts": lambda facets: facets + [moved(facet, 1000.0) for facet in facets],
}


def accessor_of(tree, name):
    primitive = tree["meshes"][0]["primitives"][0]
    return tree["accessors"][primitive["indices"] if name == "indices" else primitive["attributes"][name]]


def start_of(tree, name):
    return tree["bufferViews"][accessor_of(tree, name)["bufferView"]]["byteOffset"]


def wrong_bounds(tree, _):
    accessor_of(tree, "POSITION")["max"][0] /= 2


def dangling_mesh(tree, _):
    tree["nodes"][0]["mesh"] = 7


def dangling_index(tree, binary):
    struct.pack_into("<H", binary, start_of(tree, "indices"), accessor_of(tree, "POSITION")["count"])


def no_number(tree, binary):
    struct.pack_into("<f", binary, start_of(tree, "POSITION"), float("nan"))


def long_normal(tree, binary):
    struct.pack_into("<3f", binary, start_of(tree, "NORMAL"), 3, 0, 0)


def accessor_too_long(tree, _):
    accessor_of(tree, "indices")["count"] += 3000


def flipped_texture(tree, binary):
    start = start_of(tree, "TEXCOORD_0")
    for i in range(accessor_of(tree, "TEXCOORD_0")["count"]):
        at = start + 8 * i + 4
        struct.pack_into("<f", binary, at, 1 - struct.unpack_from("<f", binary, at)[0])


def no_texture_places(tree, _):
    del tree["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"]


def unused_picture(tree, _):
    del tree["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]


VALIDATOR = validators.gltf_validator
ALL_IMPORTERS = [importers.assimp, importers.godot, importers.blender, importers.three]

# Each fault with the judges who have to see it.
GLB_FAULTS = [
    (wrong_bounds, [VALIDATOR]),
    (dangling_mesh, [VALIDATOR, importers.assimp, importers.godot, importers.three]),
    (dangling_index, [VALIDATOR]),
    (accessor_too_long, [VALIDATOR] + ALL_IMPORTERS),
    (no_number, [VALIDATOR]),
    (long_normal, [VALIDATOR]),
    (no_texture_places, [VALIDATOR]),
    (unused_picture, [VALIDATOR, importers.godot, importers.three]),
    (flipped_texture, [lambda paths: importers.three(paths, is_red_over_blue=True)]),
]


def cases(good_glb, good_stl, folder, is_all):
    """Each damaged file with a judge that has to refuse it."""
    for name, damage in STL_FAULTS.items():
        path = folder / f"{name}.stl"
        save_stl(path, damage(facets_of(good_stl)))
        yield path, lambda paths: validators.admesh(paths, is_print=True)
        if is_all:
            yield path, lambda paths: validators.prusa_slicer(paths, is_print=True)
    inside_out = folder / "inside_out.stl"
    save_stl(inside_out, [turned(facet) for facet in facets_of(good_stl)])
    yield inside_out, validators.admesh
    for damage, judges in GLB_FAULTS:
        tree, binary = open_glb(good_glb)
        damage(tree, binary)
        path = folder / f"{damage.__name__}.glb"
        save_glb(path, tree, binary)
        for judge in judges:
            if is_all or judge is VALIDATOR:
                yield path, judge
    cut_off = folder / "cut_off.glb"
    cut_off.write_bytes(good_glb.read_bytes()[:-100])
    for judge in [VALIDATOR] + (ALL_IMPORTERS if is_all else []):
        yield cut_off, judge


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("good_glb", type=Path)
    parser.add_argument("good_stl", type=Path)
    options = parser.parse_args()
    missed = seen = 0
    with tempfile.TemporaryDirectory() as name:
        for path, judge in cases(options.good_glb, options.good_stl, Path(name), options.all):
            verdict = judge([path])[0]
            missed += verdict.is_good
            seen += not verdict.is_good
            print(f"{'MISSED' if verdict.is_good else 'seen  '} {verdict.judge:14} {path.name}: {verdict.said}", flush=True)
    print(f"{seen} passed, {missed} failed")
    return 1 if missed or not seen else 0


if __name__ == "__main__":
    sys.exit(main())
