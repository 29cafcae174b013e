# SPDX-License-Identifier: Apache-2.0
# Loads what the editor imported and prints what a game would get.
extends SceneTree

func _init():
	for file in OS.get_cmdline_args():
		if file.ends_with(".glb"):
			print("COUNTS ", to_json(counts(file)))
	quit()

func counts(file):
	var scene = load("res://" + file)
	var sums = {"file": file, "loaded": scene != null, "vertices": 0, "triangles": 0, "materials": 0, "images": 0}
	var rest = [scene.instance()] if scene != null else []
	while not rest.empty():
		var node = rest.pop_back()
		rest += node.get_children()
		if node is MeshInstance and node.mesh != null:
			add_mesh(sums, node.mesh)
	return sums

func add_mesh(sums, mesh):
	for i in mesh.get_surface_count():
		var arrays = mesh.surface_get_arrays(i)
		var material = mesh.surface_get_material(i)
		sums.vertices += arrays[Mesh.ARRAY_VERTEX].size()
		sums.triangles += arrays[Mesh.ARRAY_INDEX].size() / 3
		sums.materials += 1 if material != null else 0
		sums.images += 1 if material != null and material.albedo_texture != null else 0
