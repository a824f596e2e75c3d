package generator;

import java.util.ArrayList;
import java.util.List;

/** A frog that sits with its head up. */
final class Frog {
  private static final Vec EYE = new Vec(.098, .532, -.118);
  private static final Vec GAZE = new Vec(.80, .22, -.56).normalized();
  private static final int GREEN = 0x4fa332;
  private static final int DARK_GREEN = 0x2c6b22;
  private static final int SPOT = 0x24471a;
  private static final int BELLY = 0xe9e4b6;
  private static final int GOLD = 0xe0a21c;

  private Frog() {}

  static Sculpture sculpture() {
    Sculpture frog = new Sculpture(.008, Frog::region);
    frog.add(.0044, skin(), new Skin());
    Sdf eye = Sdf.sphere(EYE, .044);
    frog.addPair(.004, eye, Frog::eye);
    return frog;
  }

  private static int region(Vec p) {
    if (Math.abs(p.x()) < .17 && p.y() > .17) {
      return p.y() > .42 ? 1 : 0;
    }
    return (p.x() < 0 ? 2 : 3) + (p.z() < 0 ? 2 : 0) + (p.y() < .06 ? 4 : 0);
  }

  private static Sdf skin() {
    Sdf trunk =
        Sdf.union(
            .07,
            Sdf.limb(new Vec(0, .15, .20), new Vec(0, .32, .03), .105, .135),
            Sdf.ellipsoid(new Vec(0, .25, .10), new Vec(.165, .14, .15)),
            Sdf.ellipsoid(new Vec(0, .35, -.06), new Vec(.135, .115, .11)),
            Sdf.limb(new Vec(0, .09, .29), new Vec(0, .16, .2), .04, .1));
    Sdf head =
        Sdf.union(
            .05,
            Sdf.ellipsoid(new Vec(0, 0, 0), new Vec(.152, .074, .15)),
            Sdf.ellipsoid(new Vec(0, -.004, -.115), new Vec(.085, .052, .075)),
            Sdf.ellipsoid(new Vec(0, -.045, .02), new Vec(.13, .06, .125)));
    Sdf tilted = head.turned(new Vec(0, 0, 0), 0, 12);
    Sdf placed = (x, y, z) -> tilted.at(x, y - .455, z + .135);
    Sdf brows = Sdf.sphere(EYE.plus(new Vec(-.012, -.006, .008)), .047).onBothSides();
    Sdf ridge =
        Sdf.union(
            .01,
            Sdf.limb(new Vec(.10, .50, -.05), new Vec(.125, .38, .08), .012, .014),
            Sdf.limb(new Vec(.125, .38, .08), new Vec(.10, .25, .22), .014, .01));
    Sdf body = trunk.or(.08, placed).or(.03, brows).or(.03, ridge.onBothSides());
    Sdf limbs = foreleg().or(.0, hindleg()).onBothSides();
    Sdf whole = body.or(.035, limbs);
    Sdf sockets = Sdf.sphere(EYE.plus(GAZE.times(.03)), .034).onBothSides();
    Sdf carved = whole.without(.012, sockets);
    return (x, y, z) -> carved.at(x, y, z) + .009 * lips(x, y, z);
  }

  /** How deep the mouth's crease is at a place: 1 in its middle, 0 away from it. */
  private static double lips(double x, double y, double z) {
    double line = Math.abs(y - mouthHeight(x, z));
    double q = line / .009;
    double fade = 1 - Shapes.step(-.09, -.05, z);
    return q >= 1 ? 0 : (1 - q * q) * (1 - q * q) * fade;
  }

  private static double mouthHeight(double x, double z) {
    return .447 - .26 * (z + .135) - .35 * x * x;
  }

  private static Sdf toe(Vec from, Vec to, double thick) {
    Vec knuckle = from.lerp(to, .55).plus(new Vec(0, .012, 0));
    Sdf pad = Sdf.ellipsoid(to, new Vec(.021, .012, .021));
    return Sdf.union(
        .008,
        Sdf.limb(from, knuckle, thick, thick * .8),
        Sdf.limb(knuckle, to, thick * .8, .009),
        pad);
  }

  private static Sdf foreleg() {
    Vec shoulder = new Vec(.115, .315, -.05);
    Vec elbow = new Vec(.205, .185, .0);
    Vec wrist = new Vec(.165, .045, -.12);
    List<Sdf> parts = new ArrayList<>();
    parts.add(Sdf.limb(shoulder, elbow, .054, .036));
    parts.add(Sdf.limb(elbow, wrist, .039, .026));
    parts.add(Sdf.limb(wrist, new Vec(.165, .026, -.155), .027, .022));
    double[] angles = {-48, -12, 24, 62};
    double[] lengths = {.085, .105, .105, .09};
    for (int i = 0; i < 4; i++) {
      parts.add(toe(new Vec(.165, .024, -.15), spread(.165, -.15, angles[i], lengths[i]), .0135));
    }
    return Sdf.union(.014, parts.toArray(new Sdf[0]));
  }

  /** A point on the ground so far away, at an angle from the front towards +x. */
  private static Vec spread(double x, double z, double degrees, double length) {
    double a = StrictMath.toRadians(degrees);
    return new Vec(x + length * StrictMath.sin(a), .0135, z - length * StrictMath.cos(a));
  }

