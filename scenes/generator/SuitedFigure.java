package generator;

import static generator.Skeleton.ANKLE;
import static generator.Skeleton.ELBOW;
import static generator.Skeleton.FOREARM;
import static generator.Skeleton.HIP;
import static generator.Skeleton.KNEE;
import static generator.Skeleton.SHIN;
import static generator.Skeleton.SHOULDER;
import static generator.Skeleton.THIGH;
import static generator.Skeleton.UPPER_ARM;
import static generator.Skeleton.WRIST;

/** A standing figure in a close-fitting technical suit with a closed helmet. */
final class SuitedFigure {
  static final int SHELL = 0xd3d8de;
  static final int SHADE = 0x8d959f;
  static final int BLACK = 0x1a1d22;
  static final int AMBER = 0xeb9420;

  private final Sculpture sculpture = new Sculpture(.012, SuitedFigure::region);

  private SuitedFigure() {}

  static Sculpture sculpture() {
    SuitedFigure figure = new SuitedFigure();
    figure.sculpture.add(.0065, body(), new SuitPaint());
    SuitHelmet.addTo(figure.sculpture);
    figure.belt();
    figure.pack();
    figure.arm();
    figure.leg();
    return figure.sculpture;
  }

  private static int region(Vec p) {
    int side = p.x() < 0 ? 0 : 1;
    Vec q = p.x() < 0 ? p.mirrored() : p;
    if (UPPER_ARM.along(q) > .1 && q.x() > .2) {
      return 2 + side;
    }
    return q.y() < .52 ? 4 + side : q.y() < .87 ? 6 + side : q.y() < 1.13 ? 8 : 9;
  }

  private static Vec on(Bone bone, double along, double x, double z) {
    return bone.point(along).plus(new Vec(x, 0, z));
  }

  private static Sdf body() {
    Sdf leg =
        Sdf.union(
            .05,
            Sdf.limb(HIP, KNEE, .084, .053),
            Sdf.limb(KNEE, SHIN.point(.36), .053, .04),
            Sdf.limb(on(THIGH, .09, .012, -.026), on(THIGH, .30, .008, -.02), .066, .046),
            Sdf.limb(on(THIGH, .12, -.004, .03), on(THIGH, .30, 0, .018), .058, .042),
            Sdf.ellipsoid(on(SHIN, .115, .012, .024), new Vec(.045, .1, .047)),
            Sdf.ellipsoid(on(SHIN, .105, -.018, .022), new Vec(.036, .09, .044)),
            Sdf.ellipsoid(KNEE.plus(new Vec(0, .005, -.028)), new Vec(.036, .05, .034)));
    Sdf arm =
        Sdf.union(
            .035,
            Sdf.limb(SHOULDER, ELBOW, .056, .041),
            Sdf.limb(ELBOW, WRIST, .04, .028),
            Sdf.ellipsoid(SHOULDER.plus(new Vec(.016, .0, .0)), new Vec(.066, .072, .07)),
            Sdf.limb(on(UPPER_ARM, .12, 0, -.016), on(UPPER_ARM, .22, 0, -.012), .043, .034),
            Sdf.limb(on(UPPER_ARM, .10, .004, .02), on(UPPER_ARM, .22, .004, .014), .042, .034),
            Sdf.limb(on(FOREARM, .04, .004, .0), on(FOREARM, .12, .0, .0), .045, .038));
    Sdf chest =
        Sdf.union(
            .05,
            Sdf.ellipsoid(new Vec(0, 1.33, .012), new Vec(.158, .165, .108)),
            Sdf.ellipsoid(new Vec(.072, 1.365, -.055), new Vec(.082, .06, .05)),
            Sdf.ellipsoid(new Vec(.11, 1.30, .04), new Vec(.065, .13, .07)),
            Sdf.limb(new Vec(.03, 1.47, .025), new Vec(.15, 1.445, .02), .045, .045));
    Sdf waist =
        Sdf.union(
            .06,
            Sdf.ellipsoid(new Vec(0, 1.13, .008), new Vec(.128, .16, .092)),
            Sdf.ellipsoid(new Vec(0, .985, .008), new Vec(.158, .1, .105)),
            Sdf.ellipsoid(new Vec(.068, .945, .055), new Vec(.082, .085, .072)),
            Sdf.limb(new Vec(.033, 1.25, -.082), new Vec(.03, 1.06, -.078), .026, .022));
    Sdf neck = Sdf.limb(new Vec(0, 1.44, .02), new Vec(0, 1.58, .005), .06, .056);
    return Sdf.union(.05, chest, waist, neck).or(.045, leg.or(.03, arm)).onBothSides();
  }

