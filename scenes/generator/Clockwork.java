package generator;

import static generator.GlbFile.map;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The movement of a clock, 0.35 m wide: wheels of brass, pinions of steel, jewels, blue screws. Its
 * animation runs it forward and back, so that it has no seam when it is repeated.
 */
final class Clockwork {
  private static final double SCALE = .1;
  private static final int STRIPES = 512;

  /** Duration of the animation in seconds, and the number of steps in it. */
  private static final double DURATION = 4;

  private static final int KEYS = 64;

  private static final double[] BALANCE = {.3, -.86};

  private final Wheel barrel = new Wheel("barrel", -.75, .25);
  private final Wheel center = new Wheel("center wheel", .17, .25);
  private final Wheel third = new Wheel("third wheel", .54, .89);
  private final Wheel fourth = new Wheel("fourth wheel", 1.08, .44);
  private final Wheel escape = new Wheel("escape wheel", .98, -.13);
  private final Wheel balance = new Wheel("balance", BALANCE[0], BALANCE[1]);

  private final GlbFile.Part bridges = new GlbFile.Part();
  private final GlbFile.Part blue = new GlbFile.Part();
  private final GlbFile.Part jewels = new GlbFile.Part();
  private final GlbFile.Part gold = new GlbFile.Part();

  /** What turns about one axis. */
  private record Wheel(
      String name,
      double[] axis,
      GlbFile.Part brass,
      GlbFile.Part steel,
      GlbFile.Part gold,
      GlbFile.Part blue) {
    Wheel(String name, double x, double z) {
      this(
          name,
          new double[] {x, z},
          new GlbFile.Part(),
          new GlbFile.Part(),
          new GlbFile.Part(),
          new GlbFile.Part());
    }

    Triangles<Integer> at(GlbFile.Part part) {
      return Clockwork.at(part, axis[0], axis[1]);
    }
  }

  private Clockwork() {}

  static GlbFile glb() throws IOException {
    Clockwork work = new Clockwork();
    work.train();
    work.balance();
    work.cocks();
    GlbFile file = new GlbFile();
    GlbFile.Part plate = new GlbFile.Part();
    plate().into(at(plate, 0, 0), 128);
    int stripes = file.texture(stripes());
    file.add("plate", plate.fromAbove(2.6), metal(Map.of("baseColorTexture", index(stripes)), .34));
    GlbFile.Part bridges = work.bridges.fromAbove(2.6);
    file.add("bridges", bridges, metal(Map.of("baseColorTexture", index(stripes)), .26));
    int brass = file.material("wheels", metal(color(.92, .68, .30), .2));
    int steel = file.material("steel", metal(color(.62, .60, .58), .16));
    int gold = file.material("gold", metal(color(.95, .70, .45), .12));
    int blue = file.material("screws", metal(color(.035, .06, .2), .14));
    file.add("gold", work.gold, gold);
    file.add("screws", work.blue, blue);
    file.add("jewels", work.jewels, jewel());
    work.turns()
        .forEach(
            (wheel, turns) -> {
              Map<Integer, GlbFile.Part> parts = new LinkedHashMap<>();
              parts.put(brass, wheel.brass);
              parts.put(steel, wheel.steel);
              parts.put(gold, wheel.gold);
              parts.put(blue, wheel.blue);
              parts.values().removeIf(GlbFile.Part::isEmpty);
              Vec axis = new Vec(wheel.axis[0], 0, wheel.axis[1]).times(SCALE);
              file.addTurning(wheel.name, axis, parts, times(), turns);
            });
    return file;
  }

  private static float[] times() {
    float[] times = new float[KEYS + 1];
    for (int i = 0; i < times.length; i++) {
      times[i] = (float) (DURATION * i / KEYS);
    }
    return times;
  }

  /**
   * Returns how far each wheel has turned at each time, by the teeth of the wheels and pinions: the
   * escape wheel turns once and back while the balance swings twice.
   */
  private Map<Wheel, double[]> turns() {
    double[] once = new double[KEYS + 1];
    double[] swings = new double[KEYS + 1];
    for (int i = 0; i <= KEYS; i++) {
      double phase = 2 * Math.PI * i / KEYS;
      once[i] = .5 - .5 * StrictMath.cos(phase);
      swings[i] = StrictMath.sin(2 * phase) / 3;
    }
    Map<Wheel, double[]> turns = new LinkedHashMap<>();
    turns.put(escape, once);
    turns.put(fourth, driving(once, 8, 50));
    turns.put(third, driving(turns.get(fourth), 10, 60));
    turns.put(center, driving(turns.get(third), 10, 64));
    turns.put(barrel, driving(turns.get(center), 12, 80));
    turns.put(balance, swings);
    return turns;
  }

