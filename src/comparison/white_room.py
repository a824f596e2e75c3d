"""Compares rough spheres in a white room with Cycles, and with random walks over their facets.

    python white_room.py [--samples N] [--folder FOLDER]

The room is a sky of radiance 1, so that a sphere that loses no light is invisible. A second picture has a black wall behind
the sphere, so that what is left is the light that the viewer's half of the room sends. The walks follow light over Smith's
GGX surface, from facet to facet (Heitz et al. 2016, "Multiple-Scattering Microfacet BSDFs with the Smith Model").
"""

import argparse
import json
import os

import numpy as np

import spheres

SIZE, FIELD, DISTANCE, RADIUS, RIM = 48, 7.0, 10.0, 0.5, 0.96
WALKS = 600000
IOR = 1.5
rng = np.random.default_rng(1)


def metal(color, roughness):
    return {"baseColor": color, "metallic": 1, "roughness": roughness}


MATERIALS = {
    **{"white metal, roughness %g" % r: metal(spheres.WHITE, r) for r in (0.5, 1)},
    **{"gold, roughness %g" % r: metal(spheres.GOLD, r) for r in (0.1, 0.5, 1)},
    **{"glass, roughness %g" % r: spheres.glass(r, ior=IOR) for r in (0.6, 0.7, 1)},
}


def write_scene(path, material, has_wall):
    camera = {"id": 1, "type": "Camera", "cameraType": "Pinhole", "fieldOfView": FIELD}
    sphere = {"id": 2, "type": "Shape", "shapeType": "Sphere", "radius": RADIUS, "materialID": 1}
    objects = [{**camera, "localPosition": spheres.place([0, 0, -DISTANCE])}, sphere]
    kind = {"assetType": "Material", "name": "rough", "materialType": "MetallicRoughness"}
    assets = [{"id": 1, **kind, **material}]
    if has_wall:
        black = {"id": 2, "assetType": "Material", "name": "black", "materialType": "Diffuse"}
        assets.append({**black, "color": {"r": 0, "g": 0, "b": 0}})
        wall = {"id": 3, "type": "Shape", "shapeType": "Plane", "finite": True, "width": 2000, "height": 2000}
        wall.update(materialID=2, localPosition=spheres.place([0, 0, RADIUS]))
        objects.append({**wall, "localRotation": spheres.place([-90, 0, 0])})
    options = {"mode": "path", "width": SIZE, "height": SIZE, "maxTraceDepth": 64, "background": spheres.WHITE}
    with open(path, "w", encoding="ascii") as out:
        json.dump({"mainCameraId": 1, "renderOptions": options, "assets": assets, "objects": objects}, out, indent=1)


def rendered(folder, renderer):
    """The mean of the sphere without its rim, and its standard error."""
    steps = ((np.arange(SIZE) + 0.5) / SIZE * 2 - 1) * np.tan(np.radians(FIELD / 2)) * DISTANCE
    inside = np.hypot(*np.meshgrid(steps, steps)) < RIM * RADIUS
    pictures = [
        np.fromfile(spheres.picture(folder, renderer, seed), "<f4").reshape(SIZE, SIZE, 3)[inside].mean(0)
        for seed in range(spheres.SEEDS)
    ]
    return np.mean(pictures, 0), np.std(pictures, 0, ddof=1) / spheres.SEEDS**0.5


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def next_height(direction, height, alpha):
    """The height of the next facet, in [-1,1], or infinity."""
    z, u = direction[:, 2], rng.random(len(height))
    share = np.clip((height + 1) / 2, 0, 1)
    with np.errstate(all="ignore"):
        masking = (np.sign(z) * np.sqrt(1 + alpha**2 * (1 / z**2 - 1)) - 1) / 2
        result = 2 * np.clip(share / (1 - u) ** (1 / masking), 0, 1) - 1
        result[(z > 0) & (u > 1 - share**masking)] = np.inf
    result[z > 0.99999] = np.inf
    steep = z < -0.99999
    result[steep] = (2 * u * share - 1)[steep]
    return np.where(np.abs(z) < 1e-5, height, result)


def visible_normals(direction, alpha):
    """Facets in proportion to their projected areas (Dupuy and Benyoub 2023)."""
    stretch = np.array([alpha, alpha, 1])
    stretched = unit(direction * stretch)
    z = (1 - rng.random(len(direction))) * (1 + stretched[:, 2]) - stretched[:, 2]
    across, turn = np.sqrt(np.clip(1 - z * z, 0, 1)), 2 * np.pi * rng.random(len(direction))
    cap = np.stack([across * np.cos(turn), across * np.sin(turn), z], 1)
    return unit((cap + stretched) * stretch)


def fresnel(cosine, eta):
    square = 1 - (1 - cosine**2) / eta**2
    inner = np.sqrt(np.clip(square, 0, 1))
    across = (cosine - eta * inner) / (cosine + eta * inner)
    along = (eta * cosine - inner) / (eta * cosine + inner)
    return np.where(square <= 0, 1, (across**2 + along**2) / 2), inner


