"""Writes the simplest of Lumbre's scenes, matte planes and cubes under rectangles, for Sunflow.

Debian's Sunflow reads no scene files, so SunflowServer.java makes one call of each line:

    frame WIDTH HEIGHT DEPTH
    camera EYE TARGET UP DEGREES ASPECT      degrees across
    matte NUMBER COLOUR
    mesh MATTE POINTS TRIANGLES COORDINATES... CORNERS...
    lamp RADIANCE POINTS TRIANGLES COORDINATES... CORNERS...
"""

import json
import math

import numpy as np

from nodes import LYING, MIRROR, colour, halves, placed

SQUARE = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
CUBE = [
    [tuple(np.roll((a, b, side), axis)) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    for axis in range(3)
    for side in (-1, 1)
]


def numbers(values):
    return " ".join("%.9g" % value for value in values)


def squares(faces, matrix):
    """Points and triangles of squares, mirrored and turned so that their fronts stay fronts."""
    points, triangles = [], []
    for face in faces:
        first = len(points) // 3
        for corner in face:
            points.extend((MIRROR @ matrix @ [*corner, 1])[:3])
        triangles += [first, first + 2, first + 1, first, first + 3, first + 2]
    return [len(points) // 3, len(triangles) // 3, *points, *triangles]


def camera(node, matrix, aspect):
    eye = (MIRROR @ matrix)[:3, 3]
    target = eye + (MIRROR @ matrix)[:3, 2]
    slope = math.tan(math.radians(node.get("fieldOfView", 60)) / 2)
    across = 2 * math.degrees(math.atan(slope * aspect))
    return ["camera", *eye, *target, *(MIRROR @ matrix)[:3, 1], across, aspect]


def convert(source, target, width, height, depth):
    """Writes a scene; returns whether it could: nothing is replaced in silence."""
    with open(source, encoding="utf-8") as file:
        scene = json.load(file)
    # Sunflow counts the rays between surfaces, one less than the vertices that scatter.
    lines = [["frame", width, height, depth - 1]]
    for asset in scene["assets"]:
        if asset.get("materialType") != "Diffuse" or "colorTextureId" in asset:
            return False
        lines.append(["matte", asset["id"], *colour(asset.get("color"))])
    for node, matrix in placed(scene["objects"]):
        kind = node.get("type", "None")
        name = node.get("shapeType") or node.get("lightType") or node.get("cameraType")
        if kind == "Camera" and name == "Pinhole":
            lines.append(camera(node, matrix, width / height))
        elif kind == "Light" and name == "Rectangle" and node.get("unit") == "radiance":
            radiance = colour(node.get("color")) * node.get("intensity", 0)
            shape = squares([SQUARE], matrix @ halves(node, "width", "height"))
            lines.append(["lamp", *radiance, *shape])
        elif kind == "Shape" and name == "Plane":
            shape = squares([SQUARE], matrix @ LYING @ halves(node, "width", "height"))
            lines.append(["mesh", node["materialID"], *shape])
        elif kind == "Shape" and name == "Cube":
            shape = squares(CUBE, matrix @ halves(node, "width", "height", "depth"))
            lines.append(["mesh", node["materialID"], *shape])
        elif kind != "None":
            return False
    with open(target, "w", encoding="ascii") as file:
        for word, *values in lines:
            file.write(word + " " + numbers(values) + "\n")
    return True
