# SPDX-License-Identifier: Apache-2.0
"""Judges of what a file says: the glTF validator, ADMesh and PrusaSlicer."""
import re

from verdict import HERE, Verdict, run


def gltf_validator(paths):
    """Khronos' validator must have nothing to say, not even a hint."""
    verdicts = []
    for path in paths:
        status, text = run(["node", HERE / "validate_glb.mjs", path])
        said = " ".join(text.split(": ", 1)[-1].split())
        verdicts.append(Verdict("glTF validator", path, status == 0, said[:300]))
    return verdicts


ADMESH_FAULTS = ["Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed", "Facets added",
                 "Facets reversed", "Backwards edges", "Normals fixed"]


def admesh(paths, is_print=False):
    """ADMesh must have nothing to repair. Its exit status tells nothing."""
    verdicts = []
    for path in paths:
        _, text = run(["admesh", path])
        figures = {name: re.search(rf"{name} *: *(-?[0-9.]+)", text) for name in ADMESH_FAULTS + ["Number of parts"]}
        volume = re.search(r"Volume *: *(-?[0-9.]+)", text)
        if not volume or not all(figures.values()):
            verdicts.append(Verdict("ADMesh", path, False, "cannot be read"))
            continue
        faults = [f"{name}: {figures[name][1]}" for name in ADMESH_FAULTS if figures[name][1] != "0"]
        parts = int(figures["Number of parts"][1])
        if is_print and parts != 1:
            faults.append("a print is one part")
        said = f"{parts} part{'s' * (parts > 1)}, volume {float(volume[1]):.0f}; " + ("; ".join(faults) or "nothing to repair")
        verdicts.append(Verdict("ADMesh", path, not faults and float(volume[1]) > 0, said))
    return verdicts


REPAIRS = ["open_edges", "degenerate_facets", "edges_fixed", "facets_removed", "facets_reversed", "backwards_edges"]


def prusa_slicer(paths, is_print=False):
    """PrusaSlicer repairs first and then says that all is well, so what it repaired counts, too. It tells of each object apart."""
    verdicts = []
    for path in paths:
        _, text = run(["prusa-slicer", "--info", path])
        objects = [dict(re.findall(r"^(\w+) = +(\S+)", part, re.M)) for part in re.split(r"^\[[^]]*\]$", text, flags=re.M)[1:]]
        repairs = [f"{name} {figures[name]}" for figures in objects for name in REPAIRS if figures.get(name, "0") != "0"]
        parts = sum(int(figures.get("number_of_parts", 0)) for figures in objects)
        volumes = [float(figures.get("volume", 0)) for figures in objects]
        is_manifold = bool(objects) and all(figures.get("manifold") == "yes" for figures in objects)
        is_good = is_manifold and not repairs and min(volumes) > 0 and (parts == 1 or not is_print)
        said = f"manifold {'yes' if is_manifold else 'no'}, parts {parts}, volume {sum(volumes):.0f}"
        verdicts.append(Verdict("PrusaSlicer", path, is_good, "; ".join([said] + repairs)))
    return verdicts