def walk(viewer, eta, alpha, color):
    """The direction of each walk's end, whether it is below the surface, and its weight."""
    direction, height = -viewer, np.ones(len(viewer))
    above, weight, live = np.ones(len(viewer), bool), np.ones_like(viewer), np.arange(len(viewer))
    while True:
        side = np.where(above[live], 1.0, -1.0)
        at = next_height(direction[live] * side[:, None], side * height[live], alpha)
        hits = np.isfinite(at)
        live, side = live[hits], side[hits]
        if len(live) == 0:
            return direction, ~above, weight
        height[live] = side * at[hits]
        back = -direction[live] * side[:, None]
        facet = visible_normals(back, alpha)
        cosine = np.clip((back * facet).sum(1), 0, 1)
        turned = 2 * cosine[:, None] * facet - back
        if color is not None:
            weight[live] *= color + (1 - color) * ((1 - cosine) ** 5)[:, None]
        else:
            index = np.where(side > 0, eta, 1 / eta)
            reflectance, inner = fresnel(cosine, index)
            passes = rng.random(len(live)) >= reflectance
            bent = facet * (cosine / index - inner)[:, None] - back / index[:, None]
            turned = unit(np.where(passes[:, None], bent, turned))
            above[live] ^= passes
        direction[live] = turned * side[:, None]


def frames(normals):
    away = np.where(np.abs(normals[:, :1]) > 0.5, [[0.0, 1, 0]], [[1.0, 0, 0]])
    tangents = unit(np.cross(away, normals))
    return np.stack([tangents, np.cross(normals, tangents), normals], 1)


def walked(material):
    """The means of what walks bring from all sides, and from the viewer's half, with their standard errors."""
    is_metal = material["metallic"] == 1
    color = np.array([material["baseColor"][c] for c in "rgb"]) if is_metal else None
    alpha = material["roughness"] ** 2
    across, turn = RIM * RADIUS * np.sqrt(rng.random(WALKS)), 2 * np.pi * rng.random(WALKS)
    direction = unit(np.stack([across * np.cos(turn), across * np.sin(turn), np.full(WALKS, DISTANCE)], 1))
    middle = DISTANCE * direction[:, 2]
    near = middle - np.sqrt(middle**2 - DISTANCE**2 + RADIUS**2)
    point = near[:, None] * direction - [0, 0, DISTANCE]
    inside, weight, live = np.zeros(WALKS, bool), np.ones((WALKS, 3)), np.arange(WALKS)
    while len(live) > 0:
        for is_inside in (False, True):
            some = live[inside[live] == is_inside]
            local = frames(point[some] / (-RADIUS if is_inside else RADIUS))
            viewer = -np.einsum("nij,nj->ni", local, direction[some])
            viewer[:, 2] = np.maximum(viewer[:, 2], 1e-6)
            turned, below, factor = walk(viewer, 1 / IOR if is_inside else IOR, alpha, color)
            weight[some] *= factor
            direction[some] = np.einsum("nij,ni->nj", local, turned)
            inside[some] = below != is_inside
        live = live[inside[live]]
        chord = -2 * (point[live] * direction[live]).sum(1)
        point[live] = RADIUS * unit(point[live] + chord[:, None] * direction[live])
    halves = (direction[:, 2] < 0)[:, None] * weight
    return [(values.mean(0), values.std(0) / WALKS**0.5) for values in (weight, halves)]


def cell(found):
    mean, error = found
    values = mean if np.ptp(mean) > 0.01 else mean[1:2]
    return ", ".join("%.4f" % value for value in values) + " ± %.4f" % error.max()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--samples", type=int, default=128, help="of each of the two pictures")
    parser.add_argument("--folder", default=os.path.join(spheres.HOME, "target", "comparison", "white-room"))
    options = parser.parse_args()
    spheres.WIDTH = spheres.HEIGHT = SIZE
    spheres.SEEDS, spheres.DEPTH = 2, 64
    lines = []
    for i, (name, material) in enumerate(MATERIALS.items()):
        walks = walked(material)
        for has_wall in (False, True):
            folder = os.path.join(options.folder, "%d%s" % (i, "-wall" if has_wall else ""))
            os.makedirs(folder, exist_ok=True)
            scene = os.path.join(folder, "scene.json")
            write_scene(scene, material, has_wall)
            spheres.lumbre(scene, folder, options.samples)
            spheres.cycles(scene, folder, options.samples)
            part = "the viewer's half" if has_wall else "all"
            columns = [rendered(folder, "lumbre-lumbre"), rendered(folder, "cycles"), walks[has_wall]]
            lines.append("| %s | %s | %s |" % (name, part, " | ".join(map(cell, columns))))
    print("| sphere | light of | Lumbre | Cycles | walks |\n|---|---|--:|--:|--:|", *lines, sep="\n")


if __name__ == "__main__":
    main()