  private void belt() {
    Vec low = new Vec(0, 1.002, .006);
    Vec high = new Vec(0, 1.048, .006);
    Sdf strap = Sdf.cone(low, high, .171, .163, .008).stretched(low, 1, 1, .74);
    sculpture.add(
        .0055,
        strap,
        Paint.of(
            (p, n) -> Math.abs(p.y() - 1.025) > .016 ? BLACK : SHADE,
            p -> Shapes.groove(Math.abs(p.y() - 1.025) - .016, .004, .0018)));
    Bone through = new Bone(new Vec(0, 1.025, 0), new Vec(0, 1.025, -.2), new Vec(0, 1, 0));
    Sdf hexagon =
        (x, y, z) -> {
          double px = Math.abs(x);
          double py = Math.abs(y - 1.025);
          double flat = Math.max(py, px * .8660254 + py * .5) - .037;
          return Math.max(flat, Math.abs(z + .122) - .018) * .95;
        };
    sculpture.add(
        .0045,
        hexagon.grown(.002),
        Paint.of(
            (p, n) -> {
              double r = through.radius(p);
              return r < .014 ? AMBER : r < .022 ? BLACK : SHELL;
            },
            p -> Shapes.groove(through.radius(p) - .018, .006, .003)));
    for (double angle : new double[] {48, 78, 108, 138}) {
      double a = StrictMath.toRadians(angle);
      double x = .166 * StrictMath.sin(a);
      double z = .006 - .74 * .166 * StrictMath.cos(a);
      Vec foot = new Vec(x, .99, z);
      Vec top = new Vec(x, 1.058, z);
      Sdf can = Sdf.cone(foot, top, .019, .019, .006);
      Paint paint =
          Paint.of(
              (p, n) -> p.y() > 1.043 ? AMBER : p.y() < 1.0 ? SHADE : SHELL,
              p -> Shapes.groove(p.y() - 1.043, .004, .002));
      sculpture.addPair(.005, can, paint);
    }
  }

  private void pack() {
    Sdf box =
        Sdf.box(new Vec(0, 1.335, .137), new Vec(.082, .115, .036), .022)
            .or(.02, Sdf.box(new Vec(0, 1.335, .165), new Vec(.03, .085, .026), .014));
    Paint casing =
        Paint.of(
            (p, n) -> {
              if (p.z() > .168 && Math.abs(p.x()) < .017) {
                return Shapes.toMultiple(p.y() - 1.335, .022) < .0055 ? BLACK : AMBER;
              }
              return Math.abs(p.y() - 1.335) < .07 ? SHELL : SHADE;
            },
            p ->
                Shapes.groove(Math.abs(p.y() - 1.335) - .07, .0045, .0022)
                    + Shapes.groove(Math.abs(p.x()) - .05, .0045, .0018));
    sculpture.add(.006, box, casing);
    Sdf tank = Sdf.limb(new Vec(.095, 1.245, .128), new Vec(.095, 1.41, .128), .026, .026);
    sculpture.addPair(
        .006,
        tank,
        Paint.of(
            (p, n) -> p.y() > 1.41 || p.y() < 1.245 ? SHADE : BLACK,
            p -> Shapes.groove(Math.abs(p.y() - 1.3275) - .0825, .0045, .002)));
  }

