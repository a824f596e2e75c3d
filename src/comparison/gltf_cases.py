"""Renders small glTF files with Lumbre, and with Blender's importer and Cycles, and prints both.

    python gltf_cases.py [FOLDER]

It needs a Python with bpy and numpy. Each file has one unit sphere or square, seen from the front under a white sky
of radiance 1, or under a black one. The table has the mean of the middle pixels in green.
"""

import base64
import json
import os
import subprocess
import sys

import numpy as np

SIZE = 40
SAMPLES = 128
DEPTH = 16
HOME = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
KHR = "KHR_materials_"


def sphere(rings=96):
    down, around = np.meshgrid(
        np.linspace(0, np.pi, rings + 1), np.linspace(0, 2 * np.pi, 2 * rings + 1), indexing="ij"
    )
    flat = np.sin(down)
    points = np.stack([flat * np.cos(around), np.cos(down), flat * np.sin(around)], -1).reshape(-1, 3)
    row, column = np.meshgrid(np.arange(rings), np.arange(2 * rings), indexing="ij")
    corner = (row * (2 * rings + 1) + column).ravel()
    below = corner + 2 * rings + 1
    upper = np.stack([corner, corner + 1, below], -1)[2 * rings :]
    lower = np.stack([corner + 1, below + 1, below], -1)[: -2 * rings]
    return points, points, np.concatenate([upper, lower])


def square(is_back=False):
    points = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
    normals = np.array([[0, 0, -1 if is_back else 1]] * 4)
    corners = np.array([[0, 1, 2], [0, 2, 3]])
    return points, normals, corners[:, ::-1] if is_back else corners


def plain(color=1.0, metallic=0, roughness=0.5, alpha=1.0, **more):
    base = {
        "baseColorFactor": [color, color, color, alpha],
        "metallicFactor": metallic,
        "roughnessFactor": roughness,
    }
    return {"pbrMetallicRoughness": base, **more}


def extended(material, **extensions):
    return {**material, "extensions": {KHR + name: value for name, value in extensions.items()}}


def glass(color=1.0, roughness=0, is_thin=False, **extensions):
    if not is_thin:
        extensions.setdefault("volume", {"thicknessFactor": 1})
    material = plain(color, 0, roughness, doubleSided=True)
    return extended(material, transmission={"transmissionFactor": 1}, **extensions)


def gltf(mesh, material, colors=None, mode=4, lights=()):
    points, normals, corners = mesh
    arrays = {"POSITION": points, "NORMAL": normals}
    if colors is not None:
        arrays["COLOR_0"] = colors
    data, views, accessors = b"", [], []
    for values in [*arrays.values(), corners.ravel()]:
        is_index = values.ndim == 1
        raw = values.astype("<u4" if is_index else "<f4").tobytes()
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(raw)})
        accessors.append({
            "bufferView": len(accessors),
            "componentType": 5125 if is_index else 5126,
            "count": len(values),
            "type": "SCALAR" if is_index else "VEC%d" % values.shape[1],
        })
        data += raw
    accessors[0].update(min=points.min(axis=0).tolist(), max=points.max(axis=0).tolist())
    primitive = {"attributes": {n: i for i, n in enumerate(arrays)}, "material": 0, "mode": mode}
    if mode == 4:
        primitive["indices"] = len(arrays)
    nodes = [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 12]}]
    nodes += [{"translation": [0, 0, 1], "extensions": {"KHR_lights_punctual": {"light": 0}}}] * len(lights)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    file = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.2, "aspectRatio": 1, "znear": 0.1}}],
        "meshes": [{"primitives": [primitive]}],
        "materials": [material],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(data), "uri": uri}],
        "extensionsUsed": list(material.get("extensions", {})),
    }
    if lights:
        file["extensions"] = {"KHR_lights_punctual": {"lights": list(lights)}}
        file["extensionsUsed"].append("KHR_lights_punctual")
    return file


def hidden():
    file = gltf(sphere(), plain(0.0))
    file["nodes"][0]["extensions"] = {"KHR_node_visibility": {"visible": False}}
    file["nodes"].append({"mesh": 0, "translation": [50, 0, 0]})
    file["scenes"][0]["nodes"].append(len(file["nodes"]) - 1)
    file["extensionsUsed"] = ["KHR_node_visibility"]
    return file


