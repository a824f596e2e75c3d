package io.github.lumbre.model.format.gltf;

import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.model.ModelFormatException;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;

/** Keyframes of one animated property (glTF 2.0, section 3.11 and appendix C). */
final class GltfSampler {
  private static final List<String> INTERPOLATIONS = List.of("LINEAR", "STEP", "CUBICSPLINE");

  /** The angle between quaternions, in radians, below which a line replaces their arc. */
  private static final double SMALL_ANGLE = 1e-6;

  private final double[] times;
  private final double[] values;
  private final int width;
  private final String interpolation;

  /**
   * Reads the keyframes.
   *
   * @param width numbers per keyframe
   * @throws ModelFormatException if there are none, or their times do not increase
   */
  GltfSampler(GltfJson json, GltfAccessors accessors, int width)
      throws ModelFormatException, IOException {
    this.width = width;
    interpolation = json.choice("interpolation", "LINEAR", INTERPOLATIONS);
    GltfAccessor input = accessors.require(json, "input").requireComponents(1).requireAtLeast(1);
    times = accessors.finiteNumbers(input);
    for (int i = 1; i < times.length; i++) {
      if (!(times[i] > times[i - 1])) {
        throw input.error("", "expected increasing times, found " + times[i] + " at " + i);
      }
    }
    GltfAccessor output = accessors.require(json, "output");
    long needed = (isCubic() ? 3L : 1L) * width * times.length;
    if ((long) output.count() * output.components() < needed) {
      throw output.error(
          "count",
          "expected " + needed + " numbers, found " + (long) output.count() * output.components());
    }
    values = accessors.finiteNumbers(output);
  }

  private boolean isCubic() {
    return interpolation.equals("CUBICSPLINE");
  }

  /** Returns the time of the last keyframe, in seconds. */
  double end() {
    return times[times.length - 1];
  }

  /** Returns the value at a time. Before the first keyframe and after the last, those hold. */
  double[] at(double seconds) {
    return at(seconds, false);
  }

  /** As {@link #at}, for quaternions: the result has length 1. */
  double[] rotationAt(double seconds) {
    return unit(at(seconds, true));
  }

  private double[] at(double seconds, boolean isRotation) {
    int last = times.length - 1;
    if (!(seconds > times[0])) {
      return keyframe(0);
    }
    if (seconds >= times[last]) {
      return keyframe(last);
    }
    int found = Arrays.binarySearch(times, seconds);
    int key = found >= 0 ? found : -found - 2;
    double length = times[key + 1] - times[key];
    double t = (seconds - times[key]) / length;
    return switch (interpolation) {
      case "STEP" -> keyframe(key);
      case "LINEAR" ->
          isRotation
              ? slerp(unit(keyframe(key)), unit(keyframe(key + 1)), t)
              : linear(keyframe(key), keyframe(key + 1), t);
      default -> cubic(key, t, length);
    };
  }

  private static double[] unit(double... q) {
    return GltfNode.normalized(q).orElseGet(() -> new double[] {0, 0, 0, 1});
  }

  private double[] keyframe(int key) {
    int at = width * (isCubic() ? 3 * key + 1 : key);
    return Arrays.copyOfRange(values, at, at + width);
  }

  private static double[] linear(double[] a, double[] b, double t) {
    double[] value = new double[a.length];
    for (int i = 0; i < a.length; i++) {
      value[i] = (1 - t) * a[i] + t * b[i];
    }
    return value;
  }

  private double[] cubic(int key, double t, double length) {
    int a = 3 * width * key;
    int b = a + 3 * width;
    double[] value = new double[width];
    double t2 = t * t;
    double t3 = t2 * t;
    for (int i = 0; i < width; i++) {
      value[i] =
          (2 * t3 - 3 * t2 + 1) * values[a + width + i]
              + length * (t3 - 2 * t2 + t) * values[a + 2 * width + i]
              + (3 * t2 - 2 * t3) * values[b + width + i]
              + length * (t3 - t2) * values[b + i];
    }
    return value;
  }

  /** Returns a point on the shorter arc between two unit quaternions. */
  private static double[] slerp(double[] a, double[] b, double t) {
    double dot = 0;
    for (int i = 0; i < a.length; i++) {
      dot += a[i] * b[i];
    }
    double sign = dot < 0 ? -1 : 1;
    double difference = 0;
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      difference += (a[i] - sign * b[i]) * (a[i] - sign * b[i]);
      sum += (a[i] + sign * b[i]) * (a[i] + sign * b[i]);
    }
    double angle = 2 * Elementary.atan2(Math.sqrt(difference), Math.sqrt(sum));
    boolean isSmall = angle < SMALL_ANGLE;
    double sine = sin(angle);
    double wa = isSmall ? 1 - t : sin((1 - t) * angle) / sine;
    double wb = sign * (isSmall ? t : sin(t * angle) / sine);
    double[] value = new double[a.length];
    for (int i = 0; i < a.length; i++) {
      value[i] = wa * a[i] + wb * b[i];
    }
    return value;
  }

  private static double sin(double radians) {
    return Elementary.sinTurns(radians / Elementary.TWO_PI);
  }
}
