"""Renders a scene of Lumbre's with Cycles (bpy), with what a denoiser needs.

    python cycles_scene.py SCENE.json WIDTH HEIGHT SAMPLES SEED OUT

OUT.pfm gets the light, OUT.albedo.pfm and OUT.normal.pfm the guides. cycles_server.py tells which scenes it knows.
"""

import json
import os
import sys
import tempfile

import bpy
import numpy as np
import OpenEXR

from cycles_server import Converter, set_up


def write(path, values):
    with open(path, "wb") as out:
        out.write(b"PF\n%d %d\n-1.0\n" % (values.shape[1], values.shape[0]))
        out.write(values[::-1].astype("<f4").tobytes())


def main():
    path, width, height, samples, seed, out = sys.argv[1:]
    with open(path, encoding="utf-8") as file:
        depth = json.load(file)["renderOptions"]["maxTraceDepth"]
    Converter(os.path.abspath(path))
    set_up(int(width), int(height), depth)
    scene = bpy.context.scene
    scene.cycles.samples, scene.cycles.seed = int(samples), int(seed)
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
