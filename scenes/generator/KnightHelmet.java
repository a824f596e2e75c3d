package generator;

import static generator.PlatePaint.BAND;
import static generator.PlatePaint.BLUE;
import static generator.PlatePaint.PLATE;
import static generator.PlatePaint.RIVET;
import static generator.Skeleton.HEAD;

/** The closed helmet of the armoured figure and the collar that it stands on. */
final class KnightHelmet {
  private final Sculpture sculpture;

  private KnightHelmet(Sculpture sculpture) {
    this.sculpture = sculpture;
  }

  static void addTo(Sculpture sculpture) {
    KnightHelmet part = new KnightHelmet(sculpture);
    part.helmet();
  }

  private void helmet() {
    Sdf dome = Sdf.ellipsoid(HEAD.plus(new Vec(0, .008, .004)), new Vec(.113, .138, .14));
    Sdf jaw =
        Sdf.cone(new Vec(0, 1.515, -.004), new Vec(0, 1.68, 0), .087, .113, .02)
            .stretched(HEAD, 1, 1, 1.2);
    Sdf shell = dome.or(.02, jaw);
    sculpture.add(.006, shell, helmetPaint());
    sculpture.add(.005, visor(shell), visorPaint());
    Sdf comb =
        Sdf.ellipsoid(HEAD.plus(new Vec(0, .012, .008)), new Vec(.2, .168, .166))
            .and(.008, Sdf.box(new Vec(0, 1.76, .06), new Vec(.0115, .115, .17), .004));
    sculpture.add(.005, comb.without(.0, dome.grown(-.015)), PlatePaint.plain(BLUE));
    Sdf pivot = Sdf.cone(new Vec(.10, 1.682, .012), new Vec(.132, 1.682, .012), .027, .021, .004);
    Paint dial = Paint.of(PlatePaint.plain(RIVET), p -> -.002 * Math.rint(pivotRadius(p) / .024));
    sculpture.addPair(.005, pivot, dial);
    Sdf gorget =
        Sdf.union(
            .006,
            Sdf.cone(new Vec(0, 1.455, .012), new Vec(0, 1.55, .004), .115, .082, .008),
            Sdf.torus(new Vec(0, 1.547, .004), new Vec(0, 1, 0), .078, .0085),
            Sdf.cone(new Vec(0, 1.43, .012), new Vec(0, 1.488, .01), .106, .098, .004));
    Bone neck = new Bone(new Vec(0, 1.44, .012), new Vec(0, 1.55, .006));
    sculpture.add(.006, gorget, new PlatePaint(neck, .04, .098, 20, 0, PlatePaint.plain(PLATE)));
  }

  private static double pivotRadius(Vec p) {
    return StrictMath.hypot(p.y() - 1.682, p.z() - .012);
  }

  /** The face plate: pointed in the middle, with a slit to see through. */
  private static Sdf visor(Sdf shell) {
    Sdf keel =
        Sdf.limb(new Vec(0, 1.70, -.118), new Vec(0, 1.615, -.163), .02, .014)
            .or(.02, Sdf.limb(new Vec(0, 1.615, -.163), new Vec(0, 1.545, -.105), .014, .02));
    Sdf plate =
        shell
            .grown(.009)
            .or(.075, keel)
            .and(.006, Sdf.behind(new Vec(0, 1.735, -.12), new Vec(0, 1, .42)))
            .and(.006, Sdf.behind(new Vec(0, 1.548, 0), new Vec(0, -1, .12)));
    Sdf back = Sdf.behind(new Vec(0, 1.66, .022), new Vec(0, -.35, 1));
    Sdf slit = Sdf.box(new Vec(0, 1.683, -.15), new Vec(.094, .0105, .085), .004);
    return plate.and(.006, back).without(.004, slit);
  }

  private static Paint helmetPaint() {
    Paint colour =
        (p, n) -> {
          boolean slit = Math.abs(p.y() - 1.683) < .03 && p.z() < -.055;
          return slit ? 0x050506 : p.y() < 1.535 ? BAND : PLATE;
        };
    return Paint.of(
        colour,
        p ->
            Shapes.groove(p.y() - 1.535, .005, .002)
                + Shapes.groove(p.z() - .075, .005, .002)
                + Shapes.knob(new Bone(new Vec(0, 1.5, 0), HEAD).toRing(p, .02, 18), .006, .003));
  }

  private static Paint visorPaint() {
    Paint colour =
        (p, n) -> {
          if (toBreath(p) < .0062 || Math.abs(p.y() - 1.683) < .0085 && n.z() > -.3) {
            return 0x0b0b0d;
          }
          if (Math.abs(p.y() - 1.683) < .0175 && Math.abs(p.x()) < .099 && p.z() < -.055) {
            return BAND;
          }
          boolean stripe = p.y() > 1.701 && Math.abs(p.x()) < .016;
          return stripe ? BLUE : PLATE;
        };
    return Paint.of(
        colour,
        p ->
            Shapes.groove(toBreath(p), .0075, .004)
                + Shapes.groove(Math.abs(p.y() - 1.683) - .0175, .004, .0015)
                + Shapes.groove(Math.abs(p.x()) - .019, p.y() > 1.701 ? .004 : 1e-9, .0014));
  }

  /** The distance from the nearest of the holes in the lower half of the visor. */
  private static double toBreath(Vec p) {
    double best = 1;
    for (int row = 0; row < 3; row++) {
      for (int i = 0; i < 4 - row % 2; i++) {
        double x = .032 + .017 * i + .0085 * (row % 2);
        double y = 1.640 - .02 * row;
        best = Math.min(best, StrictMath.hypot(Math.abs(p.x()) - x, p.y() - y));
      }
    }
    return p.z() < -.02 ? best : 1;
  }
}
