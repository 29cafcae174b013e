# SPDX-License-Identifier: Apache-2.0
"""To be run inside Blender: imports each file behind -- and prints what came of it."""
import json
import sys

import bpy
import numpy

# The glTF importer of Blender 3.4 uses names that newer NumPy has dropped.
for name, kind in (("bool", bool), ("int", int), ("float", float), ("object", object)):
    if name not in vars(numpy):
        setattr(numpy, name, kind)

for path in sys.argv[sys.argv.index("--") + 1:]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    try:
        bpy.ops.import_scene.gltf(filepath=path)
    except RuntimeError:
        continue
    meshes = [thing.data for thing in bpy.data.objects if thing.type == "MESH"]
    for mesh in meshes:
        mesh.calc_loop_triangles()
    print("COUNTS " + json.dumps({
        "file": path,
        "loaded": bool(meshes),
        "vertices": sum(len(mesh.vertices) for mesh in meshes),
        "triangles": sum(len(mesh.loop_triangles) for mesh in meshes),
        "materials": len(bpy.data.materials),
        "images": sum(1 for image in bpy.data.images if image.size[0] > 0),
    }), flush=True)
