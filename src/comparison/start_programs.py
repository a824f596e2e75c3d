"""Renders the Cornell box once with another program, as a command of its own: python start_programs.py PROGRAM SAMPLES SEED OUT.

PROGRAM is mitsuba-llvm, mitsuba-scalar, luxcore or cycles. OUT gets the linear picture as a file of numpy. The scene is read
from scenes/cornell-box.json, whose shapes are given to LuxCore and Cycles as meshes.
"""

import json
import math
import os
import sys
import time

import numpy as np

from nodes import LYING, MIRROR, colour, halves, placed

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scenes", "cornell-box.json")
WIDTH, HEIGHT = 320, 240
DEPTH = 8

# The faces of a cube from -1 to 1, whose corners go around the outward normal.
CUBE = [np.array(face) * 2.0 - 1 for face in (
    [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]],
    [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
    [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]],
    [[0, 1, 0], [0, 1, 1], [1, 1, 1], [1, 1, 0]],
    [[0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]],
    [[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]],
)]
SQUARE = [np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])]


def quads():
    """Returns the corners, reflectance and radiance of each quad, in right-handed space, and the camera."""
    with open(SCENE, encoding="utf-8") as file:
        scene = json.load(file)
    colours = {asset["id"]: colour(asset["color"]) for asset in scene["assets"]}
    result, camera = [], None
    for node, matrix in placed(scene["objects"]):
        kind = node.get("shapeType", node["type"])
        reflectance, radiance = colours.get(node.get("materialID"), np.zeros(3)), np.zeros(3)
        if kind == "Camera":
            camera = node, MIRROR @ matrix
        elif kind == "Light":
            radiance = colour(node["color"]) * node["intensity"]
            faces, local = SQUARE, halves(node, "width", "height")
        elif kind == "Plane":
            faces, local = SQUARE, LYING @ halves(node, "width", "height")
        elif kind == "Cube":
            faces, local = CUBE, halves(node, "width", "height", "depth")
        if kind in ("Light", "Plane", "Cube"):
            for face in faces:
                corners = (MIRROR @ matrix @ local @ np.c_[face, np.ones(4)].T).T[:, :3]
                # The mirror turns faces inside out.
                result.append((corners[::-1], reflectance, radiance))
    return result, camera


def mitsuba(variant, samples, seed):
    import mitsuba as mi

    mi.set_variant(variant)
    from mitsuba_server import Converter

    sampler = "multijitter" if variant.startswith("llvm") else "independent"
    scene = Converter(SCENE, ".").convert(WIDTH, HEIGHT, DEPTH, sampler)
    return np.array(mi.render(scene, spp=samples, seed=seed))


def luxcore(samples, seed):
    import pyluxcore

    pyluxcore.Init()
    scene = pyluxcore.Scene()
    shapes, (camera, view) = quads()
    origin, ahead, up = view[:3, 3], view[:3, 2], view[:3, 1]
    properties = pyluxcore.Properties()

    def set_(key, *values):
        properties.Set(pyluxcore.Property(key, list(values)))

    set_("scene.camera.type", "perspective")
    set_("scene.camera.lookat.orig", *map(float, origin))
    set_("scene.camera.lookat.target", *map(float, origin + ahead))
    set_("scene.camera.up", *map(float, up))
    # LuxCore's angle is that of the longer side.
    half = math.tan(math.radians(camera["fieldOfView"] / 2)) * WIDTH / HEIGHT
    set_("scene.camera.fieldofview", 2 * math.degrees(math.atan(half)))
    set_("scene.camera.autofocus.enable", False)
    for i, (corners, reflectance, radiance) in enumerate(shapes):
        scene.DefineMesh(f"mesh{i}", [tuple(map(float, c)) for c in corners], [(0, 1, 2), (0, 2, 3)], None, None, None, None)
        set_(f"scene.materials.m{i}.type", "matte")
        set_(f"scene.materials.m{i}.kd", *map(float, reflectance))
        if radiance.any():
            set_(f"scene.materials.m{i}.emission", *map(float, radiance))
        set_(f"scene.objects.o{i}.shape", f"mesh{i}")
        set_(f"scene.objects.o{i}.material", f"m{i}")
    scene.Parse(properties)
    properties = pyluxcore.Properties()
    set_("renderengine.type", "PATHCPU")
    set_("renderengine.seed", seed + 1)
    set_("sampler.type", "SOBOL")
    set_("film.width", WIDTH)
    set_("film.height", HEIGHT)
    set_("film.filter.type", "NONE")
    set_("film.imagepipeline.0.type", "NOP")
    set_("path.pathdepth.total", DEPTH + 1)
    set_("path.pathdepth.diffuse", DEPTH + 1)
    set_("batch.haltspp", samples)
    session = pyluxcore.RenderSession(pyluxcore.RenderConfig(properties, scene))
    session.Start()
    while not session.HasDone():
        time.sleep(0.01)
        session.UpdateStats()
    session.Stop()
    image = np.zeros(WIDTH * HEIGHT * 3, dtype=np.float32)
    session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB, image)
    # Upside down, and one row too low.
    picture = image.reshape(HEIGHT, WIDTH, 3)[::-1]
    return np.concatenate([picture[1:], picture[-1:]])


