package generator;

import static generator.GlbFile.map;

import java.io.IOException;
import java.util.List;
import java.util.Map;

/**
 * A burning oil lantern on a wooden board, 0.42 m tall: lacquer, brass, thin glass, wood, light.
 */
final class Lantern {
  private static final int SEGMENTS = 44;
  private static final int WOOD = 384;

  private Lantern() {}

  static GlbFile glb() throws IOException {
    GlbFile file = new GlbFile();
    file.add("board", turned(board()).fromAbove(2.6), wood(file.texture(woodGrain())));
    file.add("tank", turned(tank()), coated(List.of(.42, .03, .025, 1)));
    file.add("burner", turned(burner()), metal(List.of(.91, .70, .32, 1), .28));
    file.add("flame", turned(flame()), flameLight());
    file.add("chimney", turned(glass()), thinGlass());
    file.add("cap", turned(cap()), metal(List.of(.91, .70, .32, 1), .22));
    file.add("frame", frame(), metal(List.of(.56, .55, .53, 1), .35));
    return file;
  }

  private static GlbFile.Part turned(Lathe lathe) {
    return lathe.into(new GlbFile.Part(), SEGMENTS);
  }

  private static Lathe board() {
    return new Lathe()
        .curve(1, 0, -.03, .178, -.03)
        .arc(6, .178, -.025, .005, -90, 0)
        .curve(1, .183, -.025, .183, -.006)
        .arc(6, .177, -.006, .006, 0, 90)
        .curve(1, .177, 0, 0, 0);
  }

  private static Lathe tank() {
    return new Lathe()
        .curve(1, 0, .0005, .086, .0005)
        .arc(8, .086, .0065, .006, -90, 0)
        .curve(8, .092, .0065, .094, .018, .093, .034, .084, .051, .062, .064, .036, .071)
        .arc(6, .036, .075, .004, -90, 60)
        .curve(4, .038, .0785, .031, .081, .028, .082, 0, .082);
  }

  private static Lathe burner() {
    return new Lathe()
        .curve(1, 0, .0822, .030, .0822)
        .arc(4, .030, .0842, .002, -90, 0)
        .curve(5, .032, .0842, .033, .092, .044, .099, .054, .101)
        .arc(6, .054, .1035, .0025, -90, 90)
        .curve(5, .054, .106, .040, .107, .022, .110, .013, .118)
        .arc(4, .0115, .1185, .0015, 0, 90)
        .curve(1, .0115, .12, 0, .12);
  }

  private static Lathe flame() {
    return new Lathe()
        .curve(
            6, 0, .1215, .006, .1225, .0118, .131, .0128, .142, .0098, .157, .0052, .173, .0018,
            .188, 0, .196);
  }

  /** One wall: glass as thin as this bends no light that anyone could see. */
  private static Lathe glass() {
    return new Lathe()
        .curve(
            7, .044, .1066, .051, .121, .0605, .145, .064, .168, .060, .193, .049, .218, .041, .240,
            .0395, .252);
  }

  private static Lathe cap() {
    return new Lathe()
        .curve(1, 0, .2505, .046, .2505)
        .arc(6, .046, .2535, .003, -90, 0)
        .curve(4, .049, .2535, .050, .262, .055, .268)
        .arc(6, .055, .2705, .0025, -90, 70)
        .curve(6, .0555, .273, .046, .284, .033, .296, .028, .308)
        .arc(6, .0285, .3105, .0025, -60, 90)
        .curve(4, .0285, .313, .018, .319, .008, .3225, 0, .3235);
  }

  /** Two rods from the tank to the cap, and the bail above. */
  private static GlbFile.Part frame() {
    GlbFile.Part part = new GlbFile.Part();
    for (int side = -1; side <= 1; side += 2) {
      Tube.into(
          part,
          .0042,
          curve(
              side, .078, .05, .098, .075, .104, .12, .104, .2, .098, .247, .08, .268, .05, .272));
      Tube.into(part, .0075, new double[][] {{side * .0985, .262}, {side * .1125, .262}});
    }
    double[][] bail = new double[33][];
    for (int i = 0; i < bail.length; i++) {
      double angle = Math.PI * i / (bail.length - 1);
      bail[i] =
          new double[] {
            -.1065 * StrictMath.cos(angle), .262 + .128 * Math.sqrt(StrictMath.sin(angle))
          };
    }
    bail[0][1] = .262;
    Tube.into(part, .0028, bail);
    return part;
  }

