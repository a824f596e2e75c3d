package io.github.lumbre.cli.output;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.parser.Origin;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.path.PathVertex;
import io.github.lumbre.path.PathVertex.Contribution;
import io.github.lumbre.path.PathVertex.FoundLight;
import io.github.lumbre.path.PathVertex.Hit;
import io.github.lumbre.path.PathVertex.Scattering;
import io.github.lumbre.path.PathVertex.Source;
import io.github.lumbre.render.PixelReplay;

/**
 * Formats the samples of a pixel as text. Numbers have all digits, so that bits can be compared.
 */
public record PixelReport(SceneFile file, PixelPlace pixel) {
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
      line(out, "rejected     negative, NaN or infinite: added to the film as black");
    }
    if (sample.clamped()) {
      line(out, "clamped      to " + file.settings().clamp());
    }
    line(out, "film         " + shown(sample.film()));
    return out.toString();
  }

  /** Returns the mean and variance of the pixel's samples, and the brightest of them. */
  public String text(PixelReplay.Pixel all) {
    StringBuilder out = new StringBuilder();
    line(out, "pixel " + pixel + ", " + all.samples() + " samples, seed " + seed());
    line(out, "mean         " + shown(all.mean()));
    line(out, "variance     " + shown(all.variance()) + " per sample");
    line(out, "rejected     " + all.rejected() + " samples");
    for (PixelReplay.Sample sample : all.firstRejected()) {
      line(out, "rejected     sample " + sample.number() + ": " + shown(sample.radiance()));
    }
    for (PixelReplay.Sample sample : all.brightest()) {
      line(
          out,
          "brightest    sample "
              + sample.number()
              + ": "
              + shown(sample.film())
              + ", vertices "
              + sample.vertices().size());
    }
    return out.toString();
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
    Origin origin = file.origins().materials().get(hit.primitive());
    String what = origin.equals(Origin.NONE) ? "no material in the scene file" : origin.toString();
    return hit.bsdf().isEmpty() ? what : what + " (" + hit.bsdf() + ")";
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
        // The direction is that of the ray, or there is none.
      }
    }
    if (light.source() != Source.AMBIENT) {
      line(
          out,
          "             pdf of light sampling "
              + light.lightPdf()
              + otherWay(light.source())
              + light.bsdfPdf()
              + ", MIS weight "
              + light.misWeight());
    }
    if (light.blocked()) {
      line(out, "             blocked");
    }
  }

  private void describe(Scattering scattering, StringBuilder out) {
    line(out, "  scatters   towards " + shown(scattering.wi()));
    line(
        out,
        "             weight f·cos/pdf "
            + shown(scattering.weight())
            + ", pdf "
            + scattering.pdf());
    if (scattering.survival() < 1) {
      String outcome = scattering.survives() ? "survived" : "ended";
      line(out, "  roulette   " + outcome + ", survival probability " + scattering.survival());
    }
  }

  /** Returns the place of an object in the scene file. */
  String primitive(int number) {
    return file.origins().primitives().get(number).toString();
  }

  /** Returns the place of a light in the scene file. */
  String emitter(int number) {
    return file.origins().emitters().get(number).toString();
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

  private static String shown(Rgb colour) {
    return "(" + colour.r() + ", " + colour.g() + ", " + colour.b() + ")";
  }

  private static String shown(Vec3 vector) {
    return "(" + vector.x() + ", " + vector.y() + ", " + vector.z() + ")";
  }
}
