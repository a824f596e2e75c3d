"""Renders Lumbre's scenes with Mitsuba 3 on command, in one thread.

    python mitsuba_server.py VARIANT SAMPLER FOLDER [avx2]

Commands and answers are those of RenderServer.java. What Mitsuba has no equal of is refused with a
message, never replaced in silence. FOLDER gets meshes that Mitsuba is to read. With avx2, an llvm
variant is compiled for AVX2, with vectors of eight lanes; its Embree is not limited.
"""

import ctypes
import json
import os
import sys
import time

import numpy as np
import drjit as dr
import mitsuba as mi

from nodes import LYING, MIRROR, SQUARE, SQUARE_UV, colour, halves, placed


def linear(encoded):
    """Linear values of sRGB's from 0 to 1."""
    low = encoded / 12.92
    return np.where(encoded <= 0.04045, low, ((encoded + 0.055) / 1.055) ** 2.4)


def mirrored(matrix):
    """A transform of Mitsuba's; shapes are mirrored themselves, so that it does not mirror."""
    return mi.ScalarTransform4f((MIRROR @ matrix @ MIRROR).tolist())


class Converter:
    def __init__(self, path, folder):
        with open(path, encoding="utf-8") as file:
            self.scene = json.load(file)
        self.home = os.path.dirname(path)
        self.folder = folder
        self.assets = {asset["id"]: asset for asset in self.scene.get("assets", [])}
        self.bsdfs = {}
        self.result = {"type": "scene"}

    def refuse(self, what):
        raise ValueError("Mitsuba is not given: " + str(what))

    def add(self, part):
        self.result["part%d" % len(self.result)] = part

    def add_all(self):
        background = self.scene["renderOptions"].get("background")
        if background is not None:
            value = {"type": "rgb", "value": colour(background).tolist()}
            self.add({"type": "constant", "radiance": value})
        for node, matrix in placed(self.scene["objects"]):
            kind = node.get("type", "None")
            if kind == "Shape":
                self.shape(node, matrix)
            elif kind == "Light":
                self.light(node, matrix)
            elif kind == "Camera" and node.get("id") == self.scene["mainCameraId"]:
                self.camera, self.view = node, matrix

    def shape(self, node, matrix):
        kind = node.get("shapeType")
        part = {"bsdf": self.bsdf(node.get("materialID"))}
        if kind == "Plane" and node.get("finite"):
            size = halves(node, "width", "height")
            part.update(type="rectangle", to_world=mirrored(matrix @ LYING @ size))
            if "colorTextureId" in self.assets[node["materialID"]]:
                part.update(type="obj", filename=self.square())
        elif kind == "Cube":
            size = halves(node, "width", "height", "depth")
            part.update(type="cube", to_world=mirrored(matrix @ size))
        elif kind == "Sphere":
            radius = node.get("radius", 1)
            part.update(type="sphere", radius=radius, to_world=mirrored(matrix))
        elif kind == "Mesh":
            path, has_normals = self.mesh(self.assets[node["meshId"]])
            part.update(type="obj", filename=path, to_world=mirrored(matrix))
            part["face_normals"] = not has_normals
        else:
            self.refuse(node)
        self.add(part)

    def square(self):
        """A mirrored square from -1 to 1 with the uv of a finite plane."""
        path = os.path.join(self.folder, "square.obj")
        with open(path, "w", encoding="ascii") as out:
            for (x, y, z), (u, v) in zip(SQUARE, SQUARE_UV, strict=True):
                out.write("v %g %g %g\nvt %g %g\n" % (-x, y, z, u, v))
            out.write("f 4/4 3/3 2/2\nf 4/4 2/2 1/1\n")
        return path

    def mesh(self, asset):
        """A copy of an OBJ file, mirrored and so that its fronts stay fronts."""
        target = os.path.join(self.folder, "mirrored-" + os.path.basename(asset["file"]))
        has_normals = False
        with open(os.path.join(self.home, asset["file"]), encoding="utf-8") as source:
            with open(target, "w", encoding="utf-8") as out:
                for line in source:
                    words = line.split()
                    if words and words[0] in ("v", "vn"):
                        has_normals |= words[0] == "vn"
                        words[1] = repr(-float(words[1]))
                    elif words and words[0] == "f":
                        words[1:] = words[:0:-1]
                    out.write(" ".join(words) + "\n")
        return target, has_normals

    def light(self, node, matrix):
        radiance = colour(node.get("color")) * node.get("intensity", 0)
        if node.get("lightType") == "Dome" and "textureId" in node:
            asset = self.assets[node["textureId"]]
            data = linear(self.pixels(asset["id"]) / 255) * radiance
            picture = mi.Bitmap(data.astype(np.float32))
            self.add({"type": "envmap", "bitmap": picture, "to_world": mirrored(matrix)})
            return
        if node.get("unit") != "radiance":
            self.refuse(node)
        emitter = {"type": "area", "radiance": {"type": "rgb", "value": radiance.tolist()}}
        black = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.0}}
        part = {"type": "rectangle", "bsdf": black, "emitter": emitter}
        if node.get("lightType") == "Rectangle":
            part.update(to_world=mirrored(matrix @ halves(node, "width", "height")))
        elif node.get("lightType") == "Sphere":
            part.update(type="sphere", radius=node.get("radius", 1), to_world=mirrored(matrix))
        else:
            self.refuse(node)
        self.add(part)

    def bsdf(self, identity):
        if identity not in self.bsdfs:
            self.bsdfs[identity] = self.material(self.assets[identity])
        return self.bsdfs[identity]

    def material(self, asset):
        kind = asset["materialType"]
        if kind == "Diffuse":
            result = {"type": "diffuse", "reflectance": self.channel(asset, "color", 1)}
        elif kind == "CookTorrance":
            result = self.cook_torrance(asset)
        elif kind == "Reflective":
            reflectivity = self.channel(asset, "reflectivityColor", 1)
            result = {"type": "conductor", "material": "none", "specular_reflectance": reflectivity}
        elif kind == "Refractive" and not {"roughness", "refractionColor"} & asset.keys():
            result = {"type": "dielectric", "int_ior": asset["ior"], "ext_ior": 1.0}
        else:
            self.refuse(asset)
        if asset.get("normalTextureId") is None:
            return result
        # Flat is 128 to Lumbre, and halfway from 0 to 1 to Mitsuba.
        bytes_ = self.pixels(asset["normalTextureId"])
        data = ((bytes_ - 128) / 127 + 1) / 2
        return {"type": "normalmap", "normalmap": self.bitmap(data), "bsdf": result}

    def cook_torrance(self, asset):
        """Lambert's reflection plus that of microfacets: a blend of twice each, half and half."""
        if np.any(colour(asset.get("color")) + colour(asset.get("specularColor")) > 1):
            self.refuse(asset)
        facets = {
            "type": "roughconductor",
            "distribution": asset.get("distribution", "beckmann"),
            "alpha": asset.get("roughness", 1),
            "eta": {"type": "rgb", "value": asset.get("ior", 3.0504)},
            "k": {"type": "rgb", "value": 0.0},
            "specular_reflectance": self.channel(asset, "specularColor", 2),
        }
        matte = {"type": "diffuse", "reflectance": self.channel(asset, "color", 2)}
        return {"type": "blendbsdf", "weight": 0.5, "first": matte, "second": facets}

    def channel(self, asset, name, factor):
        value = colour(asset.get(name)) * factor
        texture = asset.get(name + "TextureId")
        if texture is None:
            return {"type": "srgb", "color": mi.ScalarColor3f(value.tolist()), "unbounded": True}
        result = self.bitmap(linear(self.pixels(texture) / 255) * value)
        if self.assets[texture].get("filter", "nearest") == "nearest":
            result["filter_type"] = "nearest"
        size = asset.get(name + "Scale", {"x": 1, "y": 1})
        if name + "Offset" in asset:
            self.refuse(asset)
        result["to_uv"] = mi.ScalarTransform3f(np.diag([size["x"], size["y"], 1.0]).tolist())
        return result

    def pixels(self, identity):
        asset = self.assets[identity]
        if asset.get("textureType", "Image") != "Image":
            self.refuse(asset)
        picture = mi.Bitmap(os.path.join(self.home, asset["file"]))
        picture = picture.convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.UInt8, True)
        return np.array(picture, dtype=float)

    @staticmethod
    def bitmap(data):
        picture = mi.Bitmap(data.astype(np.float32))
        return {"type": "bitmap", "bitmap": picture, "raw": True}

    def sensor(self, width, height, sampler):
        kind = self.camera.get("cameraType", "Pinhole")
        if kind not in ("Pinhole", "ThinLens") or "bokehTextureId" in self.camera:
            self.refuse(self.camera)
        sensor = {
            "type": "perspective" if kind == "Pinhole" else "thinlens",
            "fov": self.camera.get("fieldOfView", 60),
            "fov_axis": "y",
            "near_clip": 1e-3,
            "far_clip": 1e6,
            "to_world": mirrored(self.view),
            "sampler": {"type": sampler},
            "film": {
                "type": "hdrfilm",
                "width": width,
                "height": height,
                "rfilter": {"type": "box"},
                "pixel_format": "rgb",
                "component_format": "float32",
            },
        }
        if kind == "ThinLens":
            sensor["aperture_radius"] = self.camera.get("aperture", 0.2)
            sensor["focus_distance"] = self.camera.get("focusDistance", 5)
        return sensor

    def convert(self, width, height, depth, sampler):
        self.add_all()
        self.result["sensor"] = self.sensor(width, height, sampler)
        # Mitsuba counts the edges of a path, Lumbre the vertices that scatter.
        self.result["integrator"] = {"type": "path", "max_depth": depth + 1, "rr_depth": 4}
        return mi.load_dict(self.result)


