package generator;

import static generator.PlatePaint.BAND;
import static generator.PlatePaint.BLUE;
import static generator.PlatePaint.DARK;
import static generator.PlatePaint.PLATE;
import static generator.PlatePaint.RED;
import static generator.PlatePaint.RIVET;
import static generator.Skeleton.ANKLE;
import static generator.Skeleton.ELBOW;
import static generator.Skeleton.FOREARM;
import static generator.Skeleton.HIP;
import static generator.Skeleton.KNEE;
import static generator.Skeleton.SHIN;
import static generator.Skeleton.SHOULDER;
import static generator.Skeleton.THIGH;
import static generator.Skeleton.TRUNK;
import static generator.Skeleton.UPPER_ARM;
import static generator.Skeleton.WRIST;

/** A standing figure in plate armour with a closed helmet. */
final class ArmouredFigure {
  private static final Vec TASSET_TIP = new Vec(.118, .752, 0);
  private static final Vec LOWER_OUTER = new Vec(.4, -1, 0).normalized();
  private static final Vec LOWER_INNER = new Vec(-.45, -1, 0).normalized();

  private final Sculpture sculpture = new Sculpture(.012, p -> 0);

  private ArmouredFigure() {}

  static Sculpture sculpture() {
    ArmouredFigure figure = new ArmouredFigure();
    figure.padding();
    KnightHelmet.addTo(figure.sculpture);
    figure.cuirass();
    figure.skirt();
    LimbArmour.addTo(figure.sculpture);
    return figure.sculpture;
  }

  /** The dark quilted clothes that show between the plates. */
  private void padding() {
    Sdf limbs =
        Sdf.union(
            .02,
            Sdf.limb(HIP, KNEE, .083, .056),
            Sdf.limb(KNEE, ANKLE, .056, .042),
            Sdf.limb(SHOULDER, ELBOW, .062, .043),
            Sdf.limb(ELBOW, WRIST, .043, .03));
    Sdf trunk =
        Sdf.union(
            .05,
            Sdf.ellipsoid(new Vec(0, .99, .005), new Vec(.165, .12, .115)),
            Sdf.ellipsoid(new Vec(0, 1.32, .01), new Vec(.18, .19, .115)),
            Sdf.limb(new Vec(0, 1.42, .015), new Vec(0, 1.6, .005), .07, .06));
    Paint ribs =
        Paint.of(
            PlatePaint.plain(DARK),
            p -> .0013 * StrictMath.cos(2 * Math.PI * nearestLimb(p) / .017));
    sculpture.add(.008, limbs.onBothSides().or(.03, trunk), ribs);
  }

  private static double nearestLimb(Vec p) {
    Vec q = new Vec(Math.abs(p.x()), p.y(), p.z());
    double best = Math.abs(q.x()) < .16 && q.y() > .9 ? .16 : 1;
    double along = q.y();
    for (Bone bone : new Bone[] {THIGH, SHIN, UPPER_ARM, FOREARM}) {
      double t = bone.along(q);
      double outside = Math.max(0, Math.max(-t, t - bone.b.minus(bone.a).length()));
      double distance = bone.radius(q) + outside;
      if (distance < best) {
        best = distance;
        along = t;
      }
    }
    return along;
  }

  private void cuirass() {
    Sdf chest =
        Sdf.union(
            .09,
            Sdf.ellipsoid(new Vec(0, 1.335, .008), new Vec(.195, .175, .135)),
            Sdf.ellipsoid(new Vec(.085, 1.365, -.062), new Vec(.092, .085, .07)),
            Sdf.ellipsoid(new Vec(.085, 1.38, .075), new Vec(.095, .09, .06)),
            Sdf.limb(new Vec(0, 1.44, -.07), new Vec(0, 1.15, -.105), .045, .024),
            Sdf.cone(new Vec(0, 1.06, 0), new Vec(0, 1.25, 0), .143, .16, .02)
                .stretched(new Vec(0, 0, 0), 1, 1, .82));
    Sdf armHole = Sdf.limb(new Vec(.235, 1.36, .012), new Vec(.33, 1.36, .012), .075, .11);
    Sdf plate =
        chest
            .onBothSides()
            .without(.02, armHole.onBothSides())
            .and(.01, Sdf.behind(new Vec(0, 1.463, 0), new Vec(0, 1, 0)))
            .without(.008, Sdf.cone(new Vec(0, 1.43, .01), new Vec(0, 1.56, .01), .118, .16, .005))
            .and(.01, Sdf.behind(new Vec(0, 1.125, 0), new Vec(0, -1, 0)));
    sculpture.add(.007, plate, chestPaint());
  }

