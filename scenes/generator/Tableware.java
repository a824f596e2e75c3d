package generator;

/** Drinking glasses: closed surfaces with an outer and an inner wall. */
final class Tableware {
  private static final int SEGMENTS = 48;

  private Tableware() {}

  /** A wine glass, 0.22 units tall. */
  static ObjFile wineGlass() {
    return new Lathe()
        .curve(2, 0, .0012, .018, .0010, .034, 0)
        .arc(4, .0345, .0013, .0013, -90, 80)
        .curve(
            3, .0347, .0026, .024, .0042, .012, .0072, .0058, .013, .0042, .024, .0038, .05, .0039,
            .075, .0048, .09, .0105, .0985, .0225, .1085, .0345, .1245, .0405, .145, .0410, .163,
            .0385, .185, .0345, .2095)
        .curve(2, .0345, .2095, .0341, .2105, .0335, .2108, .0329, .2104, .0329, .2094)
        .curve(
            3, .0329, .2094, .0369, .185, .0394, .163, .0388, .145, .0328, .1252, .0212, .1104,
            .0105, .1035, 0, .1015)
        .into(new ObjFile(5), SEGMENTS);
  }

  /** A tumbler, 0.095 units tall, with a heavy bottom. */
  static ObjFile tumbler() {
    return new Lathe()
        .curve(2, 0, .0035, .016, .003, .026, .0004)
        .arc(6, .0275, .004, .004, -100, 4)
        .curve(6, .0315, .0043, .0338, .034, .0360, .065, .0378, .0936)
        .arc(8, .0366, .0938, .0012, 0, 180)
        .curve(6, .0354, .0936, .0337, .065, .0316, .034, .0297, .0165)
        .arc(6, .0257, .0165, .004, 0, -90)
        .curve(2, .0257, .0125, .014, .0118, 0, .0115)
        .into(new ObjFile(5), SEGMENTS);
  }
}
