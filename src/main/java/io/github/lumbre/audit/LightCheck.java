package io.github.lumbre.audit;

import io.github.lumbre.light.Light;
import io.github.lumbre.parser.Origin;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.scene.Primitive;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/** Which lights the picture gets its light from, and which send it none. */
final class LightCheck implements Check {
  private static final String LAW = "light";

  /** With more lights, only the strongest are reported one by one. */
  private static final int MOST_SHARES = 8;

  /** Lights of a smaller share of the power may be missed by few paths. */
  private static final double LEAST_POWER = .01;

  @Override
  public List<Finding> of(SceneFile file, Pilot pilot) {
    List<Finding> findings = new ArrayList<>();
    List<Light> emitters = file.scene().emitters();
    if (emitters.isEmpty() && file.scene().ambient().isBlack() && !emits(file)) {
      findings.add(
          Finding.warning(
              LAW,
              new Origin("$.objects", ""),
              "nothing shines",
              "the picture is black",
              "add a light, or set renderOptions.background"));
      return findings;
    }
    unsampled(file, findings);
    if (!pilot.sawLight()) {
      findings.add(
          Finding.warning(
              LAW,
              new Origin("$", ""),
              "none of " + pilot.paths() + " paths found light",
              "the picture is black or nearly so",
              "look whether the lights face what the camera sees, and whether it sees anything"));
      return findings;
    }
    shares(file, pilot, findings);
    return findings;
  }

  private static boolean emits(SceneFile file) {
    return file.scene().primitives().stream()
        .anyMatch(p -> p.emission().isPresent() && !p.emission().get().isBlack());
  }

  /** An infinite emitter cannot be sampled. */
  private static void unsampled(SceneFile file, List<Finding> findings) {
    for (int i = 0; i < file.scene().primitives().size(); i++) {
      Primitive primitive = file.scene().primitives().get(i);
      boolean isEndless = !Double.isFinite(primitive.shape().area());
      if (isEndless && primitive.emission().filter(e -> !e.isBlack()).isPresent()) {
        findings.add(
            Finding.note(
                LAW,
                file.origins().primitives().get(i),
                "an infinite plane that emits",
                "it lights objects only where a scattered ray happens to hit it, which adds noise",
                "make it finite, or use a Dome"));
      }
    }
  }

  private static void shares(SceneFile file, Pilot pilot, List<Finding> findings) {
    List<Light> emitters = file.scene().emitters();
    double radius = file.scene().radius();
    double all = emitters.stream().mapToDouble(e -> e.power(radius)).sum();
    List<Integer> order =
        IntStream.range(0, emitters.size())
            .boxed()
            .sorted(Comparator.comparingDouble(i -> -pilot.share(i)))
            .toList();
    int shown = 0;
    for (int i : order) {
      double power = emitters.get(i).power(radius) / all;
      if (pilot.share(i) == 0 && power > LEAST_POWER) {
        findings.add(
            Finding.note(
                LAW,
                file.origins().emitters().get(i),
                "none of "
                    + pilot.paths()
                    + " paths found light of it, "
                    + percent(power)
                    + " of the power of all lights",
                "it faces away from what the camera sees, is hidden, or is too small or far for so"
                    + " few paths",
                "turn or move it, or remove it: samples are spent on it"));
      } else if (pilot.share(i) > 0 && emitters.size() > 1 && shown++ < MOST_SHARES) {
        findings.add(
            Finding.note(
                LAW,
                file.origins().emitters().get(i),
                percent(pilot.share(i)) + " of the picture's light comes from it",
                "it has " + percent(power) + " of the power of all lights",
                ""));
      }
    }
  }

  private static String percent(double share) {
    return String.format(Locale.ROOT, "%.3g %%", 100 * share);
  }
}