def cycles(samples, seed, out):
    import bpy
    import mathutils

    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    shapes, (camera, view) = quads()
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit, lens.angle_y = "VERTICAL", math.radians(camera["fieldOfView"])
    eye = bpy.data.objects.new("camera", lens)
    # A camera of Blender looks along its -z axis, so that its x axis turns, too.
    eye.matrix_world = mathutils.Matrix((view @ np.diag([1, 1, -1, 1])).tolist())
    scene.collection.objects.link(eye)
    scene.camera = eye
    for i, (corners, reflectance, radiance) in enumerate(shapes):
        mesh = bpy.data.meshes.new(f"mesh{i}")
        mesh.from_pydata(corners.tolist(), [], [[0, 1, 2, 3]])
        mesh.materials.append(material(bpy, f"material{i}", reflectance, radiance))
        scene.collection.objects.link(bpy.data.objects.new(f"object{i}", mesh))
    render, engine = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y, render.resolution_percentage = WIDTH, HEIGHT, 100
    render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
    engine.samples, engine.seed = samples, seed
    engine.use_adaptive_sampling = engine.use_denoising = False
    engine.pixel_filter_type, engine.filter_width = "BOX", 1
    engine.sample_clamp_direct = engine.sample_clamp_indirect = engine.blur_glossy = 0
    engine.max_bounces = engine.diffuse_bounces = DEPTH - 1
    render.filepath = out + ".exr"
    bpy.ops.render.render(write_still=True)


def material(bpy, name, reflectance, radiance):
    """Returns a diffuse material that emits from its front."""
    result = bpy.data.materials.new(name)
    result.use_nodes = True
    nodes, links = result.node_tree.nodes, result.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    if not radiance.any():
        diffuse = nodes.new("ShaderNodeBsdfDiffuse")
        diffuse.inputs["Color"].default_value = [*reflectance, 1]
        links.new(diffuse.outputs[0], output.inputs["Surface"])
        return result
    emission, geometry, front = (nodes.new("ShaderNode" + kind) for kind in ("Emission", "NewGeometry", "Math"))
    front.operation, front.inputs[0].default_value = "SUBTRACT", 1
    emission.inputs["Color"].default_value = [*(radiance / max(radiance)), 1]
    scale = nodes.new("ShaderNodeMath")
    scale.operation, scale.inputs[1].default_value = "MULTIPLY", max(radiance)
    links.new(geometry.outputs["Backfacing"], front.inputs[1])
    links.new(front.outputs[0], scale.inputs[0])
    links.new(scale.outputs[0], emission.inputs["Strength"])
    links.new(emission.outputs[0], output.inputs["Surface"])
    return result


def main(program, samples, seed, out):
    if program == "cycles":
        return cycles(samples, seed, out)
    if program == "luxcore":
        image = luxcore(samples, seed)
    else:
        image = mitsuba({"mitsuba-llvm": "llvm_ad_rgb", "mitsuba-scalar": "scalar_rgb"}[program], samples, seed)
    np.save(out, image.astype(np.float32))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4])