  /** Returns how a wheel turns that drives a pinion. */
  private static double[] driving(double[] pinion, int leaves, int teeth) {
    double[] turns = new double[pinion.length];
    for (int i = 0; i < turns.length; i++) {
      turns[i] = -pinion[i] * leaves / teeth;
    }
    return turns;
  }

  /** The wheels in the order of the force, each driving the pinion of the next. */
  private void train() {
    wheel(barrel, 80, .8, .13, .1, 0, 0, .42);
    drum(barrel, .6, .2, .04);
    wheel(center, 64, .64, .3, .05, 5, .1, .5);
    pinion(center, 12, .12, .12, .16);
    wheel(third, 60, .6, .12, .05, 5, .09, .46);
    pinion(third, 10, .1, .3, .14);
    wheel(fourth, 50, .5, .38, .05, 4, .08, .56);
    pinion(fourth, 10, .1, .13, .14);
    wheel(escape, 15, .26, .22, .04, 4, .06, .52);
    pinion(escape, 8, .08, .38, .12);
  }

  private static void wheel(
      Wheel on, int teeth, double pitch, double y, double h, int spokes, double hub, double top) {
    Triangles<Integer> out = on.at(on.brass);
    double rim = spokes == 0 ? .1 : pitch - Math.max(.09, 3.4 * pitch / teeth);
    Gears.ring(out, teeth, rim, pitch, y, h);
    if (spokes > 0) {
      Gears.spokes(out, spokes, rim + .02, .07, y, .8 * h);
      Gears.ring(out, .02, hub, y, 1.5 * h);
    }
    arbor(on, top);
  }

  private static void arbor(Wheel on, double top) {
    new Lathe()
        .curve(1, 0, .01, .03, .01)
        .curve(1, .03, .01, .03, top - .03)
        .arc(5, .022, top - .03, .008, 0, 90)
        .curve(1, .022, top - .022, .012, top - .022)
        .curve(1, .012, top - .022, .012, top)
        .curve(1, .012, top, 0, top)
        .into(on.at(on.steel), 24);
  }

  private static void pinion(Wheel on, int teeth, double pitch, double y, double h) {
    Gears.ring(on.at(on.steel), teeth, .02, pitch, y, h);
  }

  /** The cover of the barrel, with a ring and a square end. */
  private static void drum(Wheel on, double radius, double y, double h) {
    new Lathe()
        .curve(1, 0, y, radius, y)
        .curve(1, radius, y, radius, y + h - .01)
        .arc(4, radius - .01, y + h - .01, .01, 0, 90)
        .curve(1, radius - .01, y + h, radius - .12, y + h)
        .arc(5, radius - .12, y + h - .015, .015, 90, 180)
        .curve(1, radius - .135, y + h - .015, .24, y + h - .015)
        .arc(5, .24, y + h, .015, 270, 180)
        .curve(1, .225, y + h, .225, y + h + .02)
        .arc(5, .21, y + h + .02, .015, 0, 90)
        .curve(1, .21, y + h + .035, 0, y + h + .035)
        .into(on.at(on.gold), 72);
    Gears.screw(on.at(on.blue), .13, y + h + .03, .08, .5);
  }

  private void balance() {
    Triangles<Integer> out = balance.at(balance.gold);
    Gears.ring(out, .47, .55, .42, .06);
    Gears.spokes(out, 2, .49, .08, .42, .04);
    Gears.ring(out, .02, .08, .42, .07);
    for (int i = 0; i < 12; i++) {
      double a = 2 * Math.PI * (i + .5) / 12;
      new Lathe()
          .curve(1, 0, .4, .026, .4)
          .curve(1, .026, .4, .026, .452)
          .arc(4, .018, .452, .008, 0, 90)
          .curve(1, .018, .46, 0, .46)
          .into(
              at(
                  balance.gold,
                  BALANCE[0] + .57 * StrictMath.cos(a),
                  BALANCE[1] + .57 * StrictMath.sin(a)),
              16);
    }
    arbor(balance, .66);
    double[][] spiral = new double[421][];
    for (int i = 0; i < spiral.length; i++) {
      double t = (double) i / (spiral.length - 1);
      double angle = 2 * Math.PI * 7.5 * t;
      double r = .06 + .27 * t;
      spiral[i] = new double[] {r * StrictMath.cos(angle), r * StrictMath.sin(angle)};
    }
    Tube.into(lying(blue, BALANCE[0], .51, BALANCE[1]), .0065, spiral);
  }

  /** Bridges over the train and the cock of the balance, on posts, with their jewels and screws. */
  private void cocks() {
    bridge(third.axis, .15, new double[] {.72, 1.46}, .16, .5);
    bridge(fourth.axis, .13, new double[] {1.6, .26}, .16, .6);
    bridge(escape.axis, .12, new double[] {1.5, -.52}, .14, .56);
    bridge(BALANCE, .17, new double[] {-.42, -1.44}, .24, .7);
    bridge(barrel.axis, .2, new double[] {-1.1, 1.2}, .22, .5);
    jewel(center.axis, .5, .1);
    for (double[] place : new double[][] {{-1.35, -.55}, {-.75, -.9}, {1.15, -1.05}, {-.2, 1.45}}) {
      Gears.screw(at(blue, place[0], place[1]), .1, 0, .05, place[0] * 3);
    }
  }

