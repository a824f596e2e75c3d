#!/usr/bin/env python3
"""Makes random scenes for the training of the denoiser: scenes.py FOLDER COUNT [SEED] [FIRST]

Rooms, windows, lamps in shades, blinds, still lives, models and figures under skies, plates of metal, patterns, fences,
landscapes, caustics, things out of focus. Nothing of the project's own scenes is in
them, which are the test.
"""

import json
import math
import os
import sys

import numpy as np

import assets

PICTURES, RELIEFS, SKIES, MESHES, WORN, MASKS = 64, 24, 32, 64, 32, 8
KINDS = {
    "room": 5,
    "window": 2,
    "gap": 2,
    "shade": 3,
    "blinds": 2,
    "open": 4,
    "bokeh": 3,
    "lens": 3,
    "model": 5,
    "figure": 4,
    "plates": 5,
    "patterns": 4,
    "fence": 3,
    "still": 3,
    "caustics": 2,
    "outdoors": 3,
}
SOLID = ["Diffuse"] * 6 + ["Phong"] * 2 + ["CookTorrance"] * 3 + ["MetallicRoughness"] * 5
ANY = SOLID + ["Reflective"] * 2 + ["Refractive"] * 3


def vector(x, y, z):
    return {"x": round(float(x), 4), "y": round(float(y), 4), "z": round(float(z), 4)}


def rgb(c):
    return {"r": round(float(c[0]), 4), "g": round(float(c[1]), 4), "b": round(float(c[2]), 4)}