def cases():
    ball, ink = sphere(), {"attenuationDistance": 1, "attenuationColor": [0.5] * 3, "thicknessFactor": 1}
    sheen = {"sheenColorFactor": [1, 1, 1], "sheenRoughnessFactor": 0.5}
    gloss = {"diffuseFactor": [0.8, 0.8, 0.8, 1], "specularFactor": [0.5] * 3, "glossinessFactor": 0.7}
    result = {
        "glass of base color 0.5": gltf(ball, glass(0.5)),
        "thin pane of base color 0.5": gltf(square(), glass(0.5, is_thin=True)),
        "thin bubble of base color 0.5": gltf(ball, glass(0.5, is_thin=True)),
        "absorption, 0.5 per unit, index 1.0001": gltf(ball, glass(volume=ink, ior={"ior": 1.0001})),
        "rough glass 0.6": gltf(ball, glass(roughness=0.6)),
        "black ball, opacity 0.5, one-sided": gltf(ball, plain(0.0, 0, 1, 0.5, alphaMode="BLEND")),
        "black ball, opacity 0.5, double-sided": gltf(
            ball, plain(0.0, 0, 1, 0.5, alphaMode="BLEND", doubleSided=True)
        ),
        "back of a one-sided gray square": gltf(square(True), plain(0.5, 0, 1)),
        "back of a one-sided glowing square, in the dark": gltf(
            square(True), plain(0.0, 0, 1, emissiveFactor=[1, 1, 1])
        ),
        "white sheen 0.5 on black": gltf(ball, extended(plain(0.0, 0, 1), sheen=sheen)),
        "coat on metal 0.8": gltf(ball, extended(plain(0.8, 1), clearcoat={"clearcoatFactor": 1})),
        "black plastic": gltf(ball, plain(0.0, 0, 0.3)),
        "plastic 0.8": gltf(ball, plain(0.8)),
        "specular-glossiness": gltf(ball, extended(plain(), pbrSpecularGlossiness=gloss)),
        "vertex colors 0.25 on 0.8": gltf(ball, plain(0.8), np.full((len(ball[0]), 4), 0.25)),
        "diffuse transmission of all light": gltf(
            ball, extended(plain(0.0, 0, 1), diffuse_transmission={"diffuseTransmissionFactor": 1})
        ),
        "iridescence on metal 0.5": gltf(
            ball,
            extended(plain(0.5, 1, 0.3), iridescence={"iridescenceFactor": 1, "iridescenceIor": 1.8}),
        ),
        "hidden black ball": hidden(),
        "black point": gltf((np.zeros((3, 3)), np.eye(3), np.empty((0, 3))), plain(0.0, 0, 1), mode=0),
        "100 candela before white, in the dark": gltf(
            square(), plain(1.0, 0, 1), lights=[{"type": "point", "intensity": 100}]
        ),
    }
    for roughness in (0.3, 0.5, 1):
        result["white metal, roughness %g" % roughness] = gltf(ball, plain(1.0, 1, roughness))
    return result


def sky(name):
    return 0 if name.endswith("in the dark") else 1


def middle(pixels):
    return float(pixels[14:26, 14:26, 1].mean())


def lumbre(path, name):
    picture = path + ".pfm"
    command = [os.path.join(HOME, "lumbre"), "render", path, "-o", picture, "--overwrite", "--quiet"]
    command += ["--size", "%dx%d" % (SIZE, SIZE), "--samples", str(SAMPLES), "--depth", str(DEPTH)]
    subprocess.run([*command, "--sky", "white", "--sky-intensity", str(sky(name))], check=True)
    with open(picture, "rb") as file:
        values = np.frombuffer(file.read()[-12 * SIZE * SIZE :], "<f4")
    return middle(values.reshape(SIZE, SIZE, 3))


def blender(path, name):
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    scene = bpy.context.scene
    scene.camera = next(item for item in scene.objects if item.type == "CAMERA")
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    nodes = scene.world.node_tree.nodes
    background = nodes.get("Background") or nodes.new("ShaderNodeBackground")
    background.inputs[0].default_value = (1, 1, 1, 1)
    background.inputs[1].default_value = sky(name)
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    cycles.samples, cycles.max_bounces = SAMPLES, DEPTH
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_indirect = cycles.blur_glossy = 0
    for kind in ("diffuse", "glossy", "transmission", "transparent_max"):
        setattr(cycles, kind + "_bounces", DEPTH)
    render.resolution_x = render.resolution_y = SIZE
    render.image_settings.file_format = "OPEN_EXR"
    render.filepath = path + ".exr"
    bpy.ops.render.render(write_still=True)
    values = np.array(bpy.data.images.load(render.filepath).pixels[:])
    return middle(values.reshape(SIZE, SIZE, -1))


def main(folder):
    os.makedirs(folder, exist_ok=True)
    # Blender speaks on standard output.
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    print("| file | Lumbre | Blender |\n|---|--:|--:|", file=answers)
    for i, (name, file) in enumerate(cases().items()):
        path = os.path.join(folder, "case-%02d.gltf" % i)
        with open(path, "w", encoding="ascii") as out:
            json.dump(file, out)
        print("| %s | %.3f | %.3f |" % (name, lumbre(path, name), blender(path, name)), file=answers, flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:] or [os.path.join(HOME, "target", "comparison", "gltf")])
