package io.github.lumbre.cli.output;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.Contribution;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Hit;
import io.github.lumbre.integrator.path.PathVertex.Scattering;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.SceneOrigins;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Formats the samples of a pixel as text. Numbers have {@value #DIGITS} significant digits; those
 * of {@link PixelJson} have all.
 */
public record PixelReport(SceneFile file, PixelPlace pixel) {
  private static final int DIGITS = 6;

  /** Numbers from here, in magnitude, have no exponent. */
  private static final double SMALL = 1e-4;

  private static final double LARGE = 1e9;

  private static final int MOST_SEEN = 8;

  /**
   * What is seen in a pixel.
   *
   * @param samples the number of samples whose camera ray hits it first
   */
  record Seen(Origin object, Origin material, int samples) {}

  /** Returns the places of the scene's objects in its file. */
  SceneOrigins origins() {
    return file.parsed().origins();
  }

  /** Returns the path of a sample, vertex by vertex. */
  public String text(PixelReplay.Sample sample) {
    StringBuilder out = new StringBuilder();
    line(out, "pixel " + pixel + ", sample " + sample.number() + ", seed " + seed());
    Rgb sum = Rgb.BLACK;
    int branch = 0;
    for (int i = 0; i < sample.vertices().size(); i++) {
      PathVertex vertex = sample.vertices().get(i);
      if (vertex.branch() != branch) {
        branch = vertex.branch();
        line(out, "branch " + branch + " of the split path");
      }
      line(out, "vertex " + i);
      describe(vertex, out);
      for (Contribution contribution : vertex.contributions()) {
        sum = sum.plus(contribution.amount());
      }
      line(out, "  sum        " + shown(sum));
      line(out, "  next       " + end(vertex.end()));
    }
    if (sample.vertices().isEmpty()) {
      line(out, "the camera has no ray for this sample");
    }
    line(out, "radiance     " + shown(sample.radiance()));
    if (sample.rejected()) {
      line(
          out,
          "rejected     negative, NaN or infinite, or a ray through more than 65,536 transparent"
              + " surfaces: added to the film as black");
    }
    if (sample.clamped()) {
      line(out, "clamped      to " + shown(file.settings().clamp()));
    }
    line(out, "film         " + shown(sample.film()));
    return out.toString();
  }

  /** Returns the mean and variance of the pixel's samples, and the brightest of them. */
  public String text(PixelReplay.Pixel all) {
    StringBuilder out = new StringBuilder();
    String samples = Numbers.count(all.samples(), "sample");
    line(out, "pixel " + pixel + ", " + samples + ", seed " + seed());
    describeSeen(all, out);
    line(out, "mean         " + shown(all.mean()));
    line(out, "variance     " + shown(all.variance()) + " per sample");
    line(out, "rejected     " + Numbers.count(all.rejected(), "sample"));
    for (PixelReplay.Sample sample : all.firstRejected()) {
      line(out, "rejected     sample " + sample.number() + ": " + shown(sample.radiance()));
    }
    for (PixelReplay.Sample sample : all.brightest()) {
      line(
          out,
          "brightest    sample %s: %s, %s"
              .formatted(sample.number(), shown(sample.film()), vertices(sample)));
    }
    return out.toString();
  }

  private static String vertices(PixelReplay.Sample sample) {
    int number = sample.vertices().size();
    return number == 1 ? "1 vertex" : number + " vertices";
  }

  private void describeSeen(PixelReplay.Pixel all, StringBuilder out) {
    List<Seen> seen = seen(all);
    for (Seen one : seen.subList(0, Math.min(MOST_SEEN, seen.size()))) {
      String what = one.object() + ", material " + material(one.material());
      line(out, "shows        " + what + share(one.samples(), all));
    }
    if (seen.size() > MOST_SEEN) {
      line(out, "shows        " + (seen.size() - MOST_SEEN) + " more objects");
    }
    int hits = seen.stream().mapToInt(Seen::samples).sum();
    if (hits < all.samples()) {
      line(out, "shows        no object" + share(all.samples() - hits, all));
    }
  }

  private static String share(int samples, PixelReplay.Pixel all) {
    return samples == all.samples() ? "" : " (%d of the samples)".formatted(samples);
  }

  /** Returns the objects that are seen in a pixel, with their materials, most samples first. */
  List<Seen> seen(PixelReplay.Pixel all) {
    Map<List<Origin>, Integer> samples = new LinkedHashMap<>();
    all.seen()
        .forEach(
            (primitive, count) -> {
              Origin object = origins().primitives().get(primitive);
              Origin material = origins().materials().get(primitive);
              samples.merge(List.of(object, material), count, Integer::sum);
            });
    return samples.entrySet().stream()
        .map(e -> new Seen(e.getKey().get(0), e.getKey().get(1), e.getValue()))
        .sorted(Comparator.comparingInt(seen -> -seen.samples()))
        .toList();
  }

  long seed() {
    return file.settings().seed();
  }

  private void describe(PathVertex vertex, StringBuilder out) {
    line(out, "  ray        from " + shown(vertex.ray().origin()));
    line(out, "             towards " + shown(vertex.ray().direction()));
    line(out, "  throughput " + shown(vertex.throughput()));
    vertex.hit().ifPresent(hit -> describe(hit, out));
    vertex.contributions().forEach(contribution -> describe(contribution, out));
    vertex.scattered().forEach(scattering -> describe(scattering, out));
  }

  private void describe(Hit hit, StringBuilder out) {
    line(out, "  hits       " + primitive(hit.primitive()));
    line(out, "  material   " + material(hit));
    line(out, "  position   " + shown(hit.position()));
    line(out, "  normal     " + shown(hit.geometricNormal()));
    if (!hit.shadingNormal().equals(hit.geometricNormal())) {
      line(out, "  shading    " + shown(hit.shadingNormal()));
    }
  }

  private String material(Hit hit) {
    String what = material(origins().materials().get(hit.primitive()));
    return hit.bsdf().isEmpty() ? what : what + " (" + hit.bsdf() + ")";
  }

  private static String material(Origin origin) {
    return origin.equals(Origin.NONE) ? "no material in the scene file" : origin.toString();
  }

  private void describe(Contribution contribution, StringBuilder out) {
    contribution.lights().forEach(light -> describe(light, out));
    line(out, "  adds       " + shown(contribution.amount()));
  }

  private void describe(FoundLight light, StringBuilder out) {
    String of = light.emitter() < 0 ? "" : ": " + emitter(light.emitter());
    line(out, "  light      " + source(light.source()) + of);
    line(out, "             radiance " + shown(light.radiance()));
    switch (light.source()) {
      case LENS ->
          line(out, "             direction " + shown(light.wi()) + " from the plane of focus");
      case LIGHT, MIRROR, REFRACTION ->
          line(out, "             direction " + shown(light.wi()) + ", f·cos " + shown(light.f()));
      case EMISSION, ENVIRONMENT, AMBIENT -> {
        // The ray has the direction, or there is none.
      }
    }
    if (light.source() != Source.AMBIENT) {
      line(
          out,
          "             pdf of light sampling "
              + shown(light.lightPdf())
              + otherWay(light.source())
              + shown(light.bsdfPdf())
              + ", MIS weight "
              + shown(light.misWeight()));
    }
    if (light.blocked()) {
      line(out, "             blocked");
    }
  }

  private void describe(Scattering scattering, StringBuilder out) {
    line(out, "  scatters   towards " + shown(scattering.wi()));
    line(
        out,
        "             weight f·cos/pdf %s, pdf %s"
            .formatted(shown(scattering.weight()), shown(scattering.pdf())));
    if (scattering.survival() < 1) {
      String outcome = scattering.survives() ? "survived" : "ended";
      String probability = shown(scattering.survival());
      line(out, "  roulette   " + outcome + ", survival probability " + probability);
    }
  }

  /** Returns the place of an object in the scene file. */
  String primitive(int number) {
    return origins().primitives().get(number).toString();
  }

  /** Returns the place of a light in the scene file. */
  String emitter(int number) {
    return origins().emitters().get(number).toString();
  }

  /** Returns a label of the density that is weighted against light sampling. */
  private static String otherWay(Source source) {
    return switch (source) {
      case LIGHT, MIRROR, REFRACTION -> ", of BSDF sampling ";
      case LENS -> ", of random lens points ";
      case EMISSION, ENVIRONMENT, AMBIENT -> ", of the ray ";
    };
  }

  private static String source(Source source) {
    return switch (source) {
      case EMISSION -> "emission of the hit surface";
      case ENVIRONMENT -> "environment";
      case AMBIENT -> "ambient";
      case LIGHT -> "sampled light";
      case LENS -> "light sampled through the lens";
      case MIRROR -> "light sampled in a mirror";
      case REFRACTION -> "light sampled through a refracting surface";
    };
  }

  private static String end(PathVertex.End end) {
    return switch (end) {
      case CONTINUES -> "continues";
      case SPLIT -> "is split into branches";
      case ESCAPED -> "ends: the ray hits nothing";
      case EMITTER -> "ends: lights do not scatter";
      case DEPTH -> "ends: the path length limit is reached";
      case ABSORBED -> "ends: the surface absorbs all light";
      case ROULETTE -> "ends: by Russian roulette";
    };
  }

  private static void line(StringBuilder out, String text) {
    out.append(text).append('\n');
  }

  private static String shown(Rgb color) {
    return shown(color.r(), color.g(), color.b());
  }

  private static String shown(Vec3 vector) {
    return shown(vector.x(), vector.y(), vector.z());
  }

  private static String shown(double x, double y, double z) {
    return "(" + shown(x) + ", " + shown(y) + ", " + shown(z) + ")";
  }

  private static String shown(double value) {
    double size = Math.abs(value);
    if (value == 0 || !Double.isFinite(value)) {
      return value == 0 ? "0" : String.valueOf(value);
    }
    BigDecimal rounded = new BigDecimal(value).round(new MathContext(DIGITS));
    return size >= SMALL && size < LARGE
        ? rounded.stripTrailingZeros().toPlainString()
        : String.format(Locale.ROOT, "%." + (DIGITS - 1) + "e", rounded);
  }
}
