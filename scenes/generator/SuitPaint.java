package generator;

import static generator.Skeleton.FOREARM;
import static generator.Skeleton.SHIN;
import static generator.Skeleton.THIGH;
import static generator.Skeleton.UPPER_ARM;

/** The cloth of the technical suit: hexagons, seams, stripes along the limbs, panels. */
final class SuitPaint implements Paint {
  private static final int CLOTH = 0x31506b;
  private static final int DARK = 0x1e2a38;
  private static final int PANEL = 0x1b7f86;
  private static final double CELL = .0165;

  private static final Bone SPINE = new Bone(new Vec(0, .9, .01), new Vec(0, 1.5, .01));
  private static final double TRUNK_RADIUS = .14;

  /** The limb or the trunk that a point belongs to, and its cylindrical coordinates there. */
  private record Place(Bone bone, double along, double angle, double radius) {
    static Place of(Vec p) {
      Vec q = p.x() < 0 ? p.mirrored() : p;
      boolean nearArm = Math.min(UPPER_ARM.radius(q), FOREARM.radius(q)) < .1;
      if (nearArm && UPPER_ARM.along(q) > .02 && q.x() > .19) {
        return FOREARM.along(q) > -.02 ? on(FOREARM, q, .042) : on(UPPER_ARM, q, .05);
      }
      if (q.y() < .88) {
        return SHIN.along(q) > 0 ? on(SHIN, q, .05) : on(THIGH, q, .07);
      }
      return on(SPINE, q, TRUNK_RADIUS);
    }

    private static Place on(Bone bone, Vec q, double radius) {
      return new Place(bone, bone.along(q), bone.around(q), radius);
    }

    /** The distance around the limb from the angle given. */
    double from(double degrees) {
      return Math.abs(angle - StrictMath.toRadians(degrees)) * radius;
    }
  }

  @Override
  public int colour(Vec p, Vec n) {
    Place place = Place.of(p);
    double x = Math.abs(p.x());
    if (place.bone == SPINE) {
      return trunk(p, x);
    }
    double stripe = place.from(90);
    if (stripe < .011) {
      return SuitedFigure.AMBER;
    }
    if (stripe < .02) {
      return DARK;
    }
    boolean leg = place.bone == THIGH || place.bone == SHIN;
    if (leg && (place.angle < -.9 || place.angle > 2.5)) {
      return DARK;
    }
    if (place.bone == FOREARM && place.along > .09) {
      return PANEL;
    }
    return leg || place.bone == FOREARM ? CLOTH : place.along > .16 ? DARK : CLOTH;
  }

  private static int trunk(Vec p, double x) {
    boolean front = p.z() < .01;
    double yoke = p.y() - 1.335 - .35 * x;
    if (front && Math.abs(yoke) < .008 && x < .15) {
      return SuitedFigure.AMBER;
    }
    if (yoke > 0 && x < .17) {
      return front && x < .012 ? DARK : PANEL;
    }
    double flank = x - .085 - .25 * Math.max(0, p.y() - 1.2);
    if (Math.abs(flank) < .006 && p.y() > 1.04) {
      return SuitedFigure.SHELL;
    }
    return flank > 0 || p.y() < 1.0 && x < .05 ? DARK : CLOTH;
  }

  @Override
  public double height(Vec p) {
    Place place = Place.of(p);
    double count = Math.rint(2 * Math.PI * place.radius / CELL);
    double u = place.angle / (2 * Math.PI) * count;
    double edge = Shapes.honeycomb(u, place.along / CELL) * CELL;
    return -.0014 * (1 - Shapes.step(0, .0042, edge)) + seams(p, place);
  }

  private static double seams(Vec p, Place place) {
    double x = Math.abs(p.x());
    if (place.bone != SPINE) {
      return Shapes.groove(place.from(90) - .02, .0045, .0022)
          + Shapes.groove(place.from(90) - .011, .004, .0012);
    }
    double yoke = p.y() - 1.335 - .35 * x;
    double flank = x - .085 - .25 * Math.max(0, p.y() - 1.2);
    double front = p.z() < .01 ? Shapes.groove(Math.abs(yoke) - .009, .0045, .0022) : 0;
    double side =
        yoke < 0 && p.y() > 1.04 ? Shapes.groove(Math.abs(flank) - .007, .0045, .0022) : 0;
    double middle = p.z() < .01 && yoke < 0 ? Shapes.groove(p.x(), .0045, .0022) : 0;
    return front + side + middle;
  }
}
