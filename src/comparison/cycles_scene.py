"""Renders a scene of Lumbre's with Cycles (bpy), with what a denoiser needs.

    python cycles_scene.py SCENE.json WIDTH HEIGHT SAMPLES SEED OUT

OUT.pfm gets the light, OUT.albedo.pfm and OUT.normal.pfm the guides. Knows what cornell-box has: planes, cubes,
one-sided rectangular lights, matte surfaces, a pinhole; all else is refused. Paths have as many bounces as
Lumbre's, pixels are boxes, nothing is clamped.
"""

import json
import os
import sys
import tempfile

import bpy
import numpy as np
import OpenEXR
from mathutils import Matrix

from nodes import LYING, MIRROR, colour, halves, placed, rotation

SQUARE = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
CORNERS = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def refuse(what):
    raise ValueError("Cycles is not given: " + str(what))


def add(vertices, faces, matrix, material):
    mesh = bpy.data.meshes.new("mesh")
    points = [(MIRROR @ matrix @ np.array([*v, 1.0]))[:3].tolist() for v in vertices]
    mesh.from_pydata(points, [], faces)
    mesh.materials.append(material)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("object", mesh))


def matte(asset):
    if asset["materialType"] != "Diffuse" or asset.get("colorTextureId") is not None:
        refuse(asset)
    material = bpy.data.materials.new("matte")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    surface = tree.nodes.new("ShaderNodeBsdfDiffuse")
    surface.inputs["Color"].default_value = (*colour(asset.get("color")), 1)
    surface.inputs["Roughness"].default_value = 0
    out = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(surface.outputs[0], out.inputs["Surface"])
    return material


def glowing(node):
    """Light from the front alone; the back is black."""
    material = bpy.data.materials.new("light")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    emission = tree.nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = (*colour(node.get("color")), 1)
    side = tree.nodes.new("ShaderNodeNewGeometry")
    front = tree.nodes.new("ShaderNodeMath")
    front.operation = "MULTIPLY_ADD"
    front.inputs[1].default_value = -node.get("intensity", 0)
    front.inputs[2].default_value = node.get("intensity", 0)
    tree.links.new(side.outputs["Backfacing"], front.inputs[0])
    tree.links.new(front.outputs[0], emission.inputs["Strength"])
    out = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(emission.outputs[0], out.inputs["Surface"])
    return material


def build(path):
    with open(path, encoding="utf-8") as file:
        scene = json.load(file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    assets = {asset["id"]: asset for asset in scene["assets"]}
    for node, matrix in placed(scene["objects"]):
        kind = node.get("type", "None")
        if kind == "Shape" and node["shapeType"] == "Plane" and node.get("finite"):
            size = LYING @ halves(node, "width", "height")
            add(SQUARE, [(0, 1, 2, 3)], matrix @ size, matte(assets[node["materialID"]]))
        elif kind == "Shape" and node["shapeType"] == "Cube":
            size = halves(node, "width", "height", "depth")
            add(CORNERS, SIDES, matrix @ size, matte(assets[node["materialID"]]))
        elif kind == "Light" and node["lightType"] == "Rectangle" and node.get("unit") == "radiance":
            # Mirrored, so that the order of the corners turns the front around.
            add(SQUARE, [(3, 2, 1, 0)], matrix @ halves(node, "width", "height"), glowing(node))
        elif kind == "Camera":
            look(node, matrix)
        elif kind != "None":
            refuse(node)
    return scene["renderOptions"]


def look(node, matrix):
    if node.get("cameraType") != "Pinhole":
        refuse(node)
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle = np.radians(node["fieldOfView"])
    camera.clip_start = 1e-3
    item = bpy.data.objects.new("camera", camera)
    # Blender's cameras look along -z.
    item.matrix_world = Matrix((MIRROR @ matrix @ MIRROR @ rotation(1, 180)).tolist())
    bpy.context.scene.collection.objects.link(item)
    bpy.context.scene.camera = item


def write(path, values):
    with open(path, "wb") as out:
        out.write(b"PF\n%d %d\n-1.0\n" % (values.shape[1], values.shape[0]))
        out.write(values[::-1].astype("<f4").tobytes())


def main():
    path, width, height, samples, seed, out = sys.argv[1:]
    options = build(path)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = int(width), int(height)
    scene.render.resolution_percentage = 100
    cycles = scene.cycles
    cycles.samples, cycles.seed = int(samples), int(seed)
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = cycles.diffuse_bounces = options["maxTraceDepth"] - 1
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 1.0
    scene.view_layers[0].cycles.denoising_store_passes = True
    scene.render.image_settings.media_type = "MULTI_LAYER_IMAGE"
    scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
    scene.render.image_settings.color_depth = "32"
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = os.path.join(folder, "picture.exr")
        bpy.ops.render.render(write_still=True)
        with OpenEXR.File(scene.render.filepath, separate_channels=True) as file:
            parts = [file.channels(i) for i in range(len(file.parts))]
            channels = {name: c.pixels for part in parts for name, c in part.items()}
    for name, ends, suffix in (
        ("Combined", "RGB", ""),
        ("Denoising Albedo", "RGB", ".albedo"),
        ("Denoising Normal", "XYZ", ".normal"),
    ):
        planes = [next(v for k, v in channels.items() if k.endswith(name + "." + e)) for e in ends]
        write(out + suffix + ".pfm", np.stack(planes, axis=-1))


if __name__ == "__main__":
    main()
