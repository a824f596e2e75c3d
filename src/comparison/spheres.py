"""Renders twenty spheres, one for each material of models, with Lumbre, Mitsuba and Cycles.

    python spheres.py [--samples N] [--folder FOLDER] [lumbre | mitsuba | cycles | table]...

Without the name of a part, all are done, Mitsuba and Cycles each in a Python of its own. Each renders four pictures with
other seeds, of the spheres that it has an equal of, and Lumbre renders the same ones. The table has the mean of each sphere's pixels in green, and relative differences with their standard errors.
A dash stands for a renderer that has no equal of the material.
"""

import argparse
import json
import os
import subprocess
import sys

import numpy as np

HOME = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WIDTH, HEIGHT, DEPTH = 440, 200, 16
SEEDS = 4
FIELD, TILT = 20.0, 31.0
RADIUS, COLUMNS = 0.45, 7
EYE = np.array([0.0, 5.6, -8.6])
GOLD = {"r": 0.9, "g": 0.7, "b": 0.4}
WHITE = {"r": 1, "g": 1, "b": 1}
SIGMA = {"r": 0.2, "g": 0.6, "b": 0.8}
LEAF = {"r": 0.3, "g": 0.8, "b": 0.3}
BOTH, CYCLES, NEITHER = ("mitsuba", "cycles"), ("cycles",), ()


def metal(roughness, **more):
    return {"baseColor": GOLD, "metallic": 1, "roughness": roughness, **more}


def matte(**more):
    return {"baseColor": GOLD, "metallic": 0, "roughness": 1, "specular": 0, **more}


def glass(roughness=0, **more):
    return {"metallic": 0, "roughness": roughness, "transmission": 1, "attenuationDistance": 1e6, **more}


def facets(roughness):
    """Metal of the report, without the light that hits several facets."""
    return {
        "materialType": "CookTorrance",
        "distribution": "ggx",
        "color": {"r": 0, "g": 0, "b": 0},
        "specularColor": WHITE,
        "roughness": roughness**2,
        "ior": 3.0504,
    }


def single_glass(roughness):
    return {"materialType": "Refractive", "ior": 1.5, "roughness": roughness**2}


def ink():
    color = {channel: float(np.exp(-value)) for channel, value in SIGMA.items()}
    return glass(attenuationDistance=1, attenuationColor=color)


MATERIALS = [
    ("metal, roughness 0.1", metal(0.1), BOTH),
    *[("metal, roughness %g" % r, metal(r), CYCLES) for r in (0.3, 0.5, 0.75, 1)],
    *[("diffuse, opacity %g" % o, matte(opacity=o), BOTH) for o in (0.25, 0.5, 0.75)],
    ("glass", glass(), BOTH),
    ("glass with an absorbing volume", ink(), BOTH),
    ("rough glass, roughness 0.4", glass(0.4), CYCLES),
    ("rough glass, roughness 0.7", glass(0.7), CYCLES),
    ("diffuse", matte(), BOTH),
    ("metal, roughness 1, single scattering", facets(1), BOTH),
    ("rough glass, roughness 0.7, single scattering", single_glass(0.7), BOTH),
    ("clear coat on metal, roughness 0.5", metal(0.5, clearcoat=1, clearcoatRoughness=0.1), NEITHER),
    ("sheen on black", matte(baseColor={"r": 0, "g": 0, "b": 0}, sheenColor=WHITE, sheenRoughness=0.5), NEITHER),
    (
        "iridescent metal, roughness 0.3",
        metal(0.3, iridescence=1, iridescenceIor=1.8, iridescenceThicknessMaximum=450),
        CYCLES,
    ),
    ("dispersive glass", glass(ior=1.7, dispersion=2), BOTH),
    ("diffuse transmission 0.6", matte(diffuseTransmission=0.6, diffuseTransmissionColor=LEAF), CYCLES),
]


def center(index):
    row, column = divmod(index, COLUMNS)
    return np.array([column - (COLUMNS - 1) / 2, RADIUS, (1 - row) * 1.15])


