"""Renders Lumbre's scenes with LuxCore on command, in one thread: python luxcore_server.py FOLDER

Commands and answers are those of RenderServer.java. FOLDER gets textures. Knows matte surfaces, mirrors and
glass. Counts the samples that were taken, since LuxCore stops a little after the number asked for.
"""

import json
import math
import os
import sys
import time

import numpy as np

import plain
from nodes import rotation

# LuxCore speaks on standard output, from its import on.
ANSWERS = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
import pyluxcore  # noqa: E402


class Converter:
    def __init__(self, path, folder, width, height):
        self.plain = plain.PlainScene(path)
        self.folder = folder
        self.properties = pyluxcore.Properties()
        self.scene = pyluxcore.Scene()
        self.known = {}
        self.camera(width, height)
        if self.plain.environment is not None:
            self.sky(self.plain.environment)
        for i, surface in enumerate(self.plain.surfaces):
            self.surface("s%d" % i, surface)
        self.scene.Parse(self.properties)

    def set(self, name, *values):
        values = [float(v) if isinstance(v, np.floating) else v for v in values]
        self.properties.Set(pyluxcore.Property("scene." + name, values))

    def camera(self, width, height):
        camera, view = self.plain.camera, self.plain.view
        kind = camera.get("cameraType", "Pinhole")
        if kind not in ("Pinhole", "ThinLens"):
            plain.refuse(camera)
        eye = view[:3, 3]
        self.set("camera.type", "perspective")
        self.set("camera.lookat.orig", *eye)
        self.set("camera.lookat.target", *(eye + view[:3, 2]))
        self.set("camera.up", *view[:3, 1])
        # LuxCore's angle is that of the shorter side.
        half = math.tan(math.radians(camera["fieldOfView"] / 2)) * max(1, width / height)
        if width < height:
            plain.refuse("a portrait")
        self.set("camera.fieldofview", 2 * math.degrees(math.atan(half)))
        self.set("camera.autofocus.enable", False)
        if kind == "ThinLens":
            self.set("camera.lensradius", camera["aperture"])
            self.set("camera.focaldistance", camera["focusDistance"])

    def sky(self, environment):
        self.set("lights.sky.gain", 1.0, 1.0, 1.0)
        if environment.ndim == 1:
            self.set("lights.sky.type", "constantinfinite")
            self.set("lights.sky.color", *environment)
        else:
            self.set("lights.sky.type", "infinite")
            # Seen from outside, and the middle a quarter turn away.
            rolled = np.roll(environment[:, ::-1], environment.shape[1] // 4, axis=1)
            self.set("lights.sky.file", self.write("sky", rolled))
            self.set("lights.sky.gamma", 1.0)
            # Its up is z, ours is y.
            turn = rotation(0, -90).T.ravel()
            self.set("lights.sky.transformation", *turn)

    def write(self, name, picture):
        path = os.path.join(self.folder, "luxcore-%s.hdr" % name)
        write_hdr(path, picture)
        return path

    def surface(self, name, surface):
        uv = None
        if surface.uv is not None:
            uv = [tuple(map(float, p)) for p in surface.uv]
        normals = None
        if surface.normals is not None:
            normals = [tuple(map(float, n)) for n in surface.normals]
        points = [tuple(map(float, p)) for p in surface.positions]
        triangles = [tuple(map(int, t)) for t in surface.triangles]
        self.scene.DefineMesh(name, points, triangles, normals, uv, None, None)
        if surface.radiance is not None:
            material = name + "m"
            self.set("materials.%s.type" % material, "matte")
            self.set("materials.%s.kd" % material, 0.0, 0.0, 0.0)
            self.set("materials.%s.emission" % material, *surface.radiance)
        else:
            material = self.material(surface.material)
        self.set("objects.%s.shape" % name, name)
        self.set("objects.%s.material" % name, material)

    def material(self, asset):
        name = "m%d" % asset["id"]
        if name in self.known:
            return name
        self.known[name] = True
        kind, prefix = asset["materialType"], "materials.%s." % name
        if "normalTextureId" in asset:
            plain.refuse(asset)
        if kind == "Diffuse":
            self.set(prefix + "type", "matte")
            self.channel(prefix + "kd", asset, "color")
        elif kind == "Reflective":
            self.set(prefix + "type", "mirror")
            self.channel(prefix + "kr", asset, "reflectivityColor")
        elif kind == "Refractive" and not {"roughness", "refractionColor"} & asset.keys():
            self.set(prefix + "type", "glass")
            self.set(prefix + "kr", 1.0, 1.0, 1.0)
            self.set(prefix + "kt", 1.0, 1.0, 1.0)
            self.set(prefix + "interiorior", asset["ior"])
            self.set(prefix + "exteriorior", 1.0)
        else:
            plain.refuse(asset)
        return name

    def channel(self, target, asset, name):
        constant, texture = self.plain.channel(asset, name)
        if texture is None:
            self.set(target, *constant)
            return
        picture, smooth, (across, up) = texture
        key = "t%d" % asset["id"]
        self.set("textures.%s.type" % key, "imagemap")
        self.set("textures.%s.file" % key, self.write(key, picture if smooth else plain.enlarged(picture)))
        self.set("textures.%s.gamma" % key, 1.0)
        self.set("textures.%s.mapping.type" % key, "uvmapping2d")
        # Rows from the top, and v upwards: upside down.
        self.set("textures.%s.mapping.uvscale" % key, float(across), -float(up))
        self.set(target, key)


def write_hdr(path, picture):
    """A Radiance picture: 8 bits a channel with a common exponent, not compressed."""
    most = np.maximum(picture.max(axis=-1), 1e-30)
    exponent = np.ceil(np.log2(most * 256 / 255.5))
    mantissa = np.clip(np.round(picture * 256 / np.exp2(exponent)[..., None]), 0, 255)
    rgbe = np.concatenate([mantissa, (exponent + 128)[..., None]], axis=-1).astype(np.uint8)
    with open(path, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % rgbe.shape[:2])
        file.write(rgbe.tobytes())


def render(scene, size, depth, samples, seed, threads=1):
    """Returns the picture, the number of samples taken and the CPU time; 0 threads for one per processor."""
    width, height = size
    properties = pyluxcore.Properties()
    settings = {
        "renderengine.type": "PATHCPU",
        "renderengine.seed": seed + 1,
        "sampler.type": "SOBOL",
        "film.width": width,
        "film.height": height,
        "film.filter.type": "NONE",
        "film.imagepipeline.0.type": "NOP",
        "path.pathdepth.total": depth + 1,
        "path.pathdepth.diffuse": depth + 1,
        "path.pathdepth.glossy": depth + 1,
        "path.pathdepth.specular": depth + 1,
        "batch.haltspp": samples,
    }
    if threads:
        settings["native.threads.count"] = threads
    for name, value in settings.items():
        properties.Set(pyluxcore.Property(name, value))
    session = pyluxcore.RenderSession(pyluxcore.RenderConfig(properties, scene))
    start = time.process_time()
    session.Start()
    while not session.HasDone():
        time.sleep(0.005)
        session.UpdateStats()
    session.Stop()
    cpu = time.process_time() - start
    taken = session.GetStats().Get("stats.renderengine.total.samplecount").GetFloat()
    image = np.zeros(width * height * 3, dtype=np.float32)
    session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB, image)
    # Upside down, and one row too low.
    picture = image.reshape(height, width, 3)[::-1]
    return np.concatenate([picture[1:], picture[-1:]]), taken, cpu


def main(folder):
    pyluxcore.Init()
    for line in sys.stdin:
        words = line.split()
        start = time.perf_counter()
        if words[0] == "load":
            width, height, depth = map(int, words[2:5])
            scene = Converter(words[1], folder, width, height).scene
            answer = {}
        else:
            image, taken, cpu = render(scene, (width, height), depth, int(words[1]), int(words[2]))
            answer = {"samples": round(taken), "cpu": cpu}
            if words[4] != "-":
                image.astype("<f4").tofile(words[4])
        answer["seconds"] = time.perf_counter() - start
        print(json.dumps(answer), file=ANSWERS, flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
