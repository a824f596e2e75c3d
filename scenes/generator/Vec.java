package generator;

/** A point or a direction in space: +x right, +y up, +z forward. */
record Vec(double x, double y, double z) {

  Vec plus(Vec o) {
    return new Vec(x + o.x, y + o.y, z + o.z);
  }

  Vec minus(Vec o) {
    return new Vec(x - o.x, y - o.y, z - o.z);
  }

  Vec times(double s) {
    return new Vec(x * s, y * s, z * s);
  }

  double dot(Vec o) {
    return x * o.x + y * o.y + z * o.z;
  }

  Vec cross(Vec o) {
    return new Vec(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
  }

  double length() {
    return Math.sqrt(dot(this));
  }

  /** The unit vector of this direction, or (0, 1, 0) for the zero vector. */
  Vec normalized() {
    double length = length();
    return length > 0 ? times(1 / length) : new Vec(0, 1, 0);
  }

  /** The point that lies the share {@code t} of the way from here to {@code o}. */
  Vec lerp(Vec o, double t) {
    return new Vec(x + (o.x - x) * t, y + (o.y - y) * t, z + (o.z - z) * t);
  }

  /** The mirror image in the plane x = 0. */
  Vec mirrored() {
    return new Vec(-x, y, z);
  }

  /** Component 0, 1 or 2. */
  double get(int axis) {
    return axis == 0 ? x : axis == 1 ? y : z;
  }
}