def place(position):
    return dict(zip("xyz", map(float, position), strict=True))


def write_scene(path, renderer):
    """Writes the spheres that a renderer has an equal of, so that all others see the same neighbors."""
    assets = [{"id": 1, "assetType": "Material", "name": "floor", "materialType": "Diffuse", "color": 0.5}]
    assets[0]["color"] = {"r": 0.5, "g": 0.5, "b": 0.5}
    lamp = {"type": "Light", "lightType": "Rectangle", "unit": "radiance", "intensity": 12, "width": 2, "height": 2}
    lamp.update(id=2, localPosition=place([-3, 5, 1]), localRotation={"x": 90, "y": 0, "z": 0})
    objects = [
        {
            "id": 1,
            "type": "Camera",
            "cameraType": "Pinhole",
            "fieldOfView": FIELD,
            "localPosition": place(EYE),
            "localRotation": {"x": TILT, "y": 0, "z": 0},
        },
        lamp,
        {"id": 3, "type": "Shape", "shapeType": "Plane", "finite": True, "width": 200, "height": 200, "materialID": 1},
    ]
    for i, (name, material, equals) in enumerate(MATERIALS):
        if renderer not in (*equals, "lumbre"):
            continue
        number = 10 + i
        kind = {"id": number, "assetType": "Material", "name": name, "materialType": "MetallicRoughness"}
        assets.append({**kind, **material})
        sphere = {"id": number, "type": "Shape", "shapeType": "Sphere", "radius": RADIUS, "materialID": number}
        objects.append({**sphere, "localPosition": place(center(i))})
    options = {"mode": "path", "width": WIDTH, "height": HEIGHT, "maxTraceDepth": DEPTH}
    options["background"] = {"r": 0.6, "g": 0.6, "b": 0.6}
    with open(path, "w", encoding="ascii") as out:
        json.dump({"mainCameraId": 1, "renderOptions": options, "assets": assets, "objects": objects}, out, indent=1)


def masks():
    """The pixels of each sphere, without its rim."""
    tan = np.tan(np.radians(FIELD) / 2)
    x, y = np.meshgrid(np.arange(WIDTH) + 0.5, np.arange(HEIGHT) + 0.5)
    ray = np.stack([(2 * x / WIDTH - 1) * tan * WIDTH / HEIGHT, (1 - 2 * y / HEIGHT) * tan, np.ones_like(x)], -1)
    down = np.radians(TILT)
    turn = np.array([[1, 0, 0], [0, np.cos(down), -np.sin(down)], [0, np.sin(down), np.cos(down)]])
    ray = ray @ turn.T
    ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
    along = [ray @ (center(i) - EYE) for i in range(len(MATERIALS))]
    across = [
        np.linalg.norm((center(i) - EYE) - t[..., None] * ray, axis=-1) for i, t in enumerate(along)
    ]
    nearest = np.argmin(np.where(np.array(across) < RADIUS, along, np.inf), axis=0)
    return [(a < 0.95 * RADIUS) & (nearest == i) for i, a in enumerate(across)]


def picture(folder, renderer, seed):
    return os.path.join(folder, "%s-%d.raw" % (renderer, seed))


def keep(folder, renderer, seed, values):
    np.asarray(values, "<f4").tofile(picture(folder, renderer, seed))


def lumbre(scene, folder, samples, other="lumbre"):
    for seed in range(SEEDS):
        path = os.path.join(folder, "%s-%d.pfm" % (other, seed))
        command = [os.path.join(HOME, "lumbre"), "render", scene, "-o", path, "--overwrite", "--no-denoise"]
        subprocess.run([*command, "--samples", str(samples), "--seed", str(seed)], check=True)
        with open(path, "rb") as file:
            values = np.frombuffer(file.read()[-12 * WIDTH * HEIGHT :], "<f4")
        keep(folder, "lumbre-" + other, seed, values.reshape(HEIGHT, WIDTH, 3)[::-1])