def without_avx512():
    """Compiles for AVX2; dr.jit has no function in Python for it."""
    core = ctypes.CDLL(os.path.join(os.path.dirname(dr.__file__), "libdrjit-core.so"))
    set_target = core["_Z19jit_llvm_set_targetPKcS0_j"]
    set_target.argtypes = [ctypes.c_char_p, ctypes.c_char_p, ctypes.c_uint]
    set_target.restype = None
    set_target(b"znver3", b"+avx2,+fma,+f16c,+bmi,+bmi2,+lzcnt,+popcnt", 8)
    if core["_Z21jit_llvm_vector_widthv"]() != 8:
        raise RuntimeError("Mitsuba cannot be limited to AVX2")


def main(variant, sampler, folder, limit=""):
    mi.set_variant(variant)
    if limit == "avx2" and variant.startswith("llvm"):
        without_avx512()
    mi.set_log_level(mi.LogLevel.Error)
    dr.set_thread_count(1)
    scene = None
    pixels = 0
    for line in sys.stdin:
        words = line.split()
        start, cpu_start = time.perf_counter(), time.process_time()
        if words[0] == "load":
            width, height, depth = map(int, words[2:5])
            scene = Converter(words[1], folder).convert(width, height, depth, sampler)
            pixels = width * height
            answer = {}
        else:
            samples, seed = int(words[1]), int(words[2])
            with dr.suspend_grad():
                image = mi.render(scene, spp=samples, seed=seed)
                dr.eval(image)
                dr.sync_thread()
            cpu = time.process_time() - cpu_start
            # Some samplers round their number of samples up.
            taken = scene.sensors()[0].sampler().sample_count()
            answer = {"samples": taken * pixels, "cpu": cpu}
        answer["seconds"] = time.perf_counter() - start
        if words[0] == "render" and words[4] != "-":
            np.array(image).astype("<f4").tofile(words[4])
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:5])
