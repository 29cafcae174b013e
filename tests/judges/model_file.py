# SPDX-License-Identifier: Apache-2.0
"""What a model's file says it holds, read without any code of ours that wrote it; and GLB taken apart and put together."""
import json
import re
import struct
import zipfile

JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942


def open_glb(path):
    """The JSON and the bytes of the binary chunk."""
    data = path.read_bytes()
    size, kind = struct.unpack_from("<II", data, 12)
    assert kind == JSON_CHUNK
    return json.loads(data[20:20 + size]), bytearray(data[28 + size:])


def save_glb(path, tree, binary):
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    binary = bytes(binary) + bytes(-len(binary) % 4)
    path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(binary), len(text), JSON_CHUNK) + text
                     + struct.pack("<II", len(binary), BINARY_CHUNK) + binary)


def glb_counts(path):
    tree, _ = open_glb(path)
    primitives = [p for mesh in tree["meshes"] for p in mesh["primitives"]]
    accessors = tree["accessors"]
    return {
        "vertices": sum(accessors[p["attributes"]["POSITION"]]["count"] for p in primitives),
        "triangles": sum(accessors[p["indices"]]["count"] for p in primitives) // 3,
        "materials": len(tree["materials"]),
        "images": len(tree.get("images", [])),
    }


def triangle_count(path):
    kind = path.suffix.lower()
    if kind == ".glb":
        return glb_counts(path)["triangles"]
    if kind == ".stl":
        return struct.unpack_from("<I", path.read_bytes(), 80)[0]
    if kind == ".obj":
        return len(re.findall(r"^f ", path.read_text(), re.M))
    if kind == ".3mf":
        with zipfile.ZipFile(path) as archive:
            return archive.read("3D/3dmodel.model").count(b"<triangle ")
    raise ValueError(f"{path}: not a model")
