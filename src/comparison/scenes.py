"""The scenes of the comparison: the project's own, and some that are made here."""

import json
import os
import shutil

import numpy as np

WHITE = {"r": 0.7, "g": 0.7, "b": 0.7}


def write(scene, path):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(scene, file, indent=1)
    return path


def prepare(home, work):
    """Copies the scenes that all renderers can read; returns {name: (path, width, height)}."""
    source = os.path.join(home, "scenes")
    target = os.path.join(work, "scenes")
    shutil.copytree(
        os.path.join(source, "models"), os.path.join(target, "models"), dirs_exist_ok=True
    )
    # None but Lumbre has a fisheye of this kind, so the frog is seen by a pinhole.
    with open(os.path.join(source, "table-15-frog.json"), encoding="utf-8") as file:
        frog = json.load(file)
    camera = next(node for node in frog["objects"] if node["type"] == "Camera")
    del camera["angle"]
    camera.update(cameraType="Pinhole", fieldOfView=80)
    scenes = {"frog, pinhole": (write(frog, os.path.join(target, "frog.json")), 240, 240)}
    sizes = {
        "cornell-box": (320, 240),
        "table-01-depth-of-field-400mm": (320, 180),
        "table-04-armoured-figure": (320, 180),
    }
    for name, size in sizes.items():
        path = shutil.copy(os.path.join(source, name + ".json"), target)
        scenes[name] = (path, *size)
    return dict(sorted(scenes.items()))