class Scene:
    """A random scene: its methods add assets and objects."""

    def __init__(self, rng):
        self.rng, self.assets, self.objects = rng, [], []
        self.options = {
            "mode": "path",
            "maxTraceDepth": int(self.pick([3, 4, 5, 5, 6, 8, 8, 12])),
            "seed": int(rng.integers(1 << 30)),
            "filter": self.pick(["box"] * 6 + ["tent", "gaussian"]),
        }

    def uniform(self, low, high):
        return float(self.rng.uniform(low, high))

    def log(self, low, high):
        return math.exp(self.uniform(math.log(low), math.log(high)))

    def chance(self, p):
        return bool(self.rng.random() < p)

    def pick(self, values):
        return values[int(self.rng.integers(len(values)))]

    def color(self, *range):
        return assets.color(self.rng, *range)

    def asset(self, **keys):
        self.assets.append(dict(id=10 + len(self.assets), **keys))
        return self.assets[-1]["id"]

    def picture(self, file):
        return self.asset(assetType="Texture", file="t/" + file, filter=self.pick(["nearest", "bilinear", "bilinear"]))

    def texture(self, painted=0.65):
        if self.chance(painted):
            return self.picture("c%d.png" % self.rng.integers(PICTURES))
        return self.computed()

    def computed(self):
        kind = self.pick(["Wood", "Marble", "Cloud", "Voronoi"])
        cells = {"samples": int(self.rng.integers(5, 80)), "blackAndWhite": self.chance(0.4)}
        keys = {"Voronoi": cells, "Wood": {"rings": self.uniform(3, 15)}}
        side = self.pick([128, 256])
        return self.asset(assetType="Texture", textureType=kind, width=side, height=side, filter="bilinear", **keys.get(kind, {}))

    def channel(self, name, texture, scale):
        return {name + "TextureId": texture, name + "Scale": {"x": scale, "y": scale}}

    def worn(self, scales=(1, 1, 2, 3, 5)):
        """Returns a material with pictures for all that it has, as models have."""
        name, scale = "p%d" % self.rng.integers(WORN), self.pick(scales)
        keys = {"normalStrength": self.uniform(0.3, 1.6)}
        if self.chance(0.15):
            keys["clearcoat"] = self.uniform(0.2, 1)
        if self.chance(0.06):
            keys["sheenColor"] = rgb(self.color())
            keys["sheenRoughness"] = self.uniform(0.2, 0.9)
        for channel, picture in (("baseColor", "base"), ("roughness", "rough"), ("metallic", "metal"), ("normal", "normal")):
            if channel != "normal" or self.chance(0.85):
                keys.update(self.channel(channel, self.picture("%s-%s.png" % (name, picture)), scale))
        return self.asset(assetType="Material", materialType="MetallicRoughness", **keys)

    def plate(self, scale):
        """Returns a shiny material whose bumps repeat often, as sheets of metal or tiles have."""
        pattern = int(self.rng.integers(RELIEFS))
        kind = self.pick(["Phong", "Phong", "CookTorrance", "CookTorrance", "MetallicRoughness"])
        keys = getattr(self, "of_" + kind.lower())(scale)
        if kind == "MetallicRoughness":
            keys.update(metallic=float(self.chance(0.6)), roughness=self.uniform(0.1, 0.5))
            keys.pop("transmission", None)
            keys.pop("opacity", None)
        elif kind == "CookTorrance":
            keys["roughness"] = self.log(0.08, 0.5)
        else:
            keys["exponent"] = self.log(10, 120)
        if self.chance(0.5):
            name = "baseColor" if kind == "MetallicRoughness" else "color"
            keys.update(self.channel(name, self.picture("h%d.png" % pattern), scale))
        keys.update(self.channel("normal", self.picture("n%d.png" % pattern), scale))
        return self.asset(assetType="Material", materialType=kind, normalStrength=self.uniform(0.4, 1.4), **keys)

    def material(self, kinds=ANY, scale=None):
        kind = self.pick(kinds)
        scale = scale or self.log(0.7, 8)
        keys = getattr(self, "of_" + kind.lower())(scale)
        if kind in SOLID and self.chance(0.25):
            keys.update(self.channel("normal", self.picture("n%d.png" % self.rng.integers(RELIEFS)), scale))
            keys["normalStrength"] = self.uniform(0.3, 1.5)
        return self.asset(assetType="Material", materialType=kind, **keys)

    def of_diffuse(self, scale):
        if self.chance(0.5):
            return {"color": rgb(self.color())}
        return dict(color=rgb(self.color(0.2, 0.6, 1)), **self.channel("color", self.texture(), scale))

    def of_phong(self, scale):
        keys = {"color": rgb(self.color(0.6, 0.05, 0.6)), "exponent": self.log(3, 500)}
        return dict(keys, specularColor=rgb(self.color(0.2, 0.05, 0.4)))

    def of_cooktorrance(self, scale):
        keys = {"color": rgb(self.color(0.6, 0.02, 0.6)), "specularColor": rgb(self.color(0.3, 0.1, 0.9))}
        if self.chance(0.3):
            keys.update(self.channel("color", self.texture(), scale))
        return dict(keys, roughness=self.log(0.03, 0.8), distribution=self.pick(["beckmann", "ggx"]))

    def of_metallicroughness(self, scale):
        keys = {"baseColor": rgb(self.color(0.6, 0.1, 0.95)), "metallic": float(self.chance(0.5)), "roughness": self.uniform(0.05, 1)}
        if self.chance(0.3):
            keys["clearcoat"] = self.uniform(0, 1)
        if self.chance(0.15):
            keys.update(metallic=0, transmission=1, roughness=self.pick([0, 0, 0.2, 0.5]))
            if self.chance(0.5):
                keys.update(attenuationDistance=self.log(0.2, 4), attenuationColor=rgb(self.color(0.6, 0.4, 1)))
        elif self.chance(0.1):
            keys["opacity"] = self.uniform(0.3, 0.9)
        if self.chance(0.4):
            keys.update(self.channel("baseColor", self.texture(), scale))
        return keys

    def of_reflective(self, scale):
        return {"reflectivityColor": rgb(self.color(0.3, 0.6, 0.98))}

    def of_refractive(self, scale):
        keys = {"ior": self.uniform(1.25, 1.8), "refractionColor": rgb(1 - 0.5 * self.rng.random(3) * self.chance(0.5))}
        return dict(keys, roughness=self.log(0.02, 0.5)) if self.chance(0.2) else keys

    def shape(self, kind, material, position, rotation=(0, 0, 0), **keys):
        self.objects.append(
            dict(
                type="Shape", shapeType=kind, materialID=material, localPosition=vector(*position), localRotation=vector(*rotation), **keys
            )
        )

    def turn(self):
        return tuple(self.rng.uniform(0, 360, 3)) if self.chance(0.4) else (0, self.uniform(0, 360), 0)

    def mesh(self, material, position, size, stretch=(1, 1, 1), rotation=None):
        mesh = self.asset(assetType="Mesh", file="m/m%d.obj" % self.rng.integers(MESHES))
        scale = vector(*(size * s for s in stretch))
        self.shape("Mesh", material, position, rotation or self.turn(), meshId=mesh, localScale=scale)

    def thing(self, x, y, z, r, material=None):
        """Adds a sphere, a box or a mesh of a radius that stands on a height."""
        material = material or self.material()
        kind = self.pick(["Sphere", "Sphere", "Cube", "Mesh", "Mesh"])
        if kind == "Sphere":
            self.shape(kind, material, (x, y + r, z), self.turn(), radius=r)
        elif kind == "Cube":
            sides = dict(width=r * self.uniform(0.6, 2), height=2 * r, depth=r * self.uniform(0.6, 2))
            self.shape(kind, material, (x, y + r, z), (0, self.uniform(0, 360), 0), **sides)
        else:
            self.mesh(material, (x, y + r * self.uniform(0.4, 1), z), r)

    def wall(self, w, h, position, rotation, material, two_sided=False):
        self.shape("Plane", material, position, rotation, finite=True, width=w, height=h, twoSided=two_sided)

    def light(self, kind, **keys):
        self.objects.append(dict(type="Light", lightType=kind, **keys))

    def lamp(self, position, size, power, rotation=(90, 0, 0)):
        color = rgb(1 - self.uniform(0, 0.5) * self.rng.random(3) * self.chance(0.6))
        keys = dict(unit="power", intensity=power, color=color)
        if self.chance(0.6):
            keys.update(width=size * self.uniform(0.4, 1.6), height=size * self.uniform(0.4, 1.6), localRotation=vector(*rotation))
            self.light("Rectangle", localPosition=vector(*position), **keys)
        else:
            self.light("Sphere", radius=size / 2.5, localPosition=vector(position[0], position[1] - size / 2, position[2]), **keys)

    def sky(self, low=0.3, high=3):
        sky = self.asset(assetType="Texture", file="t/s%d.pfm" % self.rng.integers(SKIES), filter="bilinear")
        self.light("Dome", intensity=self.log(low, high), textureId=sky, localRotation=vector(0, self.uniform(0, 360), 0))

    def sun(self):
        keys = dict(intensity=self.log(1, 8), color=rgb((1, self.uniform(0.7, 1), self.uniform(0.4, 1))))
        self.light("Directional", localRotation=vector(self.uniform(8, 80), self.uniform(0, 360), 0), **keys)

    def camera(self, position, target, fov, bokeh=0.2):
        focus = math.dist(position, target)
        if self.chance(0.35):
            fov *= self.uniform(0.35, 0.8)
        keys = dict(cameraType="Pinhole", fieldOfView=fov)
        if self.chance(bokeh):
            keys.update(cameraType="ThinLens", focusDistance=max(0.3, focus * self.uniform(0.6, 1.5)), aperture=self.log(0.01, 0.35))
            keys.update(self.form_of_lens(keys["aperture"]))
        elif self.chance(0.04):
            keys.update(cameraType="FishEye", angle=self.uniform(90, 180))
        self.objects.append(dict(id=1, type="Camera", localPosition=vector(*position), lookAt=vector(*target), **keys))

    def form_of_lens(self, radius):
        """Returns the keys of a lens that is not round, or none."""
        if self.chance(0.75):
            return {}
        mask = self.asset(assetType="Texture", file="t/b%d.png" % self.rng.integers(MASKS))
        return dict(bokehTextureId=mask, aperture=2 * radius)

    def write(self, file):
        with open(file, "w") as out:
            json.dump(dict(mainCameraId=1, renderOptions=self.options, assets=self.assets, objects=self.objects), out)


