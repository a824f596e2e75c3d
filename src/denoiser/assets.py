"""Random textures, skies and meshes for training scenes."""

import numpy as np
from PIL import Image, ImageDraw

SIZE = 128


def noise(rng, n, octaves, persistence=0.5, base=4):
    """Returns tiling value noise of n x n values in [0,1]."""
    total = np.zeros((n, n))
    amplitude = 1.0
    for octave in range(octaves):
        k = base * 2**octave
        if k > n:
            break
        grid = rng.random((k, k))
        x = np.arange(n) * k / n
        i = x.astype(int)
        f = x - i
        f = f * f * (3 - 2 * f)
        j = (i + 1) % k
        top = grid[np.ix_(i, i)] * (1 - f) + grid[np.ix_(i, j)] * f
        bottom = grid[np.ix_(j, i)] * (1 - f) + grid[np.ix_(j, j)] * f
        total += amplitude * (top * (1 - f)[:, None] + bottom * f[:, None])
        amplitude *= persistence
    return (total - total.min()) / (np.ptp(total) + 1e-9)


def color(rng, saturation=0.6, low=0.05, high=0.9):
    """Returns a linear color of a random brightness."""
    tint = rng.random(3)
    tint /= tint.max()
    amount = rng.uniform(0, saturation) if rng.random() < 0.6 else rng.random()
    return rng.uniform(low, high) * (1 - amount + amount * tint)


def srgb(linear):
    return Image.fromarray((255 * np.clip(linear, 0, 1) ** (1 / 2.2)).astype(np.uint8))


def drawn(rng, n, paint):
    image = Image.new("L", (n, n), 0)
    paint(ImageDraw.Draw(image))
    return np.asarray(image) / 255.0


def spots(rng, n):
    def paint(draw):
        for _ in range(int(rng.integers(5, 60))):
            x, y, r = rng.uniform(0, n), rng.uniform(0, n), rng.uniform(1, 14)
            shape = draw.ellipse if rng.random() < 0.5 else draw.rectangle
            shape([x - r, y - r * rng.uniform(0.3, 1), x + r, y + r], fill=int(rng.uniform(60, 255)))

    return drawn(rng, n, paint)


def text(rng, n):
    def paint(draw):
        for line in range(12):
            draw.text((rng.uniform(-5, 20), line * 11), "".join(chr(c) for c in rng.integers(33, 120, 24)), fill=255)

    return drawn(rng, n, paint)


