package generator;

import java.util.ArrayList;
import java.util.List;

/** The joints of the right half of a standing figure of 1.8 units, arms held a little away. */
final class Skeleton {
  static final Vec HIP = new Vec(.098, .93, .005);
  static final Vec KNEE = new Vec(.128, .505, -.012);
  static final Vec ANKLE = new Vec(.142, .10, .035);
  static final Vec SHOULDER = new Vec(.19, 1.425, .012);
  static final Vec ELBOW = new Vec(.352, 1.165, .035);
  static final Vec WRIST = new Vec(.487, .945, -.01);
  static final Vec HEAD = new Vec(0, 1.665, -.005);

  static final Bone TRUNK = new Bone(new Vec(0, .9, .0), new Vec(0, 1.5, .0));
  static final Bone THIGH = new Bone(HIP, KNEE);
  static final Bone SHIN = new Bone(KNEE, ANKLE);
  static final Bone UPPER_ARM = new Bone(SHOULDER, ELBOW);
  static final Bone FOREARM = new Bone(ELBOW, WRIST);
  static final Bone SOLE =
      new Bone(new Vec(.136, .04, .07), new Vec(.166, .03, -.16), new Vec(0, 1, 0));

  private Skeleton() {}

  /** The point of the hand so far beyond the wrist, towards the front and out of the back of it. */
  static Vec hand(double beyond, double front, double out) {
    Vec axis = FOREARM.axis.lerp(new Vec(.2, -1, -.05), .35).normalized();
    Vec across = new Vec(.05, 0, -1);
    across = across.minus(axis.times(across.dot(axis))).normalized();
    Vec back = across.cross(axis).normalized();
    back = back.x() < 0 ? back.times(-1) : back;
    return WRIST.plus(axis.times(beyond)).plus(across.times(front)).plus(back.times(out));
  }

  /** A hand with a thumb and four slightly bent fingers; {@code thick} scales what it wears. */
  static Sdf handShape(double thick) {
    List<Sdf> parts = new ArrayList<>();
    double[] starts = {.030, .011, -.009, -.028};
    double[] lengths = {.072, .082, .076, .06};
    for (int i = 0; i < 4; i++) {
      double f = starts[i];
      double l = lengths[i];
      double r = (i == 3 ? .0095 : .0108) * thick;
      Vec root = hand(.085, f, 0);
      Vec middle = hand(.085 + .55 * l, f * 1.12, -.006);
      Vec tip = hand(.085 + l, f * 1.12, -.022);
      parts.add(
          Sdf.union(
              .006, Sdf.limb(root, middle, r, r * .96), Sdf.limb(middle, tip, r * .96, r * .8)));
    }
    Sdf fingers = Sdf.union(.0, parts.toArray(new Sdf[0]));
    Sdf palm =
        Sdf.union(
            .02,
            Sdf.limb(hand(.015, .012, .002), hand(.078, .024, .003), .019 * thick, .0165 * thick),
            Sdf.limb(hand(.015, -.008, .002), hand(.078, .004, .004), .019 * thick, .0165 * thick),
            Sdf.limb(hand(.015, -.015, .002), hand(.078, -.02, .002), .018 * thick, .0155 * thick));
    Sdf thumb =
        Sdf.union(
            .008,
            Sdf.limb(hand(.02, .018, -.006), hand(.062, .053, -.014), .0165 * thick, .012 * thick),
            Sdf.limb(hand(.062, .053, -.014), hand(.094, .057, -.02), .012 * thick, .0095 * thick));
    return Sdf.union(.012, palm, fingers, thumb);
  }
}
