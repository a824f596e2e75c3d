package generator;

import static generator.PlatePaint.BAND;
import static generator.PlatePaint.BLUE;
import static generator.PlatePaint.DARK;
import static generator.PlatePaint.PLATE;
import static generator.PlatePaint.RIVET;
import static generator.Skeleton.ANKLE;
import static generator.Skeleton.ELBOW;
import static generator.Skeleton.FOREARM;
import static generator.Skeleton.KNEE;
import static generator.Skeleton.SHIN;
import static generator.Skeleton.THIGH;
import static generator.Skeleton.UPPER_ARM;
import static generator.Skeleton.WRIST;

/** The armour of the armoured figure's arms and legs. */
final class LimbArmour {
  private final Sculpture sculpture;

  private LimbArmour(Sculpture sculpture) {
    this.sculpture = sculpture;
  }

  static void addTo(Sculpture sculpture) {
    LimbArmour part = new LimbArmour(sculpture);
    part.arm();
    part.hand();
    part.leg();
    part.foot();
  }

  private void arm() {
    Vec outward = new Vec(.55, 1, 0).normalized();
    Vec top = new Vec(.208, 1.438, .008);
    Sdf dome =
        Sdf.ellipsoid(new Vec(0, 0, 0), new Vec(.103, .083, .115))
            .and(.01, Sdf.behind(new Vec(0, -.024, 0), new Vec(0, -1, 0)))
            .turned(new Vec(0, 0, 0), 2, -36);
    Sdf pauldron = (x, y, z) -> dome.at(x - top.x(), y - top.y(), z - top.z());
    Bone crown = new Bone(top.minus(outward.times(.024)), top.plus(outward.times(.1)));
    Paint cap =
        Paint.of(
            (p, n) -> crown.along(p) > .082 ? BLUE : PLATE,
            p -> Shapes.groove(crown.along(p) - .082, .0045, .0018));
    sculpture.addPair(.006, pauldron, new PlatePaint(crown, 0, .3, 26, 0, cap));
    lame(UPPER_ARM, .035, .105, .098, .092);
    lame(UPPER_ARM, .085, .15, .09, .082);
    tube(UPPER_ARM, .13, .225, .072, .062, 0, 14);
    Sdf elbow =
        Sdf.ellipsoid(ELBOW.plus(new Vec(.006, 0, .006)), new Vec(.066, .062, .068))
            .or(
                .02,
                Sdf.cone(
                    ELBOW.plus(new Vec(.035, .018, .006)),
                    ELBOW.plus(new Vec(.082, .042, .01)),
                    .05,
                    .03,
                    .008));
    Bone out = new Bone(ELBOW, ELBOW.plus(new Vec(.08, .041, .01)));
    Paint boss =
        Paint.of(
            (p, n) -> out.along(p) > .08 ? RIVET : PLATE,
            p ->
                Shapes.groove(out.along(p) - .078, .0045, .0018)
                    + Shapes.groove(out.along(p) - .045, .0045, .0018));
    sculpture.addPair(.006, elbow, boss);
    tube(FOREARM, .03, .17, .057, .047, 12, 0);
    Sdf cuff = Sdf.cone(FOREARM.point(.125), FOREARM.point(.262), .07, .043, .006);
    sculpture.addPair(
        .005,
        cuff,
        new PlatePaint(
            FOREARM,
            .125,
            .4,
            14,
            0,
            Paint.of(
                (p, n) -> Math.abs(FOREARM.along(p) - .178) < .008 ? BLUE : PLATE,
                p ->
                    Shapes.groove(Math.abs(FOREARM.along(p) - .178) - .01, .004, .0015)
                        + Shapes.groove(FOREARM.along(p) - .225, .0045, .0018))));
  }

  private void lame(Bone bone, double from, double to, double radiusFrom, double radiusTo) {
    Sdf ring = Sdf.cone(bone.point(from), bone.point(to), radiusFrom, radiusTo, .007);
    sculpture.addPair(.006, ring, new PlatePaint(bone, -1, to, 0, 16, PlatePaint.plain(PLATE)));
  }

  private void tube(
      Bone bone, double from, double to, double radiusFrom, double radiusTo, int first, int last) {
    Sdf shape = Sdf.cone(bone.point(from), bone.point(to), radiusFrom, radiusTo, .008);
    Paint seam =
        Paint.of(
            PlatePaint.plain(PLATE),
            p -> Shapes.groove((Math.abs(bone.around(p)) - 2.2) * bone.radius(p), .0045, .0018));
    sculpture.addPair(.006, shape, new PlatePaint(bone, from, to, first, last, seam));
  }

