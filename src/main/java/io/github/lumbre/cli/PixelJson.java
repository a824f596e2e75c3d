package io.github.lumbre.cli;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.PathVertex;
import io.github.lumbre.integrator.PathVertex.Gathered;
import io.github.lumbre.integrator.PathVertex.Meeting;
import io.github.lumbre.integrator.PathVertex.Scattering;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.parser.Origin;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scene.RenderSettings;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The samples of a pixel, for programs to read. Numbers that JSON does not have are the texts
 * {@code Infinity}, {@code -Infinity} and {@code NaN}.
 */
final class PixelJson {
  /** What tells such a text from others; it changes when older readers would misunderstand. */
  static final String FORMAT = "lumbre-pixel-1";

  private static final Gson GSON = new GsonBuilder().setPrettyPrinting().create();

  private final PixelReport report;

  private PixelJson(PixelReport report) {
    this.report = report;
  }

  /** Returns one sample with its path. */
  static String text(PixelReport report, PixelReplay.Sample sample) {
    Map<String, Object> values = head(report);
    values.putAll(new PixelJson(report).sample(sample));
    return GSON.toJson(values);
  }

  /** Returns what all samples have in common, and the outstanding ones with their paths. */
  static String text(PixelReport report, PixelReplay.Pixel pixel) {
    PixelJson json = new PixelJson(report);
    Map<String, Object> values = head(report);
    values.put("samples", pixel.samples());
    values.put("mean", rgb(pixel.mean()));
    values.put("variance", rgb(pixel.variance()));
    values.put("rejected", pixel.rejected());
    values.put("first_rejected", pixel.firstRejected().stream().map(json::sample).toList());
    values.put("brightest", pixel.brightest().stream().map(json::sample).toList());
    return GSON.toJson(values);
  }

  private static Map<String, Object> head(PixelReport report) {
    RenderSettings settings = report.file().settings();
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("format", FORMAT);
    values.put("scene_sha256", report.file().hash());
    values.put("mode", FlagConverters.lower(settings.mode()));
    values.put("size", settings.width() + "x" + settings.height());
    values.put("seed", settings.seed());
    values.put("x", report.pixel().x());
    values.put("y", report.pixel().y());
    return values;
  }

  private Map<String, Object> sample(PixelReplay.Sample sample) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("sample", sample.number());
    values.put("radiance", rgb(sample.radiance()));
    values.put("film", rgb(sample.film()));
    values.put("is_rejected", sample.rejected());
    values.put("vertices", sample.vertices().stream().map(this::vertex).toList());
    return values;
  }

  private Map<String, Object> vertex(PathVertex vertex) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("origin", vector(vertex.ray().origin()));
    values.put("direction", vector(vertex.ray().direction()));
    values.put("throughput", rgb(vertex.throughput()));
    vertex.meeting().ifPresent(meeting -> values.put("meets", meeting(meeting)));
    values.put("light", vertex.gathered().stream().map(this::light).toList());
    vertex.scattering().ifPresent(scattering -> values.put("scatters", scattering(scattering)));
    values.put("end", FlagConverters.lower(vertex.end()));
    values.put("sum", rgb(vertex.sum()));
    return values;
  }

  private Map<String, Object> meeting(Meeting meeting) {
    Map<String, Object> values = new LinkedHashMap<>();
    put("object", report.file().origins().primitives().get(meeting.primitive()), values);
    put("material", report.file().origins().materials().get(meeting.primitive()), values);
    values.put("bsdf", meeting.bsdf());
    values.put("position", vector(meeting.position()));
    values.put("geometric_normal", vector(meeting.geometricNormal()));
    values.put("shading_normal", vector(meeting.shadingNormal()));
    return values;
  }

  private Map<String, Object> light(Gathered light) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("source", FlagConverters.lower(light.source()));
    if (light.emitter() >= 0) {
      put("emitter", report.file().origins().emitters().get(light.emitter()), values);
    }
    values.put("wi", vector(light.wi()));
    values.put("radiance", rgb(light.radiance()));
    values.put("f", rgb(light.f()));
    values.put("light_pdf", number(light.lightPdf()));
    values.put("bsdf_pdf", number(light.bsdfPdf()));
    values.put("mis_weight", number(light.weight()));
    values.put("is_blocked", light.blocked());
    values.put("contribution", rgb(light.contribution()));
    return values;
  }

  private static Map<String, Object> scattering(Scattering scattering) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("wi", vector(scattering.wi()));
    values.put("weight", rgb(scattering.weight()));
    values.put("pdf", number(scattering.pdf()));
    values.put("survival", number(scattering.survival()));
    return values;
  }

  private static void put(String key, Origin origin, Map<String, Object> values) {
    values.put(key + "_path", origin.path());
    values.put(key + "_name", origin.name());
  }

  private static List<Object> rgb(Rgb colour) {
    return List.of(number(colour.r()), number(colour.g()), number(colour.b()));
  }

  private static List<Object> vector(Vec3 vector) {
    return List.of(number(vector.x()), number(vector.y()), number(vector.z()));
  }

  private static Object number(double value) {
    return Double.isFinite(value) ? (Object) value : String.valueOf(value);
  }
}