def mitsuba(scene, folder, samples):
    import mitsuba as mi

    mi.set_variant("scalar_rgb")
    import mitsuba_server

    def rgb(value):
        return {"type": "rgb", "value": [value[c] for c in "rgb"]}

    class Spheres(mitsuba_server.Converter):
        def shape(self, node, matrix):
            super().shape(node, matrix)
            if self.assets[node["materialID"]]["name"] == "glass with an absorbing volume":
                part = self.result["part%d" % (len(self.result) - 1)]
                part["interior"] = {"type": "homogeneous", "albedo": 0.0, "sigma_t": rgb(SIGMA)}

        def material(self, asset):
            if asset["materialType"] == "Refractive":
                return self.glass(asset["ior"], asset["roughness"])
            if asset["materialType"] != "MetallicRoughness":
                return super().material(asset)
            color = rgb(asset.get("baseColor", WHITE))
            roughness = asset["roughness"]
            if asset["metallic"] == 1:
                return {"type": "principled", "base_color": color, "metallic": 1.0, "roughness": roughness}
            if "transmission" in asset:
                return self.glass(asset.get("ior", 1.5), roughness**2)
            diffuse = {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": color}}
            opacity = asset.get("opacity", 1)
            return diffuse if opacity == 1 else {"type": "mask", "opacity": opacity, "bsdf": diffuse}

        def glass(self, ior, alpha):
            result = {"int_ior": ior, "ext_ior": 1.0}
            if alpha == 0:
                return {"type": "dielectric", **result}
            return {"type": "roughdielectric", "distribution": "ggx", "alpha": alpha, **result}

    converter = Spheres(scene, folder)
    converter.add_all()
    converter.result["sensor"] = converter.sensor(WIDTH, HEIGHT, "independent")
    converter.result["integrator"] = {"type": "volpath", "max_depth": DEPTH + 1, "rr_depth": DEPTH}
    loaded = mi.load_dict(converter.result)
    for seed in range(SEEDS):
        keep(folder, "mitsuba", seed, mi.render(loaded, spp=samples, seed=seed))


def cycles(scene, folder, samples):
    import bpy

    import plain

    plain.RINGS = 192
    import cycles_server

    class Spheres(cycles_server.Converter):
        def material(self, asset):
            known = asset["id"] in self.materials
            material = super().material(asset)
            if not known and asset["name"] == "glass with an absorbing volume":
                tree = material.node_tree
                volume = tree.nodes.new("ShaderNodeVolumeAbsorption")
                # Its coefficient is (1 - color) times the density.
                volume.inputs["Color"].default_value = [*[1 - SIGMA[c] for c in "rgb"], 1]
                output = next(n for n in tree.nodes if n.bl_idname == "ShaderNodeOutputMaterial")
                tree.links.new(volume.outputs[0], output.inputs["Volume"])
            return material

        def bsdf(self, tree, asset):
            kind = asset["materialType"]
            if kind == "CookTorrance":
                result = tree.node("BsdfMetallic", fresnel_type="PHYSICAL_CONDUCTOR", distribution="GGX")
                result.inputs["IOR"].default_value = [asset["ior"]] * 3
                result.inputs["Extinction"].default_value = [0, 0, 0]
                result.inputs["Roughness"].default_value = asset["roughness"] ** 0.5
                return result
            if kind == "Refractive":
                return self.glass(tree, asset["ior"], asset["roughness"] ** 0.5, "GGX")
            if kind != "MetallicRoughness":
                return super().bsdf(tree, asset)
            color = [*[asset.get("baseColor", WHITE)[c] for c in "rgb"], 1]
            if asset["metallic"] == 1:
                result = tree.node("BsdfMetallic", fresnel_type="F82", distribution="MULTI_GGX")
                result.inputs["Base Color"].default_value = color
                result.inputs["Edge Tint"].default_value = [1, 1, 1, 1]
                if "iridescence" in asset:
                    result.inputs["Thin Film Thickness"].default_value = asset["iridescenceThicknessMaximum"]
                    result.inputs["Thin Film IOR"].default_value = asset["iridescenceIor"]
            elif "transmission" in asset:
                return self.glass(tree, asset.get("ior", 1.5), asset["roughness"], "MULTI_GGX")
            else:
                return self.mixed(tree, asset, color)
            result.inputs["Roughness"].default_value = asset["roughness"]
            return result

        def glass(self, tree, ior, roughness, distribution):
            result = tree.node("BsdfGlass", distribution=distribution)
            result.inputs["Color"].default_value = [1, 1, 1, 1]
            result.inputs["IOR"].default_value = ior
            result.inputs["Roughness"].default_value = roughness
            return result

        def mixed(self, tree, asset, color):
            result = tree.node("BsdfDiffuse")
            result.inputs["Color"].default_value = color
            other, share = None, 0
            if "opacity" in asset:
                other, share = tree.node("BsdfTransparent"), 1 - asset["opacity"]
            elif "diffuseTransmission" in asset:
                other, share = tree.node("BsdfTranslucent"), asset["diffuseTransmission"]
                other.inputs["Color"].default_value = [*[LEAF[c] for c in "rgb"], 1]
            if other is None:
                return result
            mix = tree.node("MixShader")
            mix.inputs[0].default_value = share
            tree.link(result.outputs[0], mix.inputs[1])
            tree.link(other.outputs[0], mix.inputs[2])
            return mix

    Spheres(scene)
    cycles_server.set_up(WIDTH, HEIGHT, DEPTH + 1, threads=2)
    bpy.context.scene.cycles.transparent_max_bounces = 64
    for seed in range(SEEDS):
        cycles_server.render(samples, seed, picture(folder, "cycles", seed))


def means(folder, renderer, spheres):
    """The mean of each sphere in each picture, or None."""
    if not os.path.exists(picture(folder, renderer, 0)):
        return None
    result = []
    for seed in range(SEEDS):
        values = np.fromfile(picture(folder, renderer, seed), "<f4").reshape(HEIGHT, WIDTH, 3)
        result.append([values[mask][:, 1].mean() for mask in spheres])
    return np.array(result)


def table(folder):
    spheres = masks()
    print("| sphere | Lumbre | Lumbre / Mitsuba − 1 | Lumbre / Cycles − 1 |\n|---|--:|--:|--:|")
    own = means(folder, "lumbre-lumbre", spheres)
    pairs = {
        other: (means(folder, "lumbre-" + other, spheres), means(folder, other, spheres))
        for other in ("mitsuba", "cycles")
    }
    for i, (name, _, equals) in enumerate(MATERIALS):
        cells = []
        for other, pair in pairs.items():
            if other not in equals or any(found is None for found in pair):
                cells.append("–")
                continue
            first, second = (found[:, i].mean() for found in pair)
            errors = [found[:, i].std(ddof=1) / found[:, i].mean() / SEEDS**0.5 for found in pair]
            cells.append("%.2f %% ± %.2f" % (100 * (first / second - 1), 100 * np.hypot(*errors)))
        print("| %s | %.4f | %s | %s |" % (name, own[:, i].mean(), *cells))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--samples", type=int, default=64, help="of each of the four pictures")
    parser.add_argument("--folder", default=os.path.join(HOME, "target", "comparison", "spheres"))
    parser.add_argument("parts", nargs="*")
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    scenes = {}
    for renderer in ("lumbre", "mitsuba", "cycles"):
        scenes[renderer] = os.path.join(options.folder, renderer + ".json")
        write_scene(scenes[renderer], renderer)
    for part in options.parts or ["lumbre", "mitsuba", "cycles", "table"]:
        if part == "table":
            table(options.folder)
        elif part == "lumbre":
            for other, scene in scenes.items():
                lumbre(scene, options.folder, options.samples, other)
        elif options.parts:
            {"mitsuba": mitsuba, "cycles": cycles}[part](scenes[part], options.folder, options.samples)
        else:
            command = [sys.executable, __file__, "--samples", str(options.samples), "--folder", options.folder]
            subprocess.run([*command, part], check=True)


if __name__ == "__main__":
    main()