  private void arm() {
    Sdf pad =
        Sdf.ellipsoid(SHOULDER.plus(new Vec(.022, .012, -.0)), new Vec(.073, .076, .079))
            .and(.01, Sdf.behind(SHOULDER.plus(new Vec(.012, 0, 0)), new Vec(-1, -.55, 0)))
            .and(.008, Sdf.behind(UPPER_ARM.point(.045), UPPER_ARM.axis));
    sculpture.addPair(
        .0055,
        pad,
        Paint.of(
            (p, n) -> {
              double t = UPPER_ARM.along(p);
              return t > .022 ? SHADE : Math.abs(t + .005) < .011 ? AMBER : SHELL;
            },
            p ->
                Shapes.groove(UPPER_ARM.along(p) - .022, .0045, .002)
                    + Shapes.groove(Math.abs(UPPER_ARM.along(p) + .005) - .013, .004, .0016)));
    Sdf cuff = Sdf.cone(FOREARM.point(.145), FOREARM.point(.262), .047, .037, .008);
    sculpture.addPair(
        .0055,
        cuff,
        Paint.of(
            (p, n) -> {
              double t = FOREARM.along(p);
              boolean screen = Math.abs(t - .2) < .03 && Math.abs(FOREARM.around(p) - 1.2) < .55;
              boolean glow = Math.abs(t - .2) < .022 && Math.abs(FOREARM.around(p) - 1.2) < .4;
              return glow ? AMBER : screen ? BLACK : t < .16 || t > .247 ? SHADE : SHELL;
            },
            p ->
                Shapes.groove(FOREARM.along(p) - .16, .0045, .002)
                    + Shapes.groove(FOREARM.along(p) - .247, .0045, .002)));
    Vec back = Skeleton.hand(0, 0, 1).minus(WRIST);
    sculpture.addPair(
        .0045,
        Skeleton.handShape(1.06),
        Paint.of(
            (p, n) -> {
              double t = beyondWrist(p);
              return n.dot(back) > .3 && Math.abs(t - .086) < .012
                  ? SHELL
                  : n.dot(back) > .2 && Math.abs(t - .05) < .004 ? AMBER : BLACK;
            },
            p -> Shapes.groove(Shapes.toMultiple(beyondWrist(p) - .1, .026), .004, .0018)));
  }

  private static double beyondWrist(Vec p) {
    return p.minus(WRIST).dot(Skeleton.hand(1, 0, 0).minus(WRIST));
  }

  private void leg() {
    Sdf kneePad =
        Sdf.ellipsoid(KNEE.plus(new Vec(.002, .004, -.036)), new Vec(.05, .068, .044))
            .and(.008, Sdf.behind(KNEE.plus(new Vec(0, 0, -.018)), new Vec(0, 0, 1)));
    Paint cap =
        Paint.of(
            (p, n) -> kneeRing(p) < .5 ? AMBER : kneeRing(p) < .8 ? SHELL : SHADE,
            p ->
                Shapes.groove((kneeRing(p) - .5) * .05, .004, .002)
                    + Shapes.groove((kneeRing(p) - .8) * .05, .004, .002));
    sculpture.addPair(.0055, kneePad, cap);
    Sdf shaft = Sdf.cone(SHIN.point(.215), SHIN.point(.39), .06, .05, .01);
    Sdf foot =
        Sdf.union(
                .04,
                Sdf.limb(ANKLE, ANKLE.plus(new Vec(0, -.04, .005)), .05, .05),
                Sdf.ellipsoid(new Vec(.14, .045, .055), new Vec(.047, .062, .055)),
                Sdf.limb(new Vec(.146, .055, -.02), new Vec(.158, .034, -.125), .046, .042))
            .and(.006, Sdf.behind(new Vec(0, .012, 0), new Vec(0, -1, 0)));
    Paint leather =
        Paint.of(
            (p, n) -> {
              if (p.y() > .243) {
                return AMBER;
              }
              boolean toe = p.z() < -.095 || p.z() > .09 && p.y() < .08;
              return toe || p.y() < .034 ? SHADE : BLACK;
            },
            p ->
                Shapes.groove(p.y() - .243, .0045, .002)
                    + Shapes.groove(p.y() - .034, .0045, .002)
                    + (p.y() > .06
                        ? Shapes.groove(Shapes.toMultiple(p.y() - .1, .036), .0045, .0018)
                        : 0)
                    + (p.y() < .09 ? Shapes.groove(p.z() + .095, .0045, .002) : 0));
    sculpture.addPair(.006, shaft.or(.03, foot), leather);
    Sdf outline = foot.grown(.006);
    Sdf prism = (x, y, z) -> outline.at(x, .02, z);
    sculpture.addPair(
        .0055,
        prism.and(.004, Sdf.box(new Vec(.15, .013, 0), new Vec(.2, .013, .4), .003)),
        Paint.of(
            PlatePaint.plain(SHADE),
            p -> Shapes.groove(Shapes.toMultiple(p.z(), .024), .006, .003)));
  }

  private static double kneeRing(Vec p) {
    return StrictMath.hypot((p.x() - KNEE.x()) / .05, (p.y() - KNEE.y() - .004) / .066);
  }
}
