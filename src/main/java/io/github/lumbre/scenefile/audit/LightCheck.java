package io.github.lumbre.scenefile.audit;

import io.github.lumbre.light.Light;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/** Reports each light's share of the image, and lights that contribute nothing. */
final class LightCheck implements Check {
  private static final String LAW = "light";

  /** The largest number of contributing lights to report, in descending order of their share. */
  private static final int MOST_SHARES = 8;

  /** Lights with a smaller fraction of the total power are not reported as unused. */
  private static final double LEAST_POWER = .01;

  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    List<Finding> findings = new ArrayList<>();
    List<Light> emitters = file.scene().emitters();
    if (emitters.isEmpty() && file.scene().ambient().isBlack() && !emits(file)) {
      findings.add(
          Finding.warning(
              LAW,
              new Origin("$.objects", ""),
              "the scene has no light",
              "the image is black",
              "add a light, or set renderOptions.background"));
      return findings;
    }
    unsampled(file, findings);
    if (!pilot.sawLight()) {
      findings.add(
          Finding.warning(
              LAW,
              new Origin("$", ""),
              "none of " + pilot.paths() + " pilot paths found light",
              "the image is black or almost black",
              "check that the camera sees objects and that the lights face them"));
      return findings;
    }
    shares(file, pilot, findings);
    return findings;
  }

  private static boolean emits(ParsedScene file) {
    return file.scene().primitives().stream()
        .anyMatch(p -> p.emission().isPresent() && !p.emission().get().isBlack());
  }

  /** Reports infinite emitters, which cannot be sampled. */
  private static void unsampled(ParsedScene file, List<Finding> findings) {
    for (int i = 0; i < file.scene().primitives().size(); i++) {
      Primitive primitive = file.scene().primitives().get(i);
      boolean isEndless = !Double.isFinite(primitive.shape().area());
      if (isEndless && primitive.emission().filter(e -> !e.isBlack()).isPresent()) {
        findings.add(
            Finding.note(
                LAW,
                file.origins().primitives().get(i),
                "an infinite plane that emits",
                "it cannot be sampled: only scattered rays that hit it carry its light, which adds"
                    + " noise",
                "make it finite, or use a Dome"));
      }
    }
  }

  private static void shares(ParsedScene file, Pilot pilot, List<Finding> findings) {
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
                "none of %s pilot paths found its light; it has %s of the power of all lights"
                    .formatted(pilot.paths(), percent(power)),
                "it costs samples but seems to light nothing in view: it may face away, be hidden,"
                    + " or be too small or too far for the pilot",
                "turn, move or remove it"));
      } else if (pilot.share(i) > 0 && emitters.size() > 1 && shown++ < MOST_SHARES) {
        findings.add(
            Finding.note(
                LAW,
                file.origins().emitters().get(i),
                percent(pilot.share(i)) + " of the image's light comes from it",
                "it has " + percent(power) + " of the power of all lights",
                ""));
      }
    }
  }

  private static String percent(double share) {
    return String.format(Locale.ROOT, "%.3g %%", 100 * share);
  }
}