def shell(s, w, h, d, right=True):
    """Adds the walls of a room; returns their materials."""
    walls = [s.worn() if s.chance(0.15) else s.material(SOLID[:9]) for _ in range(3)]
    s.wall(w, d, (0, 0, 0), (0, 0, 0), s.worn() if s.chance(0.15) else s.material(["Diffuse"] * 4 + ["CookTorrance", "MetallicRoughness"]))
    pale = s.asset(assetType="Material", materialType="Diffuse", color=rgb([s.uniform(0.5, 0.9)] * 3))
    s.wall(w, d, (0, h, 0), (180, 0, 0), s.pick(walls) if s.chance(0.4) else pale)
    s.wall(w, h, (0, h / 2, d / 2), (90, 180, 0), s.pick(walls))
    s.wall(w, h, (0, h / 2, -d / 2), (90, 0, 0), s.pick(walls))
    s.wall(d, h, (-w / 2, h / 2, 0), (90, 90, 0), s.pick(walls))
    if right:
        s.wall(d, h, (w / 2, h / 2, 0), (90, 270, 0), s.pick(walls))
    return walls


def furnish(s, w, h, d):
    for _ in range(int(s.rng.integers(1, 8))):
        material = s.worn() if s.chance(0.3) else None
        s.thing(s.uniform(-0.4, 0.4) * w, 0, s.uniform(-0.3, 0.45) * d, s.log(0.15, 0.3 * h), material)
    for _ in range(6 if s.chance(0.3) else 0):
        s.thing(s.uniform(-0.4, 0.4) * w, 0, s.uniform(-0.4, 0.45) * d, s.log(0.05, 0.3))
    depth = -d / 2 + (s.uniform(0.05, 0.3) * d if s.chance(0.5) else 0.1)
    eye = (s.uniform(-0.25, 0.25) * w, s.uniform(0.25, 0.75) * h, depth)
    s.camera(eye, (s.uniform(-0.2, 0.2) * w, s.uniform(0.1, 0.6) * h, s.uniform(0, 0.3) * d), s.uniform(30, 70))


def size_of_room(s):
    return s.uniform(3, 8), s.uniform(2.2, 5), s.uniform(3, 9)


def room(s):
    w, h, d = size_of_room(s)
    shell(s, w, h, d)
    for _ in range(int(s.pick([1, 1, 1, 2, 3, 5]))):
        s.lamp((s.uniform(-0.35, 0.35) * w, h - 0.03, s.uniform(-0.35, 0.35) * d), s.log(0.1, 2.2), s.log(20, 200))
    furnish(s, w, h, d)


def window(s):
    w, h, d = size_of_room(s)
    walls = shell(s, w, h, d, right=False)
    share, material = s.uniform(0.2, 0.6), s.pick(walls)
    s.wall(d * share, h, (w / 2, h / 2, -d / 2 + d * share / 2), (90, 270, 0), material)
    s.wall(d * share / 2, h, (w / 2, h / 2, d / 2 - d * share / 4), (90, 270, 0), material)
    if s.chance(0.6):
        s.sky(0.5, 5)
    else:
        s.options["background"] = rgb(s.log(0.5, 6) * s.color(0.3, 0.5, 1))
    if s.chance(0.5):
        s.lamp((w / 2 + 4, h + 3, s.uniform(-3, 3)), 1.5, s.log(300, 2000), (35, 270, 0))
    furnish(s, w, h, d)