  /** A smooth curve through points (x, y), with x mirrored if the side is -1. */
  private static double[][] curve(int side, double... xy) {
    int pieces = xy.length / 2 - 1;
    int steps = 6;
    double[][] points = new double[pieces * steps + 1][2];
    for (int i = 0; i < points.length; i++) {
      int piece = Math.min(i / steps, pieces - 1);
      double t = (double) (i - piece * steps) / steps;
      for (int k = 0; k < 2; k++) {
        double a = xy[2 * Math.max(0, piece - 1) + k];
        double b = xy[2 * piece + k];
        double c = xy[2 * piece + 2 + k];
        double d = xy[2 * Math.min(pieces, piece + 2) + k];
        points[i][k] =
            b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
      }
      points[i][0] *= side;
    }
    return points;
  }

  /** Boards of oak, side by side. */
  private static Raster woodGrain() {
    Raster raster = new Raster(WOOD, WOOD);
    for (int y = 0; y < WOOD; y++) {
      for (int x = 0; x < WOOD; x++) {
        double u = (double) x / WOOD;
        double v = (double) y / WOOD;
        int plank = (int) (v * 5);
        double across = v * 5 - plank;
        double warp = Shapes.noise(u * 5 + 17 * plank, v * 14, 3) * 1.6;
        double ring = .5 + .5 * StrictMath.sin((across * 9 + warp * 3 + plank * 5) * 2.4);
        double fiber = Shapes.noise(u * 14, v * 190, 9 + plank);
        double shade =
            .62 + .16 * ring + .20 * (fiber - .5) + .05 * (Shapes.hash(plank, 7, 1) % 5 - 2);
        double gap = Shapes.step(0, .025, Math.min(across, 1 - across));
        shade *= .25 + .75 * gap;
        raster.set(x, y, byteOf(shade * 196) << 16 | byteOf(shade * 142) << 8 | byteOf(shade * 92));
      }
    }
    return raster;
  }

  private static int byteOf(double value) {
    // Steps of four make the file a third of the size, and cannot be seen in wood.
    return (int) Math.max(0, Math.min(255, 4 * Math.rint(value / 4)));
  }

  private static Map<String, Object> wood(int texture) {
    return map(
        "pbrMetallicRoughness",
        map("baseColorTexture", map("index", texture), "metallicFactor", 0, "roughnessFactor", .6));
  }

  private static Map<String, Object> metal(List<Number> color, double roughness) {
    return map(
        "pbrMetallicRoughness",
        map("baseColorFactor", color, "metallicFactor", 1, "roughnessFactor", roughness));
  }

  private static Map<String, Object> coated(List<Number> color) {
    return map(
        "pbrMetallicRoughness",
        map("baseColorFactor", color, "metallicFactor", 0, "roughnessFactor", .55),
        "extensions",
        map("KHR_materials_clearcoat", map("clearcoatFactor", 1, "clearcoatRoughnessFactor", .04)));
  }

  private static Map<String, Object> thinGlass() {
    return map(
        "pbrMetallicRoughness",
        map(
            "baseColorFactor",
            List.of(.97, .98, .97, 1),
            "metallicFactor",
            0,
            "roughnessFactor",
            0),
        "doubleSided",
        true,
        "extensions",
        map(
            "KHR_materials_transmission",
            map("transmissionFactor", 1),
            "KHR_materials_ior",
            map("ior", 1.5)));
  }

  private static Map<String, Object> flameLight() {
    return map(
        "pbrMetallicRoughness",
        map("baseColorFactor", List.of(0, 0, 0, 1), "metallicFactor", 0, "roughnessFactor", 1),
        "emissiveFactor",
        List.of(1, .52, .16),
        "extensions",
        map("KHR_materials_emissive_strength", map("emissiveStrength", 24)));
  }
}
