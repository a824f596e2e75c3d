"""Writes lossy OpenEXR files with OpenEXR's own package, and prints hashes of the values that it reads from those of ExrLossyTest.

A hash is that of all channels in the order of their names, each as 32-bit floats line by line.
"""

import hashlib
import pathlib
import sys

import numpy as np
import OpenEXR

FILES = {
    "pxr24": (OpenEXR.PXR24_COMPRESSION, 9, 19, None),
    "b44": (OpenEXR.B44_COMPRESSION, 6, 35, None),
    "b44a": (OpenEXR.B44A_COMPRESSION, 6, 35, None),
    "dwaa": (OpenEXR.DWAA_COMPRESSION, 11, 35, None),
    "dwab": (OpenEXR.DWAB_COMPRESSION, 3, 259, None),
    "dwaa-tiles": (OpenEXR.DWAA_COMPRESSION, 13, 14, (8, 11)),
}
CHANNELS = {
    "R": "f2", "G": "f2", "B": "f2", "A": "f2",
    "diffuse.R": "f4", "diffuse.G": "f4", "diffuse.B": "f4",
    "even.Y": "f2", "linear.Y": "f2", "Z": "f4", "id": "u4",
}


def channel(name, kind, width, height, number):
    """Returns waves of a channel, with halves of all kinds in R, and long runs in A."""
    y, x = np.mgrid[0:height, 0:width].astype("f8")
    wave = np.exp(2 * np.sin(x / 5 + number) * np.cos(y / 7 - number))
    if name == "R":
        wave[0, 0:3] = [np.nan, np.inf, -np.inf]
        wave[1, 0:3] = [-0.25, 65504, 6e-8]
    if name in ("A", "even.Y"):
        wave = np.where(y < 5, 1, 0.25)
    if name == "id":
        wave = np.floor(wave * 1e9)
    return OpenEXR.Channel(wave.astype(kind), 1, 1, name == "linear.Y")


def write(path, compression, width, height, tile):
    """Writes a file, and returns the hash of what is read from it."""
    header = {"compression": compression, "type": OpenEXR.tiledimage if tile else OpenEXR.scanlineimage}
    if tile:
        header["tiles"] = OpenEXR.TileDescription()
        header["tiles"].xSize, header["tiles"].ySize = tile
    channels = {name: channel(name, kind, width, height, i) for i, (name, kind) in enumerate(CHANNELS.items())}
    OpenEXR.File(header, channels).write(str(path))
    read = OpenEXR.File(str(path), separate_channels=True).channels()
    digest = hashlib.sha256()
    for name in sorted(read):
        digest.update(read[name].pixels.astype("<f4").tobytes())
    return digest.hexdigest()


for file, options in FILES.items():
    print(file, write(pathlib.Path(sys.argv[1]) / (file + ".exr"), *options))

BLACK = {name: np.zeros((512, 2048), "f2") for name in "RGB"}
OpenEXR.File({"compression": OpenEXR.DWAB_COMPRESSION}, BLACK).write(sys.argv[1] + "/black.exr")

HEIGHT = np.where(np.mgrid[0:32, 0:64][1] < 32, 0.25, 0.75).astype("f2")
OpenEXR.File({"compression": OpenEXR.DWAB_COMPRESSION}, {"height": HEIGHT}).write(sys.argv[1] + "/height.exr")
