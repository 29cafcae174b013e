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
    """PrusaSlicer repairs first and then says that all is well, so what it repaired counts, too."""
    verdicts = []
    for path in paths:
        _, text = run(["prusa-slicer", "--info", path])
        figures = dict(re.findall(r"^(\w+) = +(\S+)", text, re.M))
        repairs = [f"{name} {figures[name]}" for name in REPAIRS if figures.get(name, "0") != "0"]
        parts = int(figures.get("number_of_parts", 0))
        is_good = figures.get("manifold") == "yes" and not repairs and (parts == 1 or not is_print) and parts > 0
        is_good = is_good and float(figures.get("volume", 0)) > 0
        said = f"manifold {figures.get('manifold')}, parts {parts}, volume {figures.get('volume')}"
        verdicts.append(Verdict("PrusaSlicer", path, is_good, "; ".join([said] + repairs)))
    return verdicts
