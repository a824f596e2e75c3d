package generator;

/**
 * A plate of armour around a bone: a band and a groove along both ends, rivets beside the grooves,
 * and whatever colour a plate has of its own.
 */
final class PlatePaint implements Paint {
  static final int PLATE = 0xdedacd;
  static final int BAND = 0xa8a294;
  static final int RIVET = 0x8d7340;
  static final int DARK = 0x2b2c31;
  static final int BLUE = 0x1f5c8a;
  static final int RED = 0xb5432a;

  private static final double BAND_WIDTH = .009;
  private static final double RIVET_RADIUS = .0062;

  private final Bone bone;
  private final double start;
  private final double end;
  private final int rivetsAtStart;
  private final int rivetsAtEnd;
  private final Paint own;

  /**
   * @param start where the plate starts along the bone
   * @param end where it ends
   * @param rivetsAtStart how many rivets go round at the start
   * @param rivetsAtEnd how many go round at the end
   * @param own the colour between the bands, and a relief of its own
   */
  PlatePaint(Bone bone, double start, double end, int rivetsAtStart, int rivetsAtEnd, Paint own) {
    this.bone = bone;
    this.start = start;
    this.end = end;
    this.rivetsAtStart = rivetsAtStart;
    this.rivetsAtEnd = rivetsAtEnd;
    this.own = own;
  }

  static Paint plain(int colour) {
    return (p, n) -> colour;
  }

  @Override
  public int colour(Vec p, Vec n) {
    double t = bone.along(p);
    if (t - start < BAND_WIDTH || end - t < BAND_WIDTH) {
      return BAND;
    }
    return toRivet(p) < RIVET_RADIUS ? RIVET : own.colour(p, n);
  }

  @Override
  public double height(Vec p) {
    double t = bone.along(p);
    double groove =
        Shapes.groove(t - start - BAND_WIDTH, .004, .0016)
            + Shapes.groove(end - t - BAND_WIDTH, .004, .0016);
    return groove + Shapes.knob(toRivet(p), RIVET_RADIUS, .0028) + own.height(p);
  }

  private double toRivet(Vec p) {
    double inset = BAND_WIDTH + .012;
    double a = rivetsAtStart > 0 ? bone.toRing(p, start + inset, rivetsAtStart) : 1;
    double b = rivetsAtEnd > 0 ? bone.toRing(p, end - inset, rivetsAtEnd) : 1;
    return Math.min(a, b);
  }
}