def gap(s):
    """Sparse light: the lamp is behind a partition with a gap, or turned to the ceiling."""
    w, h, d = size_of_room(s)
    walls = shell(s, w, h, d)
    if s.chance(0.6):
        x, width = s.uniform(0, 0.25) * w, s.log(0.08, 0.8)
        half, rest = (w / 2 - x) - width / 2, (w / 2 + x) - width / 2
        for length, center in ((half, w / 2 - half / 2), (rest, -w / 2 + rest / 2)):
            keys = dict(width=length, height=h, depth=0.08)
            s.shape("Cube", s.pick(walls), (center, h / 2, d * 0.2), **keys)
        s.lamp((s.uniform(-0.4, 0.4) * w, h * s.uniform(0.4, 0.95), d * s.uniform(0.3, 0.45)), s.log(0.1, 0.8), s.log(100, 900))
    else:
        s.lamp((s.uniform(-0.3, 0.3) * w, s.uniform(0.3, 0.8) * h, s.uniform(-0.1, 0.4) * d), s.log(0.05, 0.5), s.log(50, 300), (-90, 0, 0))
    furnish(s, w, h, d)


def shade(s):
    """Sparse light: a lamp in a shade that is open above or below, alone in a room."""
    w, h, d = size_of_room(s)
    walls = shell(s, w, h, d)
    for _ in range(int(s.pick([1, 1, 2]))):
        x, y, z = s.uniform(-0.3, 0.3) * w, s.uniform(0.25, 0.75) * h, s.uniform(-0.1, 0.35) * d
        r = s.log(0.12, 0.4)
        cover = s.pick(walls) if s.chance(0.6) else s.material(["Diffuse"])
        for turn in (0, 90, 180, 270):
            a = math.radians(turn)
            place = (x + r * math.sin(a), y, z + r * math.cos(a))
            s.shape("Cube", cover, place, (0, turn, 0), width=2 * r, height=r * s.uniform(1.2, 2.4), depth=0.02)
        power = s.log(60, 600)
        s.light("Sphere", radius=r * s.uniform(0.1, 0.5), localPosition=vector(x, y, z), unit="power", intensity=power)
    furnish(s, w, h, d)


def blinds(s):
    """Sparse light: a sky, a sun or a lamp through slats or small windows."""
    w, h, d = size_of_room(s)
    walls = shell(s, w, h, d, right=False)
    slats = s.chance(0.5)
    count = int(s.rng.integers(4, 14)) if slats else int(s.pick([2, 3, 4]))
    open_share = s.uniform(0.05, 0.35)
    step = h / count if slats else d / count
    for i in range(count):
        if slats:
            size, place = dict(width=0.04, height=step * (1 - open_share), depth=d), (w / 2, (i + 0.5) * step, 0)
        else:
            size, place = dict(width=0.04, height=h, depth=step * (1 - open_share)), (w / 2, h / 2, -d / 2 + (i + 0.5) * step)
        s.shape("Cube", s.pick(walls), place, (0, 0, s.uniform(-30, 30) if slats else 0), **size)
    if s.chance(0.6):
        s.sky(0.5, 5)
    else:
        s.options["background"] = rgb(s.log(0.5, 6) * s.color(0.3, 0.5, 1))
    if s.chance(0.4):
        keys = dict(intensity=s.log(2, 12), color=rgb((1, s.uniform(0.7, 1), s.uniform(0.5, 1))))
        s.light("Directional", localRotation=vector(s.uniform(10, 50), s.uniform(240, 300), 0), **keys)
    elif s.chance(0.5):
        s.lamp((w / 2 + 3, h * s.uniform(0.3, 1.5), s.uniform(-2, 2)), s.log(0.3, 2), s.log(300, 2500), (20, 270, 0))
    furnish(s, w, h, d)


def lit(s, lamps, total=(80, 700)):
    for _ in range(lamps):
        a, r = s.uniform(0, 6.28), s.uniform(0, 4)
        s.lamp((r * math.cos(a), s.uniform(2.5, 6), r * math.sin(a)), s.log(0.08, 3), s.log(*total) / lamps)


def floor(s):
    kinds = ["Diffuse"] * 5 + ["CookTorrance", "MetallicRoughness", "Phong"]
    s.shape("Plane", s.worn() if s.chance(0.2) else s.material(kinds), (0, 0, 0))


def look(s, near=2.8, far=8, bokeh=0.25):
    a, distance = s.uniform(-0.7, 0.7), s.uniform(near, far)
    eye = (distance * math.sin(a), s.log(0.4, 4.5), -distance * math.cos(a))
    s.camera(eye, (s.uniform(-0.5, 0.5), s.uniform(0.2, 1), s.uniform(-0.5, 0.5)), s.uniform(25, 60), bokeh)


