#!/usr/bin/env python3
"""Makes random scenes for the training of the denoiser: scenes.py FOLDER COUNT [SEED] [FIRST]

Rooms, windows, still lives, models under skies, landscapes, night scenes. Nothing of the project's own scenes is in
them, which are the test.
"""

import json
import math
import os
import sys

import numpy as np

import assets

PICTURES, RELIEFS, SKIES, MESHES, WORN = 64, 24, 32, 64, 32
KINDS = {"room": 5, "window": 2, "gap": 2, "open": 5, "bokeh": 2, "model": 6, "still": 3, "outdoors": 3}
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

    def texture(self):
        if self.chance(0.65):
            return self.picture("c%d.png" % self.rng.integers(PICTURES))
        kind = self.pick(["Wood", "Marble", "Cloud", "Voronoi"])
        keys = {"Voronoi": {"samples": int(self.rng.integers(5, 80))}, "Wood": {"rings": self.uniform(3, 15)}}
        return self.asset(assetType="Texture", textureType=kind, width=128, height=128, filter="bilinear", **keys.get(kind, {}))

    def channel(self, name, texture, scale):
        return {name + "TextureId": texture, name + "Scale": {"x": scale, "y": scale}}

    def worn(self):
        """Returns a material with pictures for all that it has, as models have."""
        name, scale = "p%d" % self.rng.integers(WORN), self.pick([1, 1, 2, 3, 5])
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
            keys.update(cameraType="ThinLens", focusDistance=max(0.3, focus * self.uniform(0.6, 1.5)), aperture=self.log(0.01, 0.25))
        elif self.chance(0.04):
            keys.update(cameraType="FishEye", angle=self.uniform(90, 180))
        self.objects.append(dict(id=1, type="Camera", localPosition=vector(*position), lookAt=vector(*target), **keys))

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


MAKERS = dict(room=room, window=window, gap=gap, open=opened, bokeh=bokeh, model=model, still=still, outdoors=outdoors)


def write_assets(folder, rng):
    for part in ("t", "m"):
        os.makedirs(os.path.join(folder, part), exist_ok=True)
    for i in range(PICTURES):
        assets.painted(rng).save("%s/t/c%d.png" % (folder, i))
    for i in range(RELIEFS):
        assets.normals(rng, assets.relief(rng), rng.uniform(2, 12)).save("%s/t/n%d.png" % (folder, i))
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
