package io.github.lumbre.cli;

import io.github.lumbre.cli.FlagConverters.PixelPlace;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.PathVertex;
import io.github.lumbre.integrator.PathVertex.Gathered;
import io.github.lumbre.integrator.PathVertex.Meeting;
import io.github.lumbre.integrator.PathVertex.Scattering;
import io.github.lumbre.integrator.PathVertex.Source;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.parser.Origin;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.render.PixelReplay;

/** The samples of a pixel in words. Numbers have all their digits, so that bits can be compared. */
record PixelReport(SceneFile file, PixelPlace pixel) {
  /** Returns the path of a sample, vertex by vertex. */
  String text(PixelReplay.Sample sample) {
    StringBuilder out = new StringBuilder();
    line(out, "pixel " + pixel + ", sample " + sample.number() + ", seed " + seed());
    for (int i = 0; i < sample.vertices().size(); i++) {
      line(out, "vertex " + i);
      describe(sample.vertices().get(i), out);
    }
    if (sample.vertices().isEmpty()) {
      line(out, "the camera images nothing here");
    }
    line(out, "radiance     " + shown(sample.radiance()));
    if (sample.rejected()) {
      line(out, "rejected     negative or not finite: counts as black");
    }
    line(out, "film gets    " + shown(sample.film()));
    return out.toString();
  }

  /** Returns what the pixel's samples have in common, and the outstanding ones. */
  String text(PixelReplay.Pixel all) {
    StringBuilder out = new StringBuilder();
    line(out, "pixel " + pixel + ", " + all.samples() + " samples, seed " + seed());
    line(out, "mean         " + shown(all.mean()));
    line(out, "variance     " + shown(all.variance()) + " of one sample");
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
    line(out, "  counts for " + shown(vertex.throughput()));
    vertex.meeting().ifPresent(meeting -> describe(meeting, out));
    vertex.gathered().forEach(light -> describe(light, out));
    vertex.scattering().ifPresent(scattering -> describe(scattering, out));
    line(out, "  sum        " + shown(vertex.sum()));
    line(out, "  then       " + end(vertex.end()));
  }

  private void describe(Meeting meeting, StringBuilder out) {
    line(out, "  meets      " + primitive(meeting.primitive()));
    line(out, "  made of    " + material(meeting));
    line(out, "  position   " + shown(meeting.position()));
    line(out, "  normal     " + shown(meeting.geometricNormal()));
    if (!meeting.shadingNormal().equals(meeting.geometricNormal())) {
      line(out, "  shaded by  " + shown(meeting.shadingNormal()));
    }
  }

  private String material(Meeting meeting) {
    Origin origin = file.origins().materials().get(meeting.primitive());
    String what = origin.equals(Origin.NONE) ? "no material of the file" : origin.toString();
    return meeting.bsdf().isEmpty() ? what : what + " (" + meeting.bsdf() + ")";
  }

  private void describe(Gathered light, StringBuilder out) {
    String from = light.emitter() < 0 ? "" : " of " + emitter(light.emitter());
    line(out, "  light      " + source(light.source()) + from);
    line(out, "             radiance " + shown(light.radiance()));
    if (light.source() == Source.LIGHT) {
      line(out, "             from " + shown(light.wi()) + ", f " + shown(light.f()));
    }
    if (light.source() != Source.AMBIENT) {
      line(
          out,
          "             pdf of light sampling "
              + light.lightPdf()
              + ", of scattering "
              + light.bsdfPdf()
              + ", weight "
              + light.weight());
    }
    line(
        out,
        "             contribution "
            + shown(light.contribution())
            + (light.blocked() ? ": something is in between" : ""));
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
      line(out, "  roulette   survives with " + scattering.survival());
    }
  }

  /** Returns where an object stands. */
  String primitive(int number) {
    return file.origins().primitives().get(number).toString();
  }

  /** Returns where an emitter stands. */
  String emitter(int number) {
    return file.origins().emitters().get(number).toString();
  }

  private static String source(Source source) {
    return switch (source) {
      case EMISSION -> "met by the ray: emission";
      case BACKGROUND -> "met by the ray: beyond everything";
      case AMBIENT -> "ambient";
      case LIGHT -> "asked for";
    };
  }

  private static String end(PathVertex.End end) {
    return switch (end) {
      case GOES_ON -> "goes on";
      case ESCAPED -> "ends: nothing is met";
      case EMITTER -> "ends: what glows scatters nothing";
      case DEPTH -> "ends: the path is as deep as it may be";
      case ABSORBED -> "ends: nothing is scattered further";
      case ROULETTE -> "ends: by roulette";
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