def surroundings(s, dim=0.01):
    kind = s.rng.random()
    if kind < 0.4:
        s.sky()
    elif kind < 0.5:
        s.light("Dome", intensity=s.log(0.5, 2), sky="studio")
    elif kind < 0.9:
        s.options["background"] = rgb(s.log(dim, 1) * s.color(0.5, 0.5, 1))
    if s.chance(0.12):
        s.options["backplate"] = rgb(s.color(0.5, 0.02, 1))


def opened(s):
    floor(s)
    if s.chance(0.4):
        s.wall(14, 8, (0, 4, s.uniform(3, 6)), (90, 180, 0), s.material(["Diffuse"], s.log(2, 10)))
    surroundings(s)
    lit(s, int(s.pick([0, 1, 1, 2, 3])) if "background" not in s.options else int(s.pick([1, 1, 2, 3])))
    if s.chance(0.15):
        s.sun()
    if s.chance(0.1):
        keys = dict(falloff="inverseSquare", spotAngle=s.uniform(15, 50), penumbra=8, localRotation=vector(90, 0, 0))
        s.light("Spot", intensity=s.log(10, 60), localPosition=vector(s.uniform(-2, 2), 4, s.uniform(-2, 2)), **keys)
    for _ in range(int(s.rng.integers(2, 9))):
        s.thing(s.uniform(-2.5, 2.5), 0, s.uniform(-2, 3), s.log(0.2, 1.1))
    for _ in range(10 if s.chance(0.4) else 0):
        s.thing(s.uniform(-4, 4), 0, s.uniform(-2, 7), s.log(0.06, 0.4))
    look(s)


def bokeh(s):
    """Night with small bright things out of focus."""
    floor(s)
    s.options["background"] = rgb(s.log(0.005, 0.2) * s.color(0.5, 0.5, 1))
    lit(s, int(s.pick([1, 2, 6, 12])))
    for _ in range(int(s.rng.integers(2, 8))):
        s.thing(s.uniform(-2.5, 2.5), 0, s.uniform(-2, 3), s.log(0.2, 1.1), s.worn() if s.chance(0.3) else None)
    for _ in range(int(s.rng.integers(10, 60))):
        glow = s.asset(assetType="Material", materialType=s.pick(["Color", "AreaLight"]), color=rgb(s.log(1, 80) * s.color(0.8, 0.3, 1)))
        keys = dict(radius=s.log(0.01, 0.1)) if s.chance(0.5) else dict(width=0.05, height=s.log(0.05, 0.6), depth=0.05)
        kind = "Sphere" if "radius" in keys else "Cube"
        s.shape(kind, glow, (s.uniform(-5, 5), s.uniform(0, 3.5), s.uniform(1, 9)), **keys)
    look(s, bokeh=0.9)


def lens(s):
    """Rows of things on a smooth ground, sharp at one distance alone."""
    pale = s.asset(assetType="Material", materialType="Diffuse", color=rgb(s.color(0.2, 0.4, 0.9)))
    ground = pale if s.chance(0.5) else s.material(["Diffuse", "CookTorrance", "Phong"])
    s.shape("Plane", ground, (0, 0, 0))
    if s.chance(0.6):
        s.wall(30, 16, (0, 8, s.uniform(6, 12)), (90, 180, 0), pale if s.chance(0.6) else s.material(["Diffuse"], s.log(2, 10)))
    surroundings(s)
    for _ in range(int(s.pick([1, 1, 2]))):
        size = s.log(0.3, 4)
        s.lamp((s.uniform(-4, 4), s.uniform(3, 7), s.uniform(-3, 6)), size, s.log(150, 1200))
    first, step, side, r = s.uniform(-2.5, 0), s.uniform(0.8, 2), s.uniform(-0.7, 0.7), s.log(0.25, 0.8)
    for i in range(int(s.rng.integers(3, 9))):
        kinds = SOLID if s.chance(0.8) else ANY
        s.thing(side * step * i + s.uniform(-0.3, 0.3), 0, first + step * i, r * s.uniform(0.8, 1.2), s.material(kinds))
    for _ in range(int(s.rng.integers(2, 9)) if s.chance(0.4) else 0):
        glow = s.asset(assetType="Material", materialType="Color", color=rgb(s.log(1, 25) * s.color(0.9, 0.4, 1)))
        s.shape("Sphere", glow, (s.uniform(-3, 3), s.uniform(0.05, 3), s.uniform(-2, 8)), radius=s.log(0.01, 0.15))
    eye = (s.uniform(-1.5, 1.5), s.uniform(0.6, 3), s.uniform(-6, -4))
    keys = dict(cameraType="ThinLens", focusDistance=s.uniform(2, 10), aperture=s.log(0.05, 0.5), fieldOfView=s.uniform(20, 60))
    keys.update(s.form_of_lens(keys["aperture"]))
    s.objects.append(dict(id=1, type="Camera", localPosition=vector(*eye), lookAt=vector(side * 2, r, first + 3), **keys))