  private void hand() {
    sculpture.addPair(
        .0045,
        Skeleton.handShape(1.16),
        Paint.of(
            (p, n) -> {
              double t = beyondWrist(p);
              boolean back = n.dot(handOut()) > .05;
              return back && Shapes.toMultiple(t - .008, .022) > .0022 ? PLATE : DARK;
            },
            p -> Shapes.groove(Shapes.toMultiple(beyondWrist(p) - .008, .022), .004, .0022)));
  }

  private static Vec handOut() {
    return Skeleton.hand(0, 0, 1).minus(WRIST);
  }

  private static double beyondWrist(Vec p) {
    return p.minus(WRIST).dot(Skeleton.hand(1, 0, 0).minus(WRIST));
  }

  private void leg() {
    Sdf thigh =
        Sdf.union(
            .03,
            Sdf.cone(THIGH.point(.06), THIGH.point(.365), .103, .073, .01),
            Sdf.limb(
                THIGH.point(.12).plus(new Vec(.012, 0, -.03)),
                THIGH.point(.3).plus(new Vec(.006, 0, -.014)),
                .08,
                .06));
    sculpture.addPair(.007, thigh, new PlatePaint(THIGH, .0, .365, 0, 16, legSeams(THIGH)));
    Sdf knee =
        Sdf.union(
            .02,
            Sdf.ellipsoid(KNEE.plus(new Vec(0, .004, -.02)), new Vec(.068, .074, .072)),
            Sdf.cone(
                KNEE.plus(new Vec(.03, 0, -.004)),
                KNEE.plus(new Vec(.086, 0, -.002)),
                .058,
                .036,
                .008),
            Sdf.limb(
                KNEE.plus(new Vec(0, .045, -.078)),
                KNEE.plus(new Vec(0, -.04, -.076)),
                .012,
                .012));
    Paint cup =
        Paint.of(
            (p, n) -> p.x() > KNEE.x() + .08 ? RIVET : kneeBand(p) < .013 ? BLUE : PLATE,
            p ->
                Shapes.groove(kneeBand(p) - .015, .004, .0016)
                    + Shapes.groove(p.x() - KNEE.x() - .078, .0045, .0018)
                    + Shapes.groove(Math.abs(p.y() - KNEE.y()) - .042, .0045, .0018));
    sculpture.addPair(.006, knee, cup);
    Sdf shin =
        Sdf.union(
            .04,
            Sdf.cone(SHIN.point(.055), SHIN.point(.365), .066, .052, .01),
            Sdf.ellipsoid(SHIN.point(.135).plus(new Vec(.004, 0, .026)), new Vec(.062, .105, .058)),
            Sdf.limb(
                SHIN.point(.09).plus(new Vec(0, 0, -.048)),
                SHIN.point(.34).plus(new Vec(0, 0, -.034)),
                .018,
                .016));
    sculpture.addPair(.0065, shin, new PlatePaint(SHIN, .05, .365, 16, 14, legSeams(SHIN)));
  }

  private static double kneeBand(Vec p) {
    return p.z() < -.02 ? Math.abs(p.y() - KNEE.y()) : 1;
  }

  private static Paint legSeams(Bone bone) {
    return Paint.of(
        PlatePaint.plain(PLATE),
        p ->
            Shapes.groove((Math.abs(bone.around(p)) - 1.75) * bone.radius(p), .005, .002)
                + Shapes.groove((Math.abs(bone.around(p)) - .45) * bone.radius(p), .0045, .0014));
  }

  private void foot() {
    Sdf shape =
        Sdf.union(
                .045,
                Sdf.limb(ANKLE, ANKLE.plus(new Vec(0, -.045, .008)), .058, .056),
                Sdf.ellipsoid(new Vec(.139, .045, .055), new Vec(.05, .062, .058)),
                Sdf.limb(new Vec(.145, .06, -.02), new Vec(.158, .03, -.12), .05, .04),
                Sdf.limb(new Vec(.158, .03, -.12), new Vec(.166, .022, -.185), .036, .015))
            .and(.008, Sdf.behind(new Vec(0, 0, 0), new Vec(0, -1, 0)));
    Bone sole = Skeleton.SOLE;
    sculpture.addPair(
        .006,
        shape,
        Paint.of(
            (p, n) -> {
              if (p.y() < .016) {
                return DARK;
              }
              return p.y() > .11 ? BAND : PLATE;
            },
            p ->
                Shapes.groove(p.y() - .017, .004, .002)
                    + Shapes.groove(p.y() - .11, .005, .002)
                    + (sole.along(p) > .06 && p.y() > .02
                        ? Shapes.groove(Shapes.toMultiple(sole.along(p) - .06, .032), .005, .0024)
                        : 0)));
  }
}
