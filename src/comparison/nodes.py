"""What the objects of a scene file mean, with the format's defaults."""

import math

import numpy as np

# Lumbre's space is left-handed; to the right-handed programs it is mirrored: x becomes -x.
MIRROR = np.diag([-1.0, 1.0, 1.0, 1.0])


def rotation(axis, degrees):
    """The rotation about an axis, 0 to 2, as a matrix for column vectors."""
    a, b = {0: (1, 2), 1: (2, 0), 2: (0, 1)}[axis]
    matrix = np.eye(4)
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    matrix[a, a], matrix[a, b], matrix[b, a], matrix[b, b] = c, -s, s, c
    return matrix


def vector(value, default):
    value = value or {}
    return np.array([value.get(axis, default) for axis in "xyz"], dtype=float)


def colour(value):
    if isinstance(value, (int, float)):
        return np.full(3, float(value))
    return np.array([(value or {}).get(channel, 1.0) for channel in "rgb"], dtype=float)


def scale(*sizes):
    return np.diag([*sizes, 1.0])


def halves(node, *sides):
    """Scales what reaches from -1 to 1 to the sides that a node has; without a third one, flat."""
    return scale(*[node.get(side, 1) / 2 for side in sides], *[1] * (3 - len(sides)))


def placement(node, parent):
    """The matrix of a node: parent, translation, rotation about z, then x, then y, scale."""
    move = np.eye(4)
    move[:3, 3] = vector(node.get("localPosition"), 0.0)
    turn = vector(node.get("localRotation"), 0.0)
    rotate = rotation(1, turn[1]) @ rotation(0, turn[0]) @ rotation(2, turn[2])
    return parent @ move @ rotate @ scale(*vector(node.get("localScale"), 1.0))


def placed(nodes, parent=np.eye(4)):
    """Every node of a tree with its matrix."""
    for node in nodes:
        matrix = placement(node, parent)
        yield node, matrix
        yield from placed(node.get("children", []), matrix)


# From a square in the xy plane that faces +z to one in the xz plane that faces +y.
LYING = rotation(0, -90)

# That square, and the uv of its corners when it lies: u = (w/2 - x)/w, v = (h/2 - z)/h.
SQUARE = np.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
SQUARE_UV = np.array([[1.0, 0], [0, 0], [0, 1], [1, 1]])
