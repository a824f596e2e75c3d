"""Renders models with another program: python model_programs.py PROGRAM OUT MODEL ...

PROGRAM is f3d, a rasterizer, which draws each model in one process, and prints the processor time in seconds of each; or cycles,
which renders one model with 8 samples and Open Image Denoise. OUT is a PNG file, that of the last model.
"""

import os
import sys
import time


def f3d(out, models):
    import f3d

    engine = f3d.Engine.create_egl()
    engine.window.size = (256, 192)
    for model in models:
        start = time.process_time()
        engine.scene.clear()
        engine.scene.add(model)
        engine.window.render_to_image().save(out)
        print("seconds", time.process_time() - start)


def cycles(out, models):
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=os.path.abspath(models[0]))
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    camera.rotation_euler = (1.1, 0, 0.8)
    scene.camera = camera
    for found in scene.objects:
        found.select_set(found.type == "MESH")
    scene.render.resolution_x = scene.render.resolution_y = 512
    bpy.context.view_layer.update()
    corners = [found.matrix_world @ corner for found in scene.objects if found.type == "MESH" for corner in map(vector, found.bound_box)]
    place, _ = camera.camera_fit_coords(bpy.context.evaluated_depsgraph_get(), [number for corner in corners for number in corner])
    camera.location = place
    extent = max(max(corner[axis] for corner in corners) - min(corner[axis] for corner in corners) for axis in range(3))
    camera.data.clip_start, camera.data.clip_end = extent / 1000, extent * 1000
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 8
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = True
    scene.cycles.denoiser = "OPENIMAGEDENOISE"
    scene.render.filepath = os.path.abspath(out)
    bpy.ops.render.render(write_still=True)


def vector(corner):
    from mathutils import Vector

    return Vector(corner)


if __name__ == "__main__":
    {"f3d": f3d, "cycles": cycles}[sys.argv[1]](sys.argv[2], sys.argv[3:])