def lamps(count, folder):
    """Blocks on a floor under a square number of lamps, which are always as bright together."""
    side = round(count**0.5)
    assert side * side == count
    objects = [
        {
            "id": 1,
            "type": "Camera",
            "cameraType": "Pinhole",
            "fieldOfView": 45,
            "localPosition": {"x": 0, "y": 6, "z": -12},
            "localRotation": {"x": 22, "y": 0, "z": 0},
        },
        {
            "type": "Shape",
            "shapeType": "Plane",
            "finite": True,
            "width": 20,
            "height": 20,
            "materialID": 1,
        },
    ]
    for i in range(9):
        x, z = 3 * (i % 3) - 3, 3 * (i // 3) - 3
        objects.append(
            {
                "type": "Shape",
                "shapeType": "Cube",
                "width": 1,
                "height": 2,
                "depth": 1,
                "materialID": 1,
                "localPosition": {"x": x, "y": 1, "z": z},
                "localRotation": {"x": 0, "y": 10 * i, "z": 0},
            }
        )
    for i in range(count):
        x, z = (10 * ((k + 0.5) / side - 0.5) for k in (i % side, i // side))
        objects.append(
            {
                "type": "Light",
                "lightType": "Rectangle",
                "unit": "radiance",
                "intensity": 10,
                "width": 2 / side,
                "height": 2 / side,
                "localPosition": {"x": x, "y": 4, "z": z},
                "localRotation": {"x": 90, "y": 0, "z": 0},
            }
        )
    material = {"id": 1, "assetType": "Material", "materialType": "Diffuse", "color": WHITE}
    scene = {"mainCameraId": 1, "assets": [material], "objects": objects}
    return write(scene, os.path.join(folder, "lamps-%d.json" % count))


def ball(triangles):
    """A wavy ball of about so many triangles: positions and indices."""
    rows = max(3, round((triangles / 4) ** 0.5))
    columns = 2 * rows
    down, around = np.meshgrid(
        np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij"
    )
    radius = 0.8 + 0.1 * np.sin(18 * np.pi * around) * np.sin(6 * np.pi * down)
    flat = radius * np.sin(np.pi * down)
    turn = 2 * np.pi * around
    positions = [flat * np.cos(turn), radius * np.cos(np.pi * down), flat * np.sin(turn)]
    positions = np.stack(positions, axis=-1).reshape(-1, 3).astype("<f4")
    row, column = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    corner = (row * (columns + 1) + column).ravel()
    below = corner + columns + 1
    upper = np.stack([corner, corner + 1, below], axis=-1)
    lower = np.stack([corner + 1, below + 1, below], axis=-1)
    # At the poles one of the two has no area.
    upper, lower = upper[columns:], lower[:-columns]
    return positions, np.concatenate([upper, lower]).astype("<i4")


def ball_scene(triangles, folder):
    """A wavy ball on a floor, as an OBJ file and a scene that shows it."""
    positions, indices = ball(triangles)
    obj = "ball-%d.obj" % triangles
    with open(os.path.join(folder, obj), "w", encoding="ascii") as file:
        for part in np.array_split(positions, max(1, len(positions) // 100000)):
            file.write(("v %.7g %.7g %.7g\n" * len(part)) % tuple(part.ravel()))
        for part in np.array_split(indices + 1, max(1, len(indices) // 100000)):
            file.write(("f %d %d %d\n" * len(part)) % tuple(part.ravel()))
    scene = {
        "mainCameraId": 1,
        "assets": [
            {"id": 1, "assetType": "Material", "materialType": "Diffuse", "color": WHITE},
            {"id": 2, "assetType": "Mesh", "file": obj},
        ],
        "objects": [
            {
                "id": 1,
                "type": "Camera",
                "cameraType": "Pinhole",
                "fieldOfView": 40,
                "localPosition": {"x": 0, "y": 0.2, "z": -3},
            },
            {"type": "Shape", "shapeType": "Mesh", "meshId": 2, "materialID": 1},
            {
                "type": "Shape",
                "shapeType": "Plane",
                "materialID": 1,
                "localPosition": {"x": 0, "y": -0.9, "z": 0},
            },
            {
                "type": "Light",
                "lightType": "Rectangle",
                "unit": "radiance",
                "intensity": 10,
                "localPosition": {"x": -1, "y": 3, "z": -1},
                "localRotation": {"x": 90, "y": 0, "z": 0},
            },
        ],
    }
    return write(scene, os.path.join(folder, "ball-%d.json" % triangles)), len(indices)


# The twelve scenes of the suite, and the size that each is rendered with.
SUITE = {
    "cornell-box": (160, 120),
    "table-15-frog": (128, 128),
    "table-01-depth-of-field-400mm": (176, 99),
    "table-04-armoured-figure": (176, 99),
    "table-11-marble": (128, 128),
    "table-12-wood": (128, 128),
    "table-13-voronoi": (128, 128),
    "glass-and-mirror": (168, 112),
    "cornell-box-dome": (160, 120),
    "torus-knot": (128, 128),
    "lantern": (120, 120),
    "door-ajar": (160, 120),
}


def suite(home, work, bake):
    """Makes the suite's scenes so that others can read them; returns {name: (path, width, height, depth)}.

    bake(path, folder) writes the procedural textures of a scene as ID.png.
    """
    source = os.path.join(home, "scenes")
    target = os.path.join(work, "suite")
    for folder in ("models", "textures"):
        shutil.copytree(
            os.path.join(source, folder), os.path.join(target, folder), dirs_exist_ok=True
        )
    shutil.copy(os.path.join(source, "torus-knot.obj"), target)
    result = {}
    for name, (width, height) in SUITE.items():
        original = os.path.join(source, name + ".json")
        with open(original, encoding="utf-8") as file:
            scene = json.load(file)
        simplify(name, scene)
        procedural = [a for a in scene["assets"] if a.get("textureType", "Image") != "Image"]
        if procedural:
            folder = os.path.join(target, "baked-" + name)
            os.makedirs(folder, exist_ok=True)
            bake(original, folder)
        for asset in procedural:
            asset.update(textureType="Image", file="baked-%s/%d.png" % (name, asset["id"]))
        depth = scene["renderOptions"].get("maxTraceDepth", 5)
        path = write(scene, os.path.join(target, name + ".json"))
        result[name] = (path, width, height, depth)
    return result


def simplify(name, scene):
    """Replaces what others have no equal of; all renderers, Lumbre too, are given the same."""
    objects = scene["objects"]
    if name == "table-15-frog":
        # None but Lumbre has a fisheye of this kind, so the frog is seen by a pinhole.
        camera = next(node for node in objects if node["type"] == "Camera")
        del camera["angle"]
        camera.update(cameraType="Pinhole", fieldOfView=80)
    elif name in ("table-11-marble", "table-13-voronoi"):
        # The camera looks through the back of this wall, which is solid elsewhere.
        objects[:] = [node for node in objects if node.get("name") != "front"]
    elif name == "glass-and-mirror":
        # An infinite plane is known to Lumbre alone: 200 instead, with squares of the same size.
        floor = next(node for node in objects if node.get("name") == "floor")
        floor.update(finite=True, width=200, height=200)
        tiles = next(asset for asset in scene["assets"] if asset.get("name") == "tiles")
        tiles["colorScale"] = {"x": 100, "y": 100}
