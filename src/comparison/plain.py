"""A scene of Lumbre's as triangles in right-handed space, for programs without its shapes.

Knows finite planes, cubes, spheres, meshes, lamps of radiance, domes, a background, cameras with and without
a lens, and image textures; all else is refused. Mirrored (see nodes.py), so that fronts stay fronts.
"""

import dataclasses
import json
import os

import numpy as np

from nodes import LYING, MIRROR, SQUARE, SQUARE_UV, colour, halves, placed, scale, vector

# A sphere's rings; its normals are smooth.
RINGS = 64
# The faces of a cube from -1 to 1, whose corners go around the outward normal.
CUBE = [np.array(face) * 2.0 - 1 for face in (
    [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]],
    [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
    [[0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]],
    [[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]],
    [[0, 1, 0], [0, 1, 1], [1, 1, 1], [1, 1, 0]],
    [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]],
)]
QUAD = np.array([[0, 1, 2], [0, 2, 3]])


@dataclasses.dataclass
class Surface:
    """Triangles that go around their front counter-clockwise; normals and uv are for each corner, or None."""

    positions: np.ndarray
    triangles: np.ndarray
    material: dict | None = None
    radiance: np.ndarray | None = None
    normals: np.ndarray | None = None
    uv: np.ndarray | None = None


