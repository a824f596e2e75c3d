"""Reads Lumbre's layers with programs of others, and compares what they find.

OpenEXR's own package reads the channels, cryptomatte-api decodes the mattes, mmh3 computes the ids of their names, and
Blender's compositor, if --blender names a Python with bpy, decodes the mattes once more. Exits with 1 if any differs.
"""

import argparse
import pathlib
import subprocess
import sys

HOME = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = 16
SIZES = {"scenes/cornell-box.json": (96, 72), "scenes/camera-thin-lens.json": (48, 32), "scenes/glass-and-mirror.json": (64, 48)}

# Runs in Blender's Python: each matte of each layer as an OpenEXR file of its own.
BLENDER = """
import bpy, sys
path, width, height, folder, *mattes = sys.argv[1:]
scene = bpy.context.scene
render = scene.render
render.resolution_x, render.resolution_y, render.resolution_percentage = int(width), int(height), 100
render.image_settings.file_format, render.image_settings.color_depth = 'OPEN_EXR', '32'
render.engine, scene.cycles.samples = 'CYCLES', 1
nodes = scene.compositing_node_group = bpy.data.node_groups.new('mattes', 'CompositorNodeTree')
nodes.interface.new_socket('Image', in_out='OUTPUT', socket_type='NodeSocketColor')
matte = nodes.nodes.new('CompositorNodeCryptomatteV2')
matte.source, matte.image = 'IMAGE', bpy.data.images.load(path)
nodes.links.new(matte.outputs['Matte'], nodes.nodes.new('NodeGroupOutput').inputs[0])
scene.camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
scene.collection.objects.link(scene.camera)
for i in range(0, len(mattes), 2):
    matte.layer_name, matte.matte_id = mattes[i:i + 2]
    render.filepath = f'{folder}/{i // 2}.exr'
    bpy.ops.render.render(write_still=True)
"""


def pixels(path):
    """Returns the channels of an OpenEXR file by name, as OpenEXR's own package reads them."""
    import OpenEXR

    with OpenEXR.File(str(path), separate_channels=True) as file:
        return {name: channel.pixels for name, channel in file.channels().items()}


def encoded(name):
    """Returns the id of a name as Cryptomatte 1.2 defines it: never the bits of an infinite or subnormal float."""
    import mmh3

    bits = mmh3.hash(name, signed=False)
    return bits ^ 1 << 23 if bits >> 23 & 0xFF in (0, 0xFF) else bits


class Report:
    """Prints what was compared, and keeps whether all of it was equal."""

    def __init__(self):
        self.failures = 0

    def check(self, what, difference, limit):
        self.failures += not difference <= limit
        print(f"  {what}: {difference:.3g}{'' if difference <= limit else f', MORE THAN {limit:.3g}'}")


def check_sums(report, channels):
    import numpy as np

    report.check("Cryptomatte channels not of 32 bits", sum(p.dtype != np.float32 for n, p in channels.items() if n.startswith("Crypto")), 0)
    for channel in "RGB":
        picture = channels[channel].astype(float)
        groups = sum(p.astype(float) for n, p in channels.items() if n.startswith("lights.") and n.endswith("." + channel))
        parts = channels["direct." + channel].astype(float) + channels["indirect." + channel]
        report.check(f"{channel}: light groups beside the picture", np.max(np.abs(groups - picture) / (1 + picture)), 1e-6)
        report.check(f"{channel}: direct and indirect beside the picture", np.max(np.abs(parts - picture) / (1 + picture)), 1e-6)


def check_mattes(report, layer, mattes, ours, channels):
    """Compares the mattes that cryptomatte-api finds with our masks, with whole numbers of samples and with the ids."""
    import numpy as np
    from PIL import Image

    masks = mattes.masks()
    known = {int(np.float32(v).view(np.uint32)) for n, p in channels.items() if n.startswith(layer) and n[-1] in "RB" for v in np.unique(p)}
    report.check(f"{layer}: names whose id is in no pixel", sum(encoded(name) not in known for name in masks), 0)
    counts = [mask * float(SAMPLES) for mask in masks.values()]
    report.check(f"{layer}: parts of a sample", max(np.max(np.abs(c - np.round(c))) for c in counts), 1e-5)
    report.check(f"{layer}: coverage beyond 1", float(np.max(sum(masks.values()))) - 1, 1e-6)
    worst = 0
    for name, mask in masks.items():
        png = ours / f"{layer.removeprefix('Crypto').lower()}-{name.replace(' ', '_')}.png"
        worst = max(worst, np.max(np.abs(np.asarray(Image.open(png)) / 255.0 - mask)))
    report.check(f"{layer}: {len(masks)} mattes beside our masks", worst, 0.5 / 255 + 1e-6)


def check_blender(report, python, path, size, mattes, folder):
    import numpy as np

    folder.mkdir(exist_ok=True)
    names = [(layer, name) for layer, one in mattes.items() for name in one.masks()]
    arguments = [str(path), *map(str, size), str(folder), *(word for pair in names for word in pair)]
    subprocess.run([python, "-c", BLENDER, *arguments], check=True, stdout=subprocess.DEVNULL)
    worst = 0
    for i, (layer, name) in enumerate(names):
        channels = pixels(folder / f"{i}.exr")
        worst = max(worst, np.max(np.abs(channels["R"] - mattes[layer].mask(name))))
    report.check(f"Blender: {len(names)} mattes beside cryptomatte-api's", worst, 1e-6)


def main():
    import cryptomatte_api

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--blender", metavar="PYTHON", help="a Python with bpy 5")
    arguments = parser.parse_args()
    work = HOME / "target" / "comparison" / "layers"
    work.mkdir(parents=True, exist_ok=True)
    report = Report()
    for scene, size in SIZES.items():
        print(scene)
        path = work / (pathlib.Path(scene).stem + ".exr")
        lumbre = [str(HOME / "lumbre")]
        flags = ["--size", "{}x{}".format(*size), "-s", str(SAMPLES), "--layers", "all", "--progress", "none", "--overwrite"]
        subprocess.run([*lumbre, "render", str(HOME / scene), *flags, "-o", str(path)], check=True, stderr=subprocess.DEVNULL)
        ours = work / path.stem
        subprocess.run([*lumbre, "layers", str(path), "--png", str(ours), "--overwrite"], check=True, stdout=subprocess.DEVNULL)
        channels = pixels(path)
        check_sums(report, channels)
        mattes = {one.metadata().name(): one for one in cryptomatte_api.Cryptomatte.load(str(path))}
        report.check("missing mattes", len({"CryptoObject", "CryptoMaterial"} ^ mattes.keys()), 0)
        for name, matte in mattes.items():
            check_mattes(report, name, matte, ours, channels)
        if arguments.blender:
            check_blender(report, arguments.blender, path, size, mattes, work / "blender")
    return 1 if report.failures else 0


if __name__ == "__main__":
    sys.exit(main())
