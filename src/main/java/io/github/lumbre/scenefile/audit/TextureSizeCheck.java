package io.github.lumbre.scenefile.audit;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.SceneOrigins.TextureUse;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Reports textures whose resolution exceeds the resolution at which the camera sees them. */
final class TextureSizeCheck implements Check {
  private static final int GRID = 96;

  /** Texels per pixel, along a side, above which a texture is reported. */
  private static final double MOST_TEXELS = 4;

  /** Textures with fewer texels are not reported. */
  private static final long LEAST_TEXELS = 1L << 20;

  /** The quantile of the texels per pixel to compare: ignores the few closest pixels. */
  private static final double NEAREST_SHARE = .05;

  private static final int LEAST_PIXELS = 20;

  /** The primitive and the texture coordinates that a pixel sees. */
  private record Seen(int primitive, TexturePoint point) {}

  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    List<TextureUse> large =
        file.origins().textures().stream()
            .filter(use -> (long) use.width() * use.height() >= LEAST_TEXELS)
            .toList();
    if (large.isEmpty()) {
      return List.of();
    }
    Map<Origin, List<double[]>> steps = steps(file);
    List<Finding> findings = new ArrayList<>();
    for (TextureUse use : large) {
      double[] texels =
          steps.getOrDefault(use.material(), List.of()).stream()
              .mapToDouble(step -> texels(step, use))
              .sorted()
              .toArray();
      if (texels.length >= LEAST_PIXELS) {
        double nearest = texels[(int) (NEAREST_SHARE * texels.length)];
        if (nearest > MOST_TEXELS) {
          findings.add(finding(use, nearest));
        }
      }
    }
    return findings;
  }

  private static Finding finding(TextureUse use, double texels) {
    return Finding.note(
        "texture-size",
        use.texture(),
        String.format(
            Locale.ROOT,
            "%dx%d texels as %s of %s: at its closest, the camera sees %.0f texels per pixel's"
                + " side",
            use.width(),
            use.height(),
            use.channel(),
            use.material(),
            texels),
        "the extra texels cost memory and, without filtering, add noise but no detail",
        String.format(
            Locale.ROOT,
            "reduce it to %dx%d, unless mirrors or other views show it closer",
            (int) Math.ceil(use.width() / texels * 2),
            (int) Math.ceil(use.height() / texels * 2)));
  }

  /** Returns the number of texels along a pixel's side. */
  private static double texels(double[] step, TextureUse use) {
    double x = Math.abs(use.scaleX()) * use.width();
    double y = Math.abs(use.scaleY()) * use.height();
    return Math.sqrt(Math.abs(step[0] * step[3] - step[1] * step[2]) * x * y);
  }

  /** Returns du/dx, dv/dx, du/dy and dv/dy per pixel for sampled pixels, by material. */
  private static Map<Origin, List<double[]>> steps(ParsedScene file) {
    int width = file.settings().width();
    int height = file.settings().height();
    Sampler sampler = new SobolSampler(file.settings().seed());
    NearestHit hit = new NearestHit();
    Map<Origin, List<double[]>> steps = new HashMap<>();
    for (int i = 0; i < GRID * GRID; i++) {
      int x = (int) ((i % GRID + .5) / GRID * width);
      int y = (int) ((Math.floorDiv(i, GRID) + .5) / GRID * height);
      sampler.startSample(x, y, 0);
      Optional<Seen> here = seen(file, x, y, sampler, hit);
      Optional<Seen> right = seen(file, x + 1, y, sampler, hit);
      Optional<Seen> below = seen(file, x, y + 1, sampler, hit);
      if (here.isEmpty() || right.isEmpty() || below.isEmpty()) {
        continue;
      }
      int primitive = here.get().primitive;
      if (right.get().primitive == primitive && below.get().primitive == primitive) {
        TexturePoint p = here.get().point;
        TexturePoint r = right.get().point;
        TexturePoint b = below.get().point;
        double[] step = {r.u() - p.u(), r.v() - p.v(), b.u() - p.u(), b.v() - p.v()};
        // Skip texture seams, where the coordinates jump.
        if (Arrays.stream(step).allMatch(s -> Math.abs(s) < .25)) {
          Origin material = file.origins().materials().get(primitive);
          steps.computeIfAbsent(material, m -> new ArrayList<>()).add(step);
        }
      }
    }
    return steps;
  }

  private static Optional<Seen> seen(
      ParsedScene file, int x, int y, Sampler sampler, NearestHit hit) {
    Scene scene = file.scene();
    Point2 film =
        new Point2(
            Math.min((x + .5) / file.settings().width(), 0x1.fffffffffffffp-1),
            Math.min((y + .5) / file.settings().height(), 0x1.fffffffffffffp-1));
    Optional<Ray> ray = scene.camera().rayFor(film, sampler);
    if (ray.isEmpty() || !scene.intersect(ray.get(), hit)) {
      return Optional.empty();
    }
    return Optional.of(new Seen(hit.shape(), scene.surfaceAt(hit).texture()));
  }
}