def body(s, x, z, h, materials):
    """Adds a figure of a height: trunk, head, arms and legs, as ellipsoids or other meshes."""

    def part(place, size, lean=0):
        s.mesh(s.pick(materials), (x + h * place[0], h * place[1], z + h * place[2]), h, size, (s.uniform(-8, 8), s.uniform(0, 360), lean))

    part((0, 0.62, 0), (0.13, 0.2, 0.09))
    part((0, 0.42, 0), (0.12, 0.1, 0.09))
    part((0, 0.9, 0), (0.07, 0.09, 0.075))
    for side in (-1, 1):
        lean = s.uniform(5, 50)
        a = math.radians(lean)
        part((side * (0.13 + 0.14 * math.sin(a)), 0.76 - 0.14 * math.cos(a), 0), (0.04, 0.16, 0.04), side * lean)
        part((side * (0.13 + 0.4 * math.sin(a)), 0.76 - 0.4 * math.cos(a), 0), (0.035, 0.14, 0.035), side * lean)
        part((side * 0.075, 0.32, 0), (0.06, 0.16, 0.06), side * 4)
        part((side * 0.09, 0.11, s.uniform(-0.05, 0.05)), (0.05, 0.14, 0.05), side * 2)


def figure(s):
    """Figures in worn clothes, whose pictures and bumps are fine."""
    if s.chance(0.8):
        floor(s)
    if s.chance(0.3):
        s.wall(16, 10, (0, 5, s.uniform(2, 5)), (90, 180, 0), s.material(["Diffuse", "CookTorrance"], s.log(2, 10)))
    for _ in range(int(s.pick([1, 1, 1, 2, 3]))):
        materials = [s.worn((1, 2, 3, 4)) for _ in range(int(s.pick([1, 2, 3])))]
        body(s, s.uniform(-0.8, 0.8), s.uniform(-0.6, 1), s.uniform(1.2, 2), materials)
    surroundings(s, 0.05)
    lit(s, int(s.pick([0, 1, 2, 3])) if "background" not in s.options else int(s.pick([1, 2, 3])))
    a, distance = s.uniform(-0.7, 0.7), s.uniform(1.6, 5)
    eye = (distance * math.sin(a), s.uniform(0.6, 2.4), -distance * math.cos(a))
    s.camera(eye, (s.uniform(-0.3, 0.3), s.uniform(0.6, 1.4), 0), s.uniform(25, 45), 0.1)


def plates(s):
    """Floors and walls of plates or tiles with bumps to the distance, under a few lamps, with or without things."""
    first = s.plate(s.log(3, 16))
    other = first if s.chance(0.5) else s.plate(s.log(3, 16)) if s.chance(0.7) else s.material(["Diffuse"])
    side = s.uniform(8, 18)
    s.wall(side, side, (0, 0, 1), (0, 0, 0), first)
    s.wall(side, side, (0, side / 2, s.uniform(2.5, 6)), (90, 180, 0), other)
    if s.chance(0.4):
        s.wall(side, side, (-s.uniform(2, 5), side / 2, 0), (90, 90, 0), other)
    dark = s.rng.random()
    if dark < 0.3:
        s.sky(0.2, 1.5)
    elif dark < 0.5:
        s.options["background"] = rgb(s.log(0.05, 0.6) * s.color(0.4, 0.5, 1))
    lit(s, int(s.pick([1, 2, 3, 4])), (100, 900))
    if s.chance(0.4):
        body(s, s.uniform(-0.5, 0.5), s.uniform(-0.3, 0.8), s.uniform(1.3, 2), [s.worn(), s.plate(s.log(1, 4))])
    for _ in range(int(s.rng.integers(0, 5))):
        material = s.plate(s.log(1, 5)) if s.chance(0.5) else s.worn() if s.chance(0.5) else None
        s.thing(s.uniform(-2.5, 2.5), 0, s.uniform(-1, 3), s.log(0.15, 0.8), material)
    a, distance = s.uniform(-0.7, 0.7), s.uniform(2.4, 6)
    s.camera((distance * math.sin(a), s.uniform(0.5, 3.2), -distance * math.cos(a)), (0, s.uniform(0.3, 1.3), 0.5), s.uniform(28, 60), 0.1)


def patterns(s):
    """A room or an open place whose walls and things have computed textures or writing."""
    w, h, d = size_of_room(s)

    def patterned():
        texture = s.computed() if s.chance(0.75) else s.texture(1)
        keys = dict(color=rgb([s.uniform(0.7, 1)] * 3), **s.channel("color", texture, s.pick([1, 1, 1, 2, 4])))
        return s.asset(assetType="Material", materialType="Diffuse", **keys)

    walls = [patterned() for _ in range(3)]
    white = s.asset(assetType="Material", materialType="Diffuse", color=rgb([s.uniform(0.6, 0.9)] * 3))
    s.wall(w, d, (0, 0, 0), (0, 0, 0), walls[0])
    s.wall(w, d, (0, h, 0), (180, 0, 0), white)
    for place, turn, width in (((0, h / 2, d / 2), 180, w), ((-w / 2, h / 2, 0), 90, d), ((w / 2, h / 2, 0), 270, d)):
        s.wall(width, h, place, (90, turn, 0), s.pick(walls) if s.chance(0.75) else white)
    if s.chance(0.5):
        s.wall(w, h, (0, h / 2, -d / 2), (90, 0, 0), s.pick(walls))
    lamp_size = s.log(0.2, 2.2)
    s.lamp((s.uniform(-0.2, 0.2) * w, h - 0.03, s.uniform(-0.2, 0.2) * d), lamp_size, s.log(30, 250))
    for _ in range(int(s.rng.integers(1, 6))):
        material = patterned() if s.chance(0.5) else s.material(["Reflective", "Refractive", "Diffuse", "CookTorrance"])
        s.thing(s.uniform(-0.35, 0.35) * w, 0, s.uniform(-0.2, 0.4) * d, s.log(0.2, 0.3 * h), material)
    eye = (s.uniform(-0.2, 0.2) * w, s.uniform(0.3, 0.7) * h, -d / 2 + 0.1)
    s.camera(eye, (s.uniform(-0.1, 0.1) * w, s.uniform(0.3, 0.6) * h, 0.3 * d), s.uniform(35, 70), 0.35)


