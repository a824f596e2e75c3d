package generator;

/** What covers a solid: a colour and a relief, as functions of the position on its surface. */
@FunctionalInterface
interface Paint {

  /** The sRGB colour 0xRRGGBB at {@code p}, where {@code n} is the outward unit normal. */
  int colour(Vec p, Vec n);

  /** The height of the relief above the surface at {@code p}; read near the surface, too. */
  default double height(Vec p) {
    return 0;
  }

  /** The mirror image in the plane x = 0. */
  default Paint mirrored() {
    Paint original = this;
    return new Paint() {
      @Override
      public int colour(Vec p, Vec n) {
        return original.colour(p.mirrored(), n.mirrored());
      }

      @Override
      public double height(Vec p) {
        return original.height(p.mirrored());
      }
    };
  }

  /** Puts a relief on a colour. */
  static Paint of(Paint colour, Relief relief) {
    return new Paint() {
      @Override
      public int colour(Vec p, Vec n) {
        return colour.colour(p, n);
      }

      @Override
      public double height(Vec p) {
        return relief.height(p);
      }
    };
  }

  /** The height of a relief. */
  @FunctionalInterface
  interface Relief {
    double height(Vec p);
  }
}
