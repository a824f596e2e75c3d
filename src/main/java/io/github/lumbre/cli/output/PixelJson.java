package io.github.lumbre.cli.output;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.Contribution;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Hit;
import io.github.lumbre.integrator.path.PathVertex.Scattering;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scenefile.internal.Origin;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Formats the samples of a pixel as JSON. Numbers that JSON cannot represent are the strings {@code
 * Infinity}, {@code -Infinity} and {@code NaN}.
 */
public final class PixelJson {
  /** Identifies the format; it changes with every incompatible change. */
  public static final String FORMAT = "lumbre-pixel-2";

  private final PixelReport report;

  private PixelJson(PixelReport report) {
    this.report = report;
  }

  /** Returns one sample with its path. */
  public static String text(PixelReport report, PixelReplay.Sample sample) {
    Map<String, Object> values = head(report);
    values.putAll(new PixelJson(report).sample(sample));
    return JsonText.pretty(values);
  }

  /**
   * Returns the statistics of all samples, and the rejected and brightest samples with their paths.
   */
  public static String text(PixelReport report, PixelReplay.Pixel pixel) {
    return JsonText.pretty(values(report, pixel));
  }

  /** Returns the values of {@link #text(PixelReport, PixelReplay.Pixel)} by their keys. */
  public static Map<String, Object> values(PixelReport report, PixelReplay.Pixel pixel) {
    PixelJson json = new PixelJson(report);
    Map<String, Object> values = head(report);
    values.put("samples", pixel.samples());
    values.put("shows", report.seen(pixel).stream().map(PixelJson::seen).toList());
    values.put("mean", rgb(pixel.mean()));
    values.put("variance", rgb(pixel.variance()));
    values.put("rejected", pixel.rejected());
    values.put("first_rejected", pixel.firstRejected().stream().map(json::sample).toList());
    values.put("brightest", pixel.brightest().stream().map(json::sample).toList());
    return values;
  }

  private static Map<String, Object> seen(PixelReport.Seen seen) {
    Map<String, Object> values = new LinkedHashMap<>();
    put("object", seen.object(), values);
    put("material", seen.material(), values);
    values.put("samples", seen.samples());
    return values;
  }

  private static Map<String, Object> head(PixelReport report) {
    RenderSettings settings = report.file().settings();
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("format", FORMAT);
    values.put("scene_sha256", report.file().hash());
    values.put("mode", SettingType.nameOf(settings.mode()));
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
    values.put("is_clamped", sample.clamped());
    values.put("vertices", sample.vertices().stream().map(this::vertex).toList());
    return values;
  }

  private Map<String, Object> vertex(PathVertex vertex) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("branch", vertex.branch());
    values.put("origin", vector(vertex.ray().origin()));
    values.put("direction", vector(vertex.ray().direction()));
    values.put("throughput", rgb(vertex.throughput()));
    vertex.hit().ifPresent(hit -> values.put("hit", hit(hit)));
    values.put("contributions", vertex.contributions().stream().map(this::contribution).toList());
    values.put("scattered", vertex.scattered().stream().map(PixelJson::scattering).toList());
    values.put("end", SettingType.nameOf(vertex.end()));
    return values;
  }

  private Map<String, Object> hit(Hit hit) {
    Map<String, Object> values = new LinkedHashMap<>();
    put("object", report.origins().primitives().get(hit.primitive()), values);
    put("material", report.origins().materials().get(hit.primitive()), values);
    values.put("bsdf", hit.bsdf());
    values.put("position", vector(hit.position()));
    values.put("geometric_normal", vector(hit.geometricNormal()));
    values.put("shading_normal", vector(hit.shadingNormal()));
    return values;
  }

  private Map<String, Object> contribution(Contribution contribution) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("lights", contribution.lights().stream().map(this::light).toList());
    values.put("amount", rgb(contribution.amount()));
    return values;
  }

  private Map<String, Object> light(FoundLight light) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("source", SettingType.nameOf(light.source()));
    if (light.emitter() >= 0) {
      put("emitter", report.origins().emitters().get(light.emitter()), values);
    }
    values.put("wi", vector(light.wi()));
    values.put("radiance", rgb(light.radiance()));
    values.put("f", rgb(light.f()));
    values.put("light_pdf", number(light.lightPdf()));
    values.put("bsdf_pdf", number(light.bsdfPdf()));
    values.put("mis_weight", number(light.misWeight()));
    values.put("is_blocked", light.blocked());
    return values;
  }

  private static Map<String, Object> scattering(Scattering scattering) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("wi", vector(scattering.wi()));
    values.put("weight", rgb(scattering.weight()));
    values.put("pdf", number(scattering.pdf()));
    values.put("survival", number(scattering.survival()));
    values.put("survives", scattering.survives());
    return values;
  }

  private static void put(String key, Origin origin, Map<String, Object> values) {
    values.put(key + "_path", origin.path());
    values.put(key + "_name", origin.name());
  }

  private static List<Object> rgb(Rgb color) {
    return List.of(number(color.r()), number(color.g()), number(color.b()));
  }

  private static List<Object> vector(Vec3 vector) {
    return List.of(number(vector.x()), number(vector.y()), number(vector.z()));
  }

  private static Object number(double value) {
    return Double.isFinite(value) ? (Object) value : String.valueOf(value);
  }
}
