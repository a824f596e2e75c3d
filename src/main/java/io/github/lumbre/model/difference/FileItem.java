package io.github.lumbre.model.difference;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.base.text.Quantities;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.difference.PartChange.Kind;
import io.github.lumbre.model.difference.PartChange.Subject;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelAnimation;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelLight;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;

/**
 * Something in a model's file that is not a part: a light, a camera, an animation, a variant.
 *
 * @param name in the file; empty if it has none
 * @param values what it states, by words for people
 */
record FileItem(Subject of, String name, Map<String, Value> values) {
  /** Numbers that differ by less than this part of them are the same. */
  private static final double SAME = 1e-5;

  /**
   * Numbers, or a text.
   *
   * @param text for people
   * @param numbers that are compared; if empty, the text is
   * @param tolerance by which numbers may differ, at least
   */
  private record Value(String text, double[] numbers, double tolerance) {
    boolean isLike(Value other) {
      if (numbers.length != other.numbers.length || numbers.length == 0) {
        return text.equals(other.text) && numbers.length == other.numbers.length;
      }
      double most = DoubleStream.of(numbers).map(Math::abs).max().orElse(0);
      for (int i = 0; i < numbers.length; i++) {
        double apart = Math.abs(numbers[i] - other.numbers[i]);
        if (numbers[i] != other.numbers[i] && !(apart <= Math.max(tolerance, SAME * most))) {
          return false;
        }
      }
      return true;
    }
  }

  private static final class Values {
    private final Map<String, Value> all = new LinkedHashMap<>();
    private final FileSpace space;
    private final double tolerance;

    /**
     * @param tolerance by which positions may differ, in the unit of the file
     */
    Values(FileSpace space, double tolerance) {
      this.space = space;
      this.tolerance = tolerance;
    }

    Values text(String word, String text) {
      all.put(word, new Value(text, new double[0], 0));
      return this;
    }

    Values numbers(String word, double... numbers) {
      List<String> texts = new ArrayList<>();
      for (double number : numbers) {
        texts.add(Double.isFinite(number) ? Quantities.text(number) : "unlimited");
      }
      String text = texts.size() == 1 ? texts.get(0) : "(" + String.join(", ", texts) + ")";
      all.put(word, new Value(text, numbers, 0));
      return this;
    }

    Values position(String word, Vec3 world) {
      Vec3 p = space.fromFile().inversePoint(world);
      all.put(word, new Value(space.text(p), new double[] {p.x(), p.y(), p.z()}, tolerance));
      return this;
    }

    Values direction(String word, Vec3 world) {
      Vec3 v = space.vector(world).normalized();
      return numbers(word, v.x(), v.y(), v.z());
    }
  }

  /**
   * Returns what a model's file holds beside parts.
   *
   * @param keys texts that identify the keys of animations, in their order; may be empty
   * @param tolerance by which positions may differ, in world units
   */
  static List<FileItem> of(
      Model model, FileSpace space, List<String> keys, double tolerance) {
    double near = space.length(tolerance);
    List<FileItem> items = new ArrayList<>();
    for (ModelLight light : model.lights()) {
      Map<String, Value> values = values(light, new Values(space, near)).all;
      items.add(new FileItem(Subject.LIGHT, light.name(), values));
    }
    for (ModelCamera camera : model.cameras()) {
      Map<String, Value> values = values(camera, new Values(space, near)).all;
      items.add(new FileItem(Subject.CAMERA, camera.name(), values));
    }
    for (int i = 0; i < model.animations().size(); i++) {
      ModelAnimation animation = model.animations().get(i);
      Values values = new Values(space, near).text("keys", i < keys.size() ? keys.get(i) : "");
      animation.seconds().ifPresent(seconds -> values.numbers("seconds", seconds));
      items.add(new FileItem(Subject.ANIMATION, animation.name(), values.all));
    }
    for (String variant : model.variants()) {
      items.add(new FileItem(Subject.VARIANT, variant, Map.of()));
    }
    return items;
  }