  private void bridge(double[] axis, double r1, double[] foot, double r2, double y) {
    Gears.bridge(at(bridges, 0, 0), axis, r1, foot, r2, y, .09);
    new Lathe()
        .curve(1, 0, 0, .8 * r2, 0)
        .curve(1, .8 * r2, 0, .8 * r2, y - .03)
        .curve(1, .8 * r2, y - .03, 0, y - .03)
        .into(at(bridges, foot[0], foot[1]), 40);
    Gears.screw(at(blue, foot[0], foot[1]), .58 * r2, y + .04, .045, foot[0] + 2 * foot[1]);
    jewel(axis, y + .045, .55 * r1);
  }

  /** A jewel in a ring of gold. */
  private void jewel(double[] axis, double y, double r) {
    new Lathe()
        .curve(1, 0, y - .02, r, y - .02)
        .curve(1, r, y - .02, r, y + .004)
        .arc(6, r - .012, y + .004, .012, 0, 180)
        .curve(1, r - .024, y + .004, 0, y + .002)
        .into(at(gold, axis[0], axis[1]), 40);
    double b = .72 * r;
    new Lathe()
        .curve(1, 0, y - .01, b, y - .01)
        .curve(1, b, y - .01, b, y + .004)
        .curve(6, b, y + .004, .9 * b, y + .02, .55 * b, y + .03, .2 * b, y + .018, 0, y + .012)
        .into(at(jewels, axis[0], axis[1]), 40);
  }

  private static Lathe plate() {
    return new Lathe()
        .curve(1, 0, -.16, 1.72, -.16)
        .arc(6, 1.72, -.12, .04, -90, 0)
        .curve(1, 1.76, -.12, 1.76, -.03)
        .arc(6, 1.73, -.03, .03, 0, 90)
        .curve(1, 1.73, 0, 0, 0);
  }

  /** Soft parallel stripes as a wide grinding wheel leaves them, and fine scratches. */
  private static Raster stripes() {
    Raster raster = new Raster(STRIPES, STRIPES);
    for (int y = 0; y < STRIPES; y++) {
      for (int x = 0; x < STRIPES; x++) {
        double across = (x * .8 + y * .6) / STRIPES * 17;
        double along = (y * .8 - x * .6) / STRIPES;
        double phase = across - Math.floor(across);
        double scratch = Shapes.noise(across * 22, along * 5, 4) - .5;
        int grey = (int) Math.rint((.60 + .20 * phase + .10 * scratch) * 60) * 4;
        raster.set(x, y, grey << 16 | (int) (grey * .98) << 8 | (int) (grey * .95));
      }
    }
    return raster;
  }

  private static Map<String, Object> index(int texture) {
    return map("index", texture);
  }

  private static Map<String, Object> color(double r, double g, double b) {
    return map("baseColorFactor", List.of(r, g, b, 1));
  }

  private static Map<String, Object> metal(Map<String, ?> color, double roughness) {
    Map<String, Object> values = map("metallicFactor", 1, "roughnessFactor", roughness);
    values.putAll(color);
    return map("pbrMetallicRoughness", values);
  }

  private static Map<String, Object> jewel() {
    return map(
        "pbrMetallicRoughness",
        map(
            "baseColorFactor",
            List.of(.62, .01, .05, 1),
            "metallicFactor",
            0,
            "roughnessFactor",
            .3),
        "extensions",
        map("KHR_materials_clearcoat", map("clearcoatFactor", 1, "clearcoatRoughnessFactor", .02)));
  }

  /** Parts are drawn around the y axis; this moves them and scales all to metres. */
  private static Triangles<Integer> at(GlbFile.Part part, double x, double z) {
    return new Moved(part, new Vec(x, 0, z), false);
  }

  private static Triangles<Integer> lying(GlbFile.Part part, double x, double y, double z) {
    return new Moved(part, new Vec(x, y, z), true);
  }

  /** Triangles moved to a place; those of an upright plane can be laid down, z becoming -y. */
  private record Moved(GlbFile.Part part, Vec place, boolean lying) implements Triangles<Integer> {
    @Override
    public Integer corner(Vec p, double u, double v, Vec n) {
      return part.corner(laid(p).plus(place).times(SCALE), u, v, laid(n));
    }

    private Vec laid(Vec v) {
      return lying ? new Vec(v.x(), -v.z(), v.y()) : v;
    }

    @Override
    public void face(Integer a, Integer b, Integer c) {
      part.face(a, b, c);
    }
  }
}
