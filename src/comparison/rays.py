"""Meshes in a closed room and the rays of paths in it, as files for both kernels."""

import numpy as np

SIDE = 512
TILE = 16
INFINITE = np.float32(np.inf)


def read_obj(path):
    """Positions and triangles of an OBJ file."""
    positions, triangles = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                positions.append([float(word) for word in words[1:4]])
            elif words and words[0] == "f":
                corners = [int(word.split("/")[0]) - 1 for word in words[1:]]
                for i in range(2, len(corners)):
                    triangles.append([corners[0], corners[i - 1], corners[i]])
    return np.array(positions, dtype="<f4"), np.array(triangles, dtype="<i4")


def in_room(positions, triangles):
    """Adds a room of twelve triangles around a mesh; returns the room's corners too."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    margin = (high - low).max()
    low = low - [margin, 0.001 * margin, margin]
    high = high + margin
    corners = [[(low, high)[(i >> axis) & 1][axis] for axis in range(3)] for i in range(8)]
    squares = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    walls = [(a, b, c) for a, b, c, d in squares] + [(a, c, d) for a, b, c, d in squares]
    walls = np.array(walls) + len(positions)
    positions = np.concatenate([positions, corners]).astype("<f4")
    return positions, np.concatenate([triangles, walls]).astype("<i4"), low, high


def write_mesh(positions, triangles, path):
    positions.astype("<f4").tofile(path + ".positions")
    triangles.astype("<i4").tofile(path + ".indices")
    return path


def write_rays(origins, directions, lengths, path):
    rays = np.column_stack([origins, directions, lengths]).astype("<f4")
    rays.tofile(path)
    return rays


def normalized(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def tiled_pixels():
    """Pixels of a square in the order of tiles, as renderers take them."""
    y, x = np.mgrid[0:SIDE, 0:SIDE]
    order = np.lexsort((x.ravel(), y.ravel(), x.ravel() // TILE, y.ravel() // TILE))
    return x.ravel()[order], y.ravel()[order]


def camera_rays(low, high, random):
    """From a corner of the room towards its middle, one through each pixel of a square."""
    middle = low + (high - low) * [0.5, 0.3, 0.5]
    eye = low + (high - low) * [0.2, 0.6, 0.08]
    forward = normalized(middle - eye)
    right = normalized(np.cross([0, 1, 0], forward))
    up = np.cross(forward, right)
    x, y = tiled_pixels()
    u, v = (2 * (k + random.random(len(k))) / SIDE - 1 for k in (x, y))
    directions = normalized(forward + 0.6 * (u[:, None] * right - v[:, None] * up))
    return np.broadcast_to(eye, directions.shape), directions


def scattered(origins, directions, hits, size, random):
    """Where rays end, on the side they came from; and directions as matte surfaces scatter them."""
    found = np.isfinite(hits[:, 0])
    origins, directions, hits = origins[found], directions[found], hits[found]
    normals = hits[:, 1:]
    normals = np.where((normals * directions).sum(axis=1, keepdims=True) > 0, -normals, normals)
    points = origins + hits[:, :1] * directions + 1e-4 * size * normals
    sphere = normalized(random.standard_normal(points.shape))
    return points, normalized(normals + 0.999 * sphere)


def to_lamp(points, low, high, random):
    """Directions and distances to points of a lamp under the ceiling."""
    place = random.random(points.shape) * [0.3, 0, 0.3] + [0.35, 0.98, 0.35]
    way = low + (high - low) * place - points
    lengths = np.linalg.norm(way, axis=1)
    return way / lengths[:, None], lengths * 0.999


def make(positions, triangles, kernel, path):
    """Writes a mesh in its room and its rays; kernel, a server, finds where the camera's end."""
    random = np.random.default_rng(1)
    positions, triangles, low, high = in_room(positions, triangles)
    kernel.ask("load", write_mesh(positions, triangles, path))
    origins, directions = camera_rays(low, high, random)
    camera = write_rays(origins, directions, np.full(len(origins), INFINITE), path + ".camera")
    kernel.ask("rays", path + ".camera")
    kernel.ask("hits", path + ".found")
    hits = np.fromfile(path + ".found", "<f4").reshape(-1, 4).astype(float)
    origins, directions = camera[:, :3].astype(float), camera[:, 3:6].astype(float)
    points, ways = scattered(origins, directions, hits, (high - low).max(), random)
    write_rays(points, ways, np.full(len(points), INFINITE), path + ".scattered")
    ways, lengths = to_lamp(points, low, high, random)
    write_rays(points, ways, lengths, path + ".shadow")
    return len(triangles)
