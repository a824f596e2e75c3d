package generator;

import static generator.Skeleton.HEAD;
import static generator.SuitedFigure.AMBER;
import static generator.SuitedFigure.BLACK;
import static generator.SuitedFigure.SHADE;
import static generator.SuitedFigure.SHELL;

/** The helmet of the suited figure and its collar. */
final class SuitHelmet {
  private final Sculpture sculpture;

  private SuitHelmet(Sculpture sculpture) {
    this.sculpture = sculpture;
  }

  static void addTo(Sculpture sculpture) {
    SuitHelmet part = new SuitHelmet(sculpture);
    part.helmet();
  }

  private static Sdf head() {
    return Sdf.union(
        .05,
        Sdf.ellipsoid(HEAD.plus(new Vec(0, .012, .01)), new Vec(.107, .125, .132)),
        Sdf.ellipsoid(HEAD.plus(new Vec(0, -.055, -.035)), new Vec(.082, .075, .098)));
  }

  private void helmet() {
    Sdf head = head();
    Sdf brow = Sdf.behind(HEAD.plus(new Vec(0, .045, -.1)), new Vec(0, 1, .2));
    Sdf cheek = Sdf.behind(HEAD.plus(new Vec(0, -.022, -.1)), new Vec(.38, -1, 0)).onBothSides();
    Sdf front = Sdf.behind(HEAD.plus(new Vec(.0, 0, -.028)), new Vec(-.25, 0, 1)).onBothSides();
    Sdf window = brow.and(.012, cheek).and(.012, front);
    Sdf glass = head.grown(-.003).and(.005, window.grown(.004));
    sculpture.add(.005, head.without(.006, window), helmetPaint());
    Paint visor =
        (p, n) -> {
          double glint = Math.abs(p.y() - HEAD.y() - .024 + .25 * p.x());
          return p.x() < -.02 && glint < .006 ? 0xffd98a : AMBER;
        };
    sculpture.add(.005, glass, visor);
    Sdf chin =
        Sdf.ellipsoid(HEAD.plus(new Vec(0, -.083, -.108)), new Vec(.046, .036, .034))
            .and(.006, Sdf.box(HEAD.plus(new Vec(0, -.085, -.12)), new Vec(.036, .03, .06), .008));
    Paint vents =
        Paint.of(
            (p, n) ->
                Shapes.toMultiple(p.y() - 1.572, .013) < .0034 && Math.abs(p.x()) < .026
                    ? BLACK
                    : SHADE,
            p -> Shapes.groove(Shapes.toMultiple(p.y() - 1.572, .013), .0045, .003));
    sculpture.add(.005, chin, vents);
    Vec ear = HEAD.plus(new Vec(.085, -.012, .022));
    Vec outside = HEAD.plus(new Vec(.128, -.012, .022));
    Bone spindle = new Bone(ear, outside);
    Sdf disc =
        Sdf.union(
            .003,
            Sdf.cone(ear, outside, .042, .034, .006),
            Sdf.cone(ear, outside.plus(new Vec(.007, 0, 0)), .018, .016, .004));
    Paint rings =
        Paint.of(
            (p, n) -> {
              double r = spindle.radius(p);
              return r < .0165 ? AMBER : r < .027 ? BLACK : SHADE;
            },
            p -> Shapes.groove(spindle.radius(p) - .027, .004, .002));
    sculpture.addPair(.005, disc, rings);
    Vec y = new Vec(0, 1, 0);
    Sdf collar =
        Sdf.union(
            .004,
            Sdf.cone(new Vec(0, 1.475, .014), new Vec(0, 1.535, .008), .092, .08, .01),
            Sdf.torus(new Vec(0, 1.53, .008), y, .077, .011),
            Sdf.torus(new Vec(0, 1.488, .014), y, .091, .012));
    sculpture.add(.0055, collar, (p, n) -> Math.abs(p.y() - 1.51) < .009 ? AMBER : SHADE);
  }

  private static Paint helmetPaint() {
    Paint colour =
        (p, n) -> {
          double crown = Math.abs(p.x());
          boolean above = p.y() > HEAD.y() + .05 || p.z() > .03 && p.y() > HEAD.y() - .06;
          if (above && crown < .03) {
            return crown < .018 ? AMBER : BLACK;
          }
          if (p.y() < HEAD.y() - .075 && p.z() > -.075) {
            return BLACK;
          }
          return p.y() < HEAD.y() - .068 && p.z() > -.075 ? SHADE : SHELL;
        };
    return Paint.of(
        colour,
        p ->
            Shapes.groove(Math.abs(p.x()) - .032, .0045, .002)
                + Shapes.groove(p.y() - HEAD.y() + .07, .005, .002)
                + (p.y() > HEAD.y() + .05 ? Shapes.groove(p.z() - .015, .0045, .0018) : 0));
  }
}
