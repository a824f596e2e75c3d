"""Renders the Cornell box once with another program, as a command of its own: python start_programs.py PROGRAM SAMPLES SEED OUT.

PROGRAM is mitsuba-llvm, mitsuba-scalar, luxcore or cycles, which uses all processors. OUT gets the linear picture as a file of
numpy, or as OUT.exr by Cycles.
"""

import os
import sys

import numpy as np

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scenes", "cornell-box.json")
SIZE = 320, 240
DEPTH = 8


def mitsuba(variant, samples, seed):
    import mitsuba as mi

    mi.set_variant(variant)
    from mitsuba_server import Converter

    sampler = "multijitter" if variant.startswith("llvm") else "independent"
    scene = Converter(SCENE, ".").convert(*SIZE, DEPTH, sampler)
    return np.array(mi.render(scene, spp=samples, seed=seed))


def luxcore(samples, seed):
    import luxcore_server

    luxcore_server.pyluxcore.Init()
    scene = luxcore_server.Converter(SCENE, ".", *SIZE).scene
    return luxcore_server.render(scene, SIZE, DEPTH, samples, seed, threads=0)[0]


def cycles(samples, seed, out):
    import bpy
    from cycles_server import Converter, set_up

    Converter(SCENE)
    set_up(*SIZE, DEPTH, threads=0)
    bpy.context.scene.cycles.samples, bpy.context.scene.cycles.seed = samples, seed
    bpy.context.scene.render.filepath = out + ".exr"
    bpy.ops.render.render(write_still=True)


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