  private static Sdf hindleg() {
    Vec hip = new Vec(.085, .14, .235);
    Vec knee = new Vec(.255, .225, .055);
    Vec heel = new Vec(.215, .055, .265);
    Vec sole = new Vec(.27, .026, .075);
    List<Sdf> parts = new ArrayList<>();
    parts.add(Sdf.limb(hip, knee, .078, .047));
    parts.add(Sdf.ellipsoid(hip.lerp(knee, .45), new Vec(.07, .068, .08)));
    parts.add(Sdf.limb(knee, heel, .046, .030));
    parts.add(Sdf.limb(heel, sole, .030, .023));
    double[] angles = {-30, -8, 14, 38, 66};
    double[] lengths = {.08, .11, .135, .125, .10};
    for (int i = 0; i < 5; i++) {
      parts.add(toe(sole, spread(.27, .075, angles[i], lengths[i]), .0145));
    }
    return Sdf.union(.016, parts.toArray(new Sdf[0]));
  }

  private static int eye(Vec p, Vec n) {
    Vec up = new Vec(0, 1, 0).minus(GAZE.times(GAZE.y())).normalized();
    Vec side = GAZE.cross(up);
    double a = n.dot(side);
    double b = n.dot(up);
    if (n.dot(GAZE) < .45) {
      return b > 0 ? GREEN : DARK_GREEN;
    }
    double pupil = StrictMath.hypot(a / .46, b / .24);
    double glint = StrictMath.hypot(a + .25, b - .34);
    if (glint < .1) {
      return 0xffffff;
    }
    return pupil < 1 ? 0x0a0a08 : n.dot(GAZE) < .58 ? 0x2a2008 : pupil < 1.25 ? 0xf5cf5e : GOLD;
  }

  /** Green above, pale below, with dark spots, and warts on the back. */
  private static final class Skin implements Paint {
    @Override
    public int colour(Vec p, Vec n) {
      double x = Math.abs(p.x());
      if (lips(p.x(), p.y(), p.z()) > .35) {
        return 0x3a2a1c;
      }
      Vec nostril = new Vec(.034, .522, -.305);
      if (new Vec(x, p.y(), p.z()).minus(nostril).length() < .011) {
        return SPOT;
      }
      double drum = new Vec(x, p.y(), p.z()).minus(new Vec(.142, .462, -.052)).length();
      if (drum < .026) {
        return drum < .017 ? 0x8a6a35 : SPOT;
      }
      double pale = belly(p, n);
      if (pale > .5) {
        return BELLY;
      }
      if (pale > .35) {
        return 0x9fbf5a;
      }
      return p.y() > .03 && spot(p) < 1 ? SPOT : bars(p) ? DARK_GREEN : GREEN;
    }

    private static double belly(Vec p, Vec n) {
      boolean trunk = Math.abs(p.x()) < .16;
      double under = -.75 * n.y() - .55 * n.z() * (trunk ? 1 : .2);
      double below = p.y() < mouthHeight(p.x(), p.z()) ? .15 : -1;
      double wobble = .12 * (Shapes.noise(p.x() * 25, p.y() * 25, p.z() * 25) - .5);
      return (trunk ? under + below : under - .35) + wobble;
    }

    /** Whether a place lies in one of the bars across the hind legs. */
    private static boolean bars(Vec p) {
      double wobble = .014 * Shapes.noise(p.x() * 30, p.y() * 30, p.z() * 30);
      return Math.abs(p.x()) > .165 && Shapes.toMultiple(p.z() + wobble, .06) < .011 && p.y() > .03;
    }

    /** The distance from the nearest spot's middle, in its radii. */
    private static double spot(Vec p) {
      double size = .072;
      int cx = (int) Math.floor(p.x() / size);
      int cy = (int) Math.floor(p.y() / size);
      int cz = (int) Math.floor(p.z() / size);
      double best = 9;
      for (int i = 0; i < 27; i++) {
        int x = cx + i % 3 - 1;
        int y = cy + i / 3 % 3 - 1;
        int z = cz + i / 9 - 1;
        int h = Shapes.hash(x, y, z);
        Vec middle =
            new Vec(
                (x + .2 + .6 * (h & 255) / 255) * size,
                (y + .2 + .6 * (h >> 8 & 255) / 255) * size,
                (z + .2 + .6 * (h >> 16 & 255) / 255) * size);
        double radius = .011 + .017 * (h >> 24 & 127) / 127;
        double wobble = .25 * Shapes.noise(p.x() * 60, p.y() * 60, p.z() * 60);
        best = Math.min(best, p.minus(middle).length() / radius + wobble);
      }
      return best;
    }

    @Override
    public double height(Vec p) {
      double fine = Shapes.noise(p.x() * 130, p.y() * 130, p.z() * 130);
      double wart = Shapes.step(.62, .8, Shapes.noise(p.x() * 60 + 9, p.y() * 60, p.z() * 60));
      boolean throat = p.z() < .02 && p.y() < mouthHeight(p.x(), p.z());
      double above = throat ? 0 : p.y() > .2 ? 1 : .3;
      return .0009 * fine + .0022 * wart * above;
    }
  }
}