class PlainScene:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.scene = json.load(file)
        self.home = os.path.dirname(path)
        self.assets = {asset["id"]: asset for asset in self.scene.get("assets", [])}
        self.surfaces = []
        # Linear rows from the top, as seen from inside; u = .5 + atan2(-x, z) / 2 pi. Or a constant colour.
        self.environment = None
        background = self.scene["renderOptions"].get("background")
        if background is not None:
            self.environment = colour(background)
        for node, matrix in placed(self.scene["objects"]):
            kind = node.get("type", "None")
            if kind == "Shape":
                self.shape(node, matrix)
            elif kind == "Light":
                self.light(node, matrix)
            elif kind == "Camera" and node.get("id") == self.scene["mainCameraId"]:
                # Looks along its +z.
                self.camera, self.view = node, MIRROR @ matrix @ MIRROR
            elif kind != "None":
                refuse(node)

    def shape(self, node, matrix):
        kind, material = node.get("shapeType"), self.assets[node["materialID"]]
        if kind == "Plane" and node.get("finite"):
            self.square(matrix @ LYING @ halves(node, "width", "height"), material)
        elif kind == "Cube":
            size = matrix @ halves(node, "width", "height", "depth")
            for face in CUBE:
                self.add(size, face, QUAD, material)
        elif kind == "Sphere":
            self.sphere(matrix, node.get("radius", 1), material)
        elif kind == "Mesh":
            self.mesh(matrix, self.assets[node["meshId"]], material)
        else:
            refuse(node)

    def light(self, node, matrix):
        radiance = colour(node.get("color")) * node.get("intensity", 0)
        if node["lightType"] == "Dome" and "textureId" in node:
            picture = self.picture(self.assets[node["textureId"]]) * radiance
            turn = vector(node.get("localRotation"), 0.0)
            columns = picture.shape[1] * turn[1] / 360
            if turn[0] or turn[2]:
                refuse(node)
            whole, part = divmod(columns, 1)
            rolled = [np.roll(picture, int(whole) + i, axis=1) for i in (0, 1)]
            self.environment = (1 - part) * rolled[0] + part * rolled[1]
        elif node.get("unit") != "radiance":
            refuse(node)
        elif node["lightType"] == "Rectangle":
            self.square(matrix @ halves(node, "width", "height"), None, radiance)
        elif node["lightType"] == "Sphere":
            self.sphere(matrix, node.get("radius", 1), None, radiance)
        else:
            refuse(node)

    def square(self, matrix, material, radiance=None):
        self.add(matrix, SQUARE, QUAD, material, radiance, uv=SQUARE_UV)

    def sphere(self, matrix, radius, material, radiance=None):
        down, around = np.meshgrid(
            np.linspace(0, np.pi, RINGS + 1), np.linspace(0, 2 * np.pi, 2 * RINGS + 1), indexing="ij"
        )
        flat = np.sin(down)
        points = np.stack([flat * np.cos(around), np.cos(down), flat * np.sin(around)], -1)
        points = points.reshape(-1, 3)
        row, column = np.meshgrid(np.arange(RINGS), np.arange(2 * RINGS), indexing="ij")
        corner = (row * (2 * RINGS + 1) + column).ravel()
        below = corner + 2 * RINGS + 1
        upper = np.stack([corner, corner + 1, below], -1)[2 * RINGS :]
        lower = np.stack([corner + 1, below + 1, below], -1)[: -2 * RINGS]
        # Corners on the sphere make a solid that is too small; one of the same area is larger.
        self.add(
            matrix @ scale(*[radius / np.cos(np.pi / RINGS / 2) ** 0.5] * 3),
            points,
            np.concatenate([upper, lower]),
            material,
            radiance,
            normals=points,
        )

    def mesh(self, matrix, asset, material):
        positions, normals, uv, corners = read_obj(os.path.join(self.home, asset["file"]))
        self.add(
            matrix,
            positions[corners[:, 0]],
            np.arange(len(corners)).reshape(-1, 3),
            material,
            normals=normals[corners[:, 2]] if len(normals) else None,
            uv=uv[corners[:, 1]] if len(uv) else None,
        )

    def add(self, matrix, positions, triangles, material, radiance=None, normals=None, uv=None):
        matrix = MIRROR @ matrix
        positions = (matrix[:3, :3] @ positions.T).T + matrix[:3, 3]
        if normals is not None:
            normals = (np.linalg.inv(matrix[:3, :3]).T @ normals.T).T
            normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
        # The mirror turns triangles inside out. Fronts of meshes are where their normals point.
        triangles = triangles[:, ::-1].copy()
        if normals is not None:
            corners = positions[triangles]
            front = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            back = np.sum(front * normals[triangles].sum(axis=1), axis=-1) < 0
            triangles[back] = triangles[back][:, ::-1]
        self.surfaces.append(Surface(positions, triangles, material, radiance, normals, uv))

    def picture(self, asset, encoded=True):
        """An image texture: linear values in rows from the top, or plain bytes if not encoded."""
        if asset.get("textureType", "Image") != "Image":
            refuse(asset)
        bytes_ = read_png(os.path.join(self.home, asset["file"]))
        if not encoded:
            return bytes_
        value = bytes_ / 255
        return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)

    def channel(self, material, name):
        """A channel's colour, and its texture: values, whether bilinear, and scale, or None."""
        constant, identity = colour(material.get(name)), material.get(name + "TextureId")
        if identity is None:
            return constant, None
        if name + "Offset" in material:
            refuse(material)
        asset, factor = self.assets[identity], material.get(name + "Scale", {"x": 1, "y": 1})
        values = self.picture(asset) * constant
        return constant, (values, asset.get("filter") == "bilinear", (factor["x"], factor["y"]))

    def relief(self, material):
        """A normal map from 0 to 1, flat at one half, or None."""
        identity = material.get("normalTextureId")
        if identity is None:
            return None
        # Flat is 128 to Lumbre.
        return ((self.picture(self.assets[identity], encoded=False) - 128) / 127 + 1) / 2


def refuse(what):
    raise ValueError("not given to other programs: " + str(what))


def enlarged(picture, least=512):
    """The picture with texels repeated, so that smoothing between them hardly shows."""
    times = max(1, -(-least // min(picture.shape[:2])))
    return picture.repeat(times, axis=0).repeat(times, axis=1)


def read_png(path):
    from PIL import Image

    with Image.open(path) as picture:
        return np.array(picture.convert("RGB"), dtype=float)


def read_obj(path):
    """Positions, normals, uv, and for each corner of triangles the indices of position, uv, normal."""
    lists, corners = {"v": [], "vt": [], "vn": []}, []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words and words[0] in lists:
                lists[words[0]].append([float(w) for w in words[1:4]])
            elif words and words[0] == "f":
                face = [[int(i or 1) - 1 for i in (w + "//").split("/")[:3]] for w in words[1:]]
                for i in range(1, len(face) - 1):
                    corners += [face[0], face[i], face[i + 1]]
    uv = np.array(lists["vt"])[:, :2] if lists["vt"] else np.empty((0, 2))
    return np.array(lists["v"]), np.array(lists["vn"]), uv, np.array(corners)