  private static Paint chestPaint() {
    Paint colour =
        (p, n) -> {
          double chevron = p.y() - 1.315 + .55 * Math.abs(p.x());
          boolean front = p.z() < -.03;
          if (front && chevron > -.018 && chevron < .018 && Math.abs(p.x()) < .125) {
            return BLUE;
          }
          if (front && chevron > -.042 && chevron < -.027 && Math.abs(p.x()) < .125) {
            return RED;
          }
          if (!front && p.z() > .06 && Math.abs(p.x()) < .012 && p.y() > 1.16 && p.y() < 1.44) {
            return BLUE;
          }
          return Math.abs(p.z() - .012) < .006 ? BAND : PLATE;
        };
    return new PlatePaint(
        TRUNK,
        .225,
        .80,
        34,
        0,
        Paint.of(
            colour,
            p -> {
              double chevron = p.y() - 1.315 + .55 * Math.abs(p.x());
              boolean front = p.z() < -.03;
              double mark =
                  front && Math.abs(p.x()) < .13
                      ? Shapes.groove(chevron - .02, .0045, .0016)
                          + Shapes.groove(chevron + .0225, .0045, .0016)
                      : 0;
              double ribs =
                  p.y() < 1.26 && p.y() > 1.15 && Math.abs(p.x()) > .04
                      ? Shapes.groove(Shapes.toMultiple(p.y() - 1.165, .03), .005, .0018)
                      : 0;
              double side =
                  Shapes.groove(p.z() - .004, .0045, .002)
                      + Shapes.groove(p.z() - .020, .0045, .002);
              double blades = p.z() > .05 ? Shapes.groove(Math.abs(p.x()) - .055, .005, .0018) : 0;
              return mark + ribs + side + blades;
            }));
  }

  private void skirt() {
    for (int i = 0; i < 4; i++) {
      Vec top = new Vec(0, 1.135 - .045 * i, .004);
      Vec bottom = new Vec(0, 1.068 - .045 * i, .004);
      Sdf lame =
          Sdf.cone(bottom, top, .176 + .011 * i, .148 + .012 * i, .006).stretched(top, 1, 1, .80);
      Bone up = new Bone(bottom, top);
      sculpture.add(.007, lame, new PlatePaint(up, 0, .3, 30, 0, PlatePaint.plain(PLATE)));
    }
    Vec low = new Vec(0, 1.103, .004);
    Vec high = new Vec(0, 1.15, .004);
    Sdf belt = Sdf.cone(low, high, .17, .165, .008).stretched(low, 1, 1, .82);
    Paint leather =
        Paint.of(
            (p, n) -> Math.abs(p.y() - 1.1265) > .017 ? 0x3d2a1d : 0x59402c,
            p -> Shapes.knob(new Bone(low, high).toRing(p, .0235, 26), .006, .0025));
    sculpture.add(.006, belt, leather);
    Sdf buckle =
        Sdf.box(new Vec(0, 1.1265, -.134), new Vec(.037, .03, .018), .006)
            .without(.004, Sdf.box(new Vec(0, 1.1265, -.155), new Vec(.024, .017, .01), .003));
    sculpture.add(
        .005, buckle, (p, n) -> p.z() > -.149 && Math.abs(p.x()) < .028 ? 0x4d3a1c : RIVET);
    Sdf pouch = Sdf.box(new Vec(.168, 1.075, .035), new Vec(.03, .046, .045), .012);
    sculpture.addPair(
        .006,
        pouch.turned(new Vec(.168, 1.08, .035), 2, 8),
        Paint.of(
            (p, n) -> p.y() > 1.078 ? 0x59402c : 0x6c5138,
            p -> Shapes.groove(p.y() - 1.078, .005, .003)));
    Bone bone = new Bone(new Vec(.09, 1.0, -.02), new Vec(.122, .70, -.02));
    Sdf tasset =
        Sdf.cone(bone.a, bone.b, .118, .106, .01)
            .and(.012, Sdf.behind(new Vec(0, 0, -.045), new Vec(-.1, 0, 1)))
            .and(.008, Sdf.behind(TASSET_TIP, LOWER_OUTER))
            .and(.008, Sdf.behind(TASSET_TIP, LOWER_INNER))
            .and(.01, Sdf.behind(new Vec(.014, .99, 0), new Vec(-1, -.06, 0)));
    sculpture.addPair(
        .007,
        tasset,
        new PlatePaint(
            bone,
            -.1,
            .8,
            0,
            0,
            Paint.of(
                (p, n) -> Math.abs(edgeOfTasset(p)) < .011 ? BAND : diamond(p) < .02 ? RED : PLATE,
                p ->
                    Shapes.groove(edgeOfTasset(p) - .011, .004, .0016)
                        + Shapes.groove(diamond(p) - .024, .004, .0016)
                        + Shapes.groove(Shapes.toMultiple(p.y() - .925, .055), .0045, .0016))));
  }

  private static double edgeOfTasset(Vec p) {
    Vec up = TASSET_TIP.minus(p);
    return Math.min(up.dot(LOWER_OUTER), up.dot(LOWER_INNER));
  }

  private static double diamond(Vec p) {
    return p.z() < -.1 ? (Math.abs(p.x() - .105) * 1.6 + Math.abs(p.y() - .843)) / 1.4 : 1;
  }
}