  private static Values values(ModelLight light, Values values) {
    values.text("kind", light.kind().name());
    values.numbers(
        "intensity", light.intensity().r(), light.intensity().g(), light.intensity().b());
    values.numbers("range", light.range());
    if (light.kind() == ModelLight.Kind.SPOT) {
      values.numbers("inner cone", Math.toDegrees(light.innerCone()));
      values.numbers("outer cone", Math.toDegrees(light.outerCone()));
    }
    if (light.kind() != ModelLight.Kind.DIRECTIONAL) {
      values.position("position", light.toWorld().point(Vec3.ZERO));
    }
    if (light.kind() != ModelLight.Kind.POINT) {
      values.direction("direction", light.toWorld().vector(Vec3.Z.negated()));
    }
    return values;
  }

  private static Values values(ModelCamera camera, Values values) {
    if (camera.lens() instanceof ModelCamera.Perspective lens) {
      values.numbers("vertical field of view", Math.toDegrees(lens.verticalFov()));
      lens.aspect().ifPresent(aspect -> values.numbers("aspect", aspect));
    } else if (camera.lens() instanceof ModelCamera.Parallel lens) {
      values.numbers("frame", 2 * lens.halfWidth(), 2 * lens.halfHeight());
    }
    return values
        .position("position", camera.toWorld().point(Vec3.ZERO))
        .direction("direction", camera.toWorld().vector(Vec3.Z.negated()))
        .direction("up", camera.toWorld().vector(Vec3.Y));
  }

  /** Returns what changed between two files, beside their parts. */
  static List<PartChange> changes(List<FileItem> old, List<FileItem> now) {
    Map<String, FileItem> before = labeled(old);
    Map<String, FileItem> after = labeled(now);
    List<PartChange> changes = new ArrayList<>();
    after.forEach(
        (label, item) -> {
          List<String> details =
              before.containsKey(label) ? before.get(label).changes(item) : List.of();
          if (!before.containsKey(label)) {
            changes.add(item.change(Kind.ADDED, Optional.empty(), Optional.of(label), details));
          } else if (!details.isEmpty()) {
            changes.add(item.change(Kind.CHANGED, Optional.of(label), Optional.of(label), details));
          }
        });
    before.forEach(
        (label, item) -> {
          if (!after.containsKey(label)) {
            changes.add(
                item.change(Kind.REMOVED, Optional.of(label), Optional.empty(), List.of()));
          }
        });
    return changes;
  }

  private PartChange change(
      Kind kind, Optional<String> old, Optional<String> now, List<String> details) {
    return new PartChange(
        kind, of, old, now, Vec3.ZERO, 0, details, List.of(), List.of());
  }

  /** Returns items by what they are called: those of one name, or without one, have numbers. */
  private static Map<String, FileItem> labeled(List<FileItem> items) {
    Map<String, FileItem> labeled = new LinkedHashMap<>();
    for (FileItem item : items) {
      String word = item.of.name().toLowerCase(Locale.ROOT);
      String name = (word + " " + PrintableText.shortened(item.name)).strip();
      String label = item.name.isBlank() ? name + " 1" : name;
      for (int i = 2; labeled.containsKey(label); i++) {
        label = name + " " + i;
      }
      labeled.put(label, item);
    }
    return labeled;
  }

  private List<String> changes(FileItem now) {
    List<String> details = new ArrayList<>();
    for (String word : now.values.keySet()) {
      Value after = now.values.get(word);
      Value before = values.getOrDefault(word, new Value("none", new double[0], 0));
      if (!before.isLike(after)) {
        details.add(
            word.equals("keys") || before.text.equals(after.text)
                ? "other " + word
                : word + " " + before.text + " to " + after.text);
      }
    }
    for (String word : values.keySet()) {
      if (!now.values.containsKey(word)) {
        details.add(word + " " + values.get(word).text + " to none");
      }
    }
    return details;
  }
}