def fence(s):
    """Thin things: bars, wires, grass, hair, leaves."""
    floor(s)
    if s.chance(0.4):
        s.wall(14, 8, (0, 4, s.uniform(2, 5)), (90, 180, 0), s.material(["Diffuse"], s.log(2, 10)))
    surroundings(s)
    lit(s, int(s.pick([0, 1, 2])) if "background" not in s.options else int(s.pick([1, 2])))
    if s.chance(0.3):
        s.sun()
    kinds = [s.material(SOLID) for _ in range(3)]
    for _ in range(int(s.pick([1, 1, 2]))):
        kind, z = s.pick(["bars", "bars", "lattice", "grass", "leaves"]), s.uniform(-1.2, 1.5)
        count, thin = int(s.rng.integers(10, 40)), s.log(0.01, 0.06)
        for i in range(count):
            x = (i / count - 0.5) * 5
            material = s.pick(kinds)
            if kind == "bars":
                s.shape("Cube", material, (x, 0.6, z), width=thin, height=1.2, depth=thin)
            elif kind == "lattice":
                s.shape("Cube", material, (x, 0.7, z), (0, 0, 45 if i % 2 else -45), width=thin, height=2, depth=thin)
            elif kind == "grass":
                place, tall = (s.uniform(-2, 2), 0, s.uniform(-1.5, 2)), s.uniform(0.3, 1.2)
                tilt = tuple(s.rng.uniform(-25, 25, 3))
                s.shape("Cube", material, (place[0], tall / 2, place[2]), tilt, width=thin, height=tall, depth=thin)
            else:
                place = (s.uniform(-1.5, 1.5), s.uniform(0.1, 2), s.uniform(-1, 1.5))
                size = s.log(0.08, 0.4)
                s.shape("Plane", material, place, s.turn(), finite=True, width=size, height=size * s.uniform(0.3, 1), twoSided=True)
    for _ in range(int(s.rng.integers(1, 5))):
        s.thing(s.uniform(-2, 2), 0, s.uniform(0, 3), s.log(0.2, 0.9))
    look(s, 2.2, 5, 0.15)


def model(s):
    """A model with pictures for its materials under a sky, as `render model.glb` shows it, or several of them."""
    count = int(s.pick([1, 1, 1, 2, 4]))
    if s.chance(0.5):
        floor(s)
    for _ in range(count):
        x, z = (0, 0) if count == 1 else (s.uniform(-1.3, 1.3), s.uniform(-1, 1.5))
        size = s.uniform(0.6, 1.1)
        for _ in range(int(s.pick([1, 2, 4]))):
            material = s.worn() if s.chance(0.8) else s.material()
            place = (x + s.uniform(-0.5, 0.5) * size, s.uniform(0.3, 1.1), z + s.uniform(-0.5, 0.5) * size)
            s.mesh(material, place, size * s.log(0.25, 1), s.rng.uniform(0.5, 1.3, 3))
    kind = s.rng.random()
    if kind < 0.45:
        s.sky(0.5, 2)
    elif kind < 0.6:
        s.light("Dome", intensity=s.log(0.6, 1.6), sky="studio")
    elif kind < 0.75:
        s.options["background"] = rgb([s.log(0.3, 1.5)] * 3)
    else:
        s.options["background"] = "transparent"
        lit(s, int(s.pick([1, 2, 3])))
    if s.chance(0.2):
        s.sun()
    if s.chance(0.2):
        s.options["backplate"] = rgb(s.pick([0, 1, s.uniform(0, 1)]) * np.ones(3))
    look(s, 2.4, 5, 0.12)