def panels(rng, n):
    """Returns plates with gaps between them, as on machines."""

    def paint(draw):
        draw.rectangle([0, 0, n, n], fill=200)
        for _ in range(int(rng.integers(6, 30))):
            x, y = rng.integers(0, n, 2)
            w, h = rng.integers(8, n // 2, 2)
            draw.rectangle([int(x), int(y), int(x + w), int(y + h)], fill=int(rng.integers(90, 255)), outline=0)

    return drawn(rng, n, paint)


def bricks(rng, n):
    y, x = np.mgrid[0:n, 0:n] / n
    row = np.floor(y * 8)
    column = x * 4 + 0.5 * (row % 2)
    shade = 0.6 + 0.4 * rng.random((8, 5))
    return ((column % 1 > 0.06) & (y * 8 % 1 > 0.1)) * shade[row.astype(int), np.floor(column).astype(int) % 5]


def stripes(rng, n):
    y, x = np.mgrid[0:n, 0:n] / n
    phase = 2 * np.pi * (x * int(rng.integers(1, 9)) + y * int(rng.integers(0, 9)))
    return (np.sin(phase + rng.uniform(0, 4) * noise(rng, n, 4)) > rng.uniform(-0.5, 0.5)) * 1.0


def mask(rng, n):
    """Returns a pattern in [0,1]."""
    y, x = np.mgrid[0:n, 0:n] / n
    patterns = [
        lambda: (np.floor(x * 8) + np.floor(y * 8)) % 2,
        lambda: stripes(rng, n),
        lambda: noise(rng, n, 6, rng.uniform(0.4, 0.8)),
        lambda: spots(rng, n),
        lambda: text(rng, n),
        lambda: bricks(rng, n),
        lambda: np.abs(np.sin(rng.uniform(3, 14) * np.pi * noise(rng, n, 5))),
        lambda: panels(rng, n),
    ]
    return patterns[int(rng.integers(len(patterns)))]()


def painted(rng, n=SIZE):
    """Returns a colored picture."""
    if rng.random() < 0.1:
        return srgb(np.kron(rng.random((16, 16, 3)), np.ones((n // 16, n // 16, 1))))
    one, other = color(rng, 0.9, 0.02, 0.95), color(rng, 0.9, 0.02, 0.95)
    picture = one + (other - one) * mask(rng, n)[..., None]
    if rng.random() < 0.3:
        picture = picture * (0.6 + 0.4 * noise(rng, n, 6)[..., None])
    return srgb(picture)


def normals(rng, heights, strength):
    across = (np.roll(heights, -1, 1) - np.roll(heights, 1, 1)) * strength
    down = (np.roll(heights, -1, 0) - np.roll(heights, 1, 0)) * strength
    n = np.stack([-across, down, np.ones_like(heights)], -1)
    n /= np.linalg.norm(n, axis=-1, keepdims=True)
    return Image.fromarray(np.clip(128 + 127 * n, 0, 255).astype(np.uint8))


def shaded(rng, heights):
    """Returns a picture of two colors that follows heights, as paint or dirt does."""
    one, other = color(rng, 0.3, 0.2, 0.95), color(rng, 0.5, 0.05, 0.8)
    return srgb(other + (one - other) * np.clip(heights / (heights.max() + 1e-9), 0, 1)[..., None])


def treads(rng, n):
    """Returns raised strips that lie crosswise in turn, as on floors of metal."""
    y, x = np.mgrid[0:n, 0:n] / n
    k = int(rng.choice([2, 3, 4, 6]))
    u, v = k * (x + y), k * (x - y)
    across = (np.floor(u) + np.floor(v)) % 2 == 0
    fu, fv = np.abs(u % 1 - 0.5), np.abs(v % 1 - 0.5)
    long, short = rng.uniform(0.3, 0.45), rng.uniform(0.08, 0.2)
    bar = np.where(across, np.maximum(fu / long, fv / short), np.maximum(fu / short, fv / long))
    return np.clip(3 * (1 - bar), 0, 1)


def relief(rng, n=SIZE):
    """Returns heights of bumps, ripples, weaves, plates or bricks."""
    y, x = np.mgrid[0:n, 0:n] / n
    k = int(rng.integers(2, 20))
    kinds = [
        lambda: noise(rng, n, 6, rng.uniform(0.4, 0.7), int(rng.choice([4, 8, 16]))),
        lambda: np.abs(np.sin(np.pi * k * x)) * np.abs(np.sin(np.pi * k * y)),
        lambda: np.where((np.floor(k * x) + np.floor(k * y)) % 2, np.sin(np.pi * k * x) ** 2, np.sin(np.pi * k * y) ** 2),
        lambda: treads(rng, n),
        lambda: treads(rng, n) + 0.05 * noise(rng, n, 6, 0.6),
        lambda: panels(rng, n),
        lambda: bricks(rng, n) + 0.1 * noise(rng, n, 6),
        lambda: 0.5 * panels(rng, n) + 0.5 * noise(rng, n, 6, 0.6),
    ]
    return kinds[int(rng.integers(len(kinds)))]()


def mask_of_lens(rng, n=64):
    """Returns the form of a lens: a polygon, a star, a flower or a ring, white on black."""
    y, x = (np.mgrid[0:n, 0:n] + 0.5) / n * 2 - 1
    radius, angle, k = np.hypot(x, y), np.arctan2(y, x) + rng.uniform(0, 6.28), int(rng.integers(3, 8))
    wedge = np.cos(np.abs((angle % (2 * np.pi / k)) - np.pi / k))
    forms = [
        radius * wedge < 0.95 * np.cos(np.pi / k),
        radius < 0.95 * (0.7 + 0.3 * np.cos(k * angle)),
        (radius < 0.95) & (radius > rng.uniform(0.3, 0.7)),
    ]
    return Image.fromarray((255 * forms[int(rng.integers(len(forms)))]).astype(np.uint8))


def pbr(rng, folder, name, n=SIZE):
    """Writes the pictures of a worn material: base color, roughness, metallic share and normal map of one pattern."""
    heights = relief(rng, n)
    wear = np.clip(2 * noise(rng, n, 6, 0.6) - rng.uniform(0.2, 1.2), 0, 1)
    one, other, worn = (color(rng, 0.8, 0.03, 0.95) for _ in range(3))
    base = one + (other - one) * (mask(rng, n) if rng.random() < 0.6 else heights)[..., None]
    base = base * (1 - wear[..., None]) + worn * wear[..., None]
    rough = np.clip(rng.uniform(0, 0.8) + rng.uniform(-0.5, 0.5) * wear + rng.uniform(-0.4, 0.4) * noise(rng, n, 6, 0.7), 0.03, 1)
    metal = np.full((n, n), float(rng.random() < 0.5)) if rng.random() < 0.6 else (wear > 0.3) * 1.0
    srgb(base).save("%s/%s-base.png" % (folder, name))
    Image.fromarray((255 * rough).astype(np.uint8)).save("%s/%s-rough.png" % (folder, name))
    Image.fromarray((255 * metal).astype(np.uint8)).save("%s/%s-metal.png" % (folder, name))
    normals(rng, heights, rng.uniform(1, 10)).save("%s/%s-normal.png" % (folder, name))


def sky(rng, file, w=256, h=128):
    """Writes a sky of a high dynamic range: a gradient with clouds, maybe a sun, or a room with lamps."""
    y, x = np.mgrid[0:h, 0:w]
    elevation, azimuth = (0.5 - y / h) * np.pi, x / w * 2 * np.pi
    zenith, horizon, ground = color(rng, 0.8, 0.1, 0.6), color(rng, 0.5, 0.2, 0.8), color(rng, 0.5, 0.03, 0.4)
    blend = np.clip(np.sin(elevation), 0, 1)[..., None] ** rng.uniform(0.3, 0.8)
    light = np.where(elevation[..., None] < 0, ground, horizon + (zenith - horizon) * blend)
    if rng.random() < 0.6:
        clouds = np.kron(np.tile(noise(rng, h, 6, 0.6), (1, 2)), np.ones((1, 1)))
        light = light * (0.4 + 1.2 * clouds[..., None] ** rng.uniform(1, 3))
    if rng.random() < 0.15:
        light = light * 0.05
    for _ in range(int(rng.integers(0, 5))):
        a, e, r = rng.uniform(0, 6.28), rng.uniform(0.02, 1.4), np.exp(rng.uniform(np.log(0.03), np.log(0.5)))
        near = np.cos(elevation) * np.cos(e) * np.cos(azimuth - a) + np.sin(elevation) * np.sin(e)
        power = np.exp(rng.uniform(np.log(0.3), np.log(4))) / (r * r)
        light = np.where(near[..., None] > np.cos(r), min(power, 600.0) * (1 - 0.3 * rng.random(3)), light)
    with open(file, "wb") as out:
        out.write(b"PF\n%d %d\n-1.0\n" % (w, h))
        out.write(np.flipud(light).astype("<f4").tobytes())


def superellipsoid(rng, u, v):
    e, f = np.exp(rng.uniform(np.log(0.3), np.log(2.5), 2))
    power = lambda c, p: np.sign(c) * np.abs(c) ** p
    t, p = 2 * np.pi * u, np.pi * v
    return power(np.sin(p), e) * power(np.cos(t), f), power(np.cos(p), e), power(np.sin(p), e) * power(np.sin(t), f)


def blob(rng, u, v):
    t, p = 2 * np.pi * u, np.pi * v
    r = np.ones_like(u)
    for _ in range(5):
        wave = np.sin(int(rng.integers(1, 9)) * t + rng.uniform(0, 6)) * np.cos(int(rng.integers(0, 8)) * p)
        r = r + rng.uniform(0.02, 0.25) * wave * np.sin(p) ** 2
    return r * np.sin(p) * np.cos(t), r * np.cos(p), r * np.sin(p) * np.sin(t)


def knot(rng, u, v):
    p, q = [(2, 5), (3, 4), (1, 3), (3, 7), (1, 0)][int(rng.integers(5))]
    t, a, radius = 2 * np.pi * u, 2 * np.pi * v, rng.uniform(0.1, 0.25)
    curve = lambda t: np.stack([(2 + np.cos(q * t)) * np.cos(p * t), np.sin(q * t), (2 + np.cos(q * t)) * np.sin(p * t)], -1) / 3
    unit = lambda w: w / np.linalg.norm(w, axis=-1, keepdims=True)
    along = unit(curve(t + 1e-3) - curve(t - 1e-3))
    side = unit(np.cross(along, np.array([0, 1, 0.1])))
    point = curve(t) + radius * (np.cos(a)[..., None] * side + np.sin(a)[..., None] * np.cross(along, side))
    return point[..., 0], point[..., 1], point[..., 2]


def lathe(rng, u, v):
    """Returns a vase; half of them are hollow, as glasses are."""
    outer = np.abs(np.cumsum(rng.normal(0, 0.25, 7)) + 0.6) + 0.1
    if rng.random() < 0.5:
        inner = np.maximum(outer - rng.uniform(0.04, 0.1), 0.02)[::-1]
        height = np.concatenate([np.linspace(-1, 1, 7), np.linspace(1, -0.9, 7)])
        radius = np.concatenate([outer, inner])
        radius[0] = radius[-1] = 0.01
    else:
        radius, height = outer, np.linspace(1, -1, 7)
        radius[0] = radius[-1] = 0.02
    knots = np.linspace(0, 1, len(radius))
    r, y = np.interp(v, knots, radius), np.interp(v, knots, height)
    return r * np.cos(2 * np.pi * u), y, r * np.sin(2 * np.pi * u)


def terrain(rng, u, v):
    heights = noise(rng, SIZE, 6, rng.uniform(0.35, 0.6), int(rng.choice([2, 4])))
    column, row = (u * (SIZE - 1)).astype(int), (v * (SIZE - 1)).astype(int)
    return 2 * u - 1, rng.uniform(0.1, 0.5) * heights[row, column], 2 * v - 1


def gear(rng, u, v):
    t = 2 * np.pi * u
    r = (1 + 0.18 * np.sign(np.sin(int(rng.integers(5, 14)) * t))) * np.where((v > 0.15) & (v < 0.85), 1, 0.01)
    return r * np.cos(t), np.where(v < 0.5, 0.35, -0.35), r * np.sin(t)


MESHES = [superellipsoid, blob, blob, knot, lathe, lathe, terrain, gear]


def mesh(rng, file, form):
    """Writes a mesh of a form that a grid of parameters describes, at most 1 in size, as an OBJ file."""
    columns, rows = [(32, 24), (64, 48), (96, 24)][int(rng.integers(3))]
    u, v = np.meshgrid(np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1))
    points = np.stack(form(rng, u, v), -1).reshape(-1, 3)
    points /= np.abs(points).max()
    step = columns + 1
    corner = (np.arange(rows)[:, None] * step + np.arange(columns)[None]).ravel()
    faces = np.concatenate([np.stack([corner, corner + 1, corner + step + 1], 1), np.stack([corner, corner + step + 1, corner + step], 1)])
    lines = ["v %.4f %.4f %.4f" % tuple(p) for p in points]
    lines += ["vt %.4f %.4f" % t for t in zip(u.ravel(), v.ravel())]
    if form is gear or rng.random() < 0.25:
        lines += ["f " + " ".join("%d/%d" % (i, i) for i in face) for face in faces + 1]
    else:
        lines += ["vn %.4f %.4f %.4f" % tuple(n) for n in smooth(points, faces, (rows + 1, columns + 1), form is not terrain)]
        lines += ["f " + " ".join("%d/%d/%d" % (i, i, i) for i in face) for face in faces + 1]
    with open(file, "w") as out:
        out.write("\n".join(lines) + "\n")


def smooth(points, faces, grid, closed):
    """Returns normals of vertices, alike at both ends of a closed grid."""
    flat = np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]])
    sums = np.zeros_like(points)
    for i in range(3):
        np.add.at(sums, faces[:, i], flat)
    seam = sums.reshape(*grid, 3)
    if closed:
        seam[:, 0] = seam[:, -1] = seam[:, 0] + seam[:, -1]
    sums[np.linalg.norm(sums, axis=1) < 1e-9] = [0, 1, 0]
    return sums / np.linalg.norm(sums, axis=1, keepdims=True)