def still(s):
    """Glass, metal and china near the camera, on a table under small lamps or at a window."""
    s.wall(4, 3, (0, 0, 0), (0, 0, 0), s.worn() if s.chance(0.5) else s.material(SOLID))
    if s.chance(0.6):
        s.wall(8, 6, (0, 2, 2.5), (90, 180, 0), s.material(["Diffuse"], s.log(2, 6)))
    for _ in range(int(s.rng.integers(3, 9))):
        kinds = ["Refractive"] * 4 + ["MetallicRoughness"] * 3 + ["Reflective", "CookTorrance", "Diffuse"]
        s.thing(s.uniform(-1.1, 1.1), 0, s.uniform(-0.8, 1), s.log(0.12, 0.5), s.worn() if s.chance(0.15) else s.material(kinds))
    surroundings(s)
    lit(s, int(s.pick([1, 1, 2])), (50, 400))
    a = s.uniform(-0.6, 0.6)
    s.camera((2.6 * math.sin(a), s.uniform(0.5, 1.8), -2.6 * math.cos(a)), (0, 0.3, 0), s.uniform(25, 50), 0.3)


def caustics(s):
    """Glass and polished metal on a plain table under one small lamp or a sun."""
    s.wall(6, 6, (0, 0, 0), (0, 0, 0), s.material(["Diffuse", "Diffuse", "CookTorrance"]))
    if s.chance(0.4):
        s.wall(8, 6, (0, 2, 2.5), (90, 180, 0), s.material(["Diffuse"], s.log(2, 6)))
    for _ in range(int(s.rng.integers(2, 6))):
        s.thing(s.uniform(-0.9, 0.9), 0, s.uniform(-0.6, 0.8), s.log(0.15, 0.5), s.material(["Refractive"] * 3 + ["Reflective"]))
    if s.chance(0.6):
        s.options["background"] = rgb(s.log(0.01, 0.5) * s.color(0.5, 0.5, 1))
    if s.chance(0.3):
        s.sun()
    else:
        s.lamp((s.uniform(-2, 2), s.uniform(2, 4), s.uniform(-2, 2)), s.log(0.15, 1), s.log(100, 500))
    a = s.uniform(-0.6, 0.6)
    s.camera((2.6 * math.sin(a), s.uniform(0.7, 2.2), -2.6 * math.cos(a)), (0, 0.25, 0), s.uniform(25, 50), 0.2)


def outdoors(s):
    """Ground with houses, rocks and trees to the horizon, under a sky."""
    ground = s.worn() if s.chance(0.4) else s.material(["Diffuse"], s.log(3, 12))
    s.shape("Plane", ground, (0, 0, 0))
    if s.chance(0.6):
        s.mesh(ground, (0, -0.1, 3), 9, (1, 0.8, 1), (0, s.uniform(0, 360), 0))
    kinds = [s.worn() if s.chance(0.5) else s.material(SOLID) for _ in range(5)]
    for _ in range(int(s.rng.integers(12, 60))):
        x, z, size = s.uniform(-6, 6), s.uniform(-2, 10), s.log(0.1, 0.9)
        if s.chance(0.3):
            keys = dict(width=size, height=size * s.uniform(1, 4), depth=size)
            s.shape("Cube", s.pick(kinds), (x, keys["height"] / 2, z), (0, s.uniform(0, 360), 0), **keys)
        else:
            s.mesh(
                s.pick(kinds),
                (x, 0.5 * size, z),
                size,
                (s.uniform(0.3, 1), s.uniform(0.3, 2), s.uniform(0.3, 1)),
                (0, s.uniform(0, 360), 0),
            )
    s.sky(0.5, 2)
    if s.chance(0.6):
        s.sun()
    look(s, 3, 6, 0.1)


MAKERS = dict(
    room=room,
    window=window,
    gap=gap,
    shade=shade,
    blinds=blinds,
    open=opened,
    bokeh=bokeh,
    lens=lens,
    model=model,
    figure=figure,
    plates=plates,
    patterns=patterns,
    fence=fence,
    still=still,
    caustics=caustics,
    outdoors=outdoors,
)


def write_assets(folder, rng):
    for part in ("t", "m"):
        os.makedirs(os.path.join(folder, part), exist_ok=True)
    for i in range(PICTURES):
        assets.painted(rng).save("%s/t/c%d.png" % (folder, i))
    for i in range(RELIEFS):
        heights = assets.relief(rng)
        assets.normals(rng, heights, rng.uniform(2, 12)).save("%s/t/n%d.png" % (folder, i))
        assets.shaded(rng, heights).save("%s/t/h%d.png" % (folder, i))
    for i in range(MASKS):
        assets.mask_of_lens(rng).save("%s/t/b%d.png" % (folder, i))
    for i in range(SKIES):
        assets.sky(rng, "%s/t/s%d.pfm" % (folder, i))
    for i in range(WORN):
        assets.pbr(rng, folder + "/t", "p%d" % i)
    for i in range(MESHES):
        assets.mesh(rng, "%s/m/m%d.obj" % (folder, i), assets.MESHES[i % len(assets.MESHES)])


def main(folder, count, seed=0, first=0):
    write_assets(folder, np.random.default_rng([seed, 1 << 30]))
    names, weights = list(KINDS), np.array(list(KINDS.values())) / sum(KINDS.values())
    for i in range(first, first + count):
        rng = np.random.default_rng([seed, i])
        scene = Scene(rng)
        MAKERS[names[int(rng.choice(len(names), p=weights))]](scene)
        scene.write("%s/s%05d.json" % (folder, i))


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
