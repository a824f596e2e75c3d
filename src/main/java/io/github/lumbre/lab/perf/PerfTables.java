package io.github.lumbre.lab.perf;

import com.google.gson.FieldNamingPolicy;
import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import io.github.lumbre.base.Release;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.lab.Machine;
import io.github.lumbre.lab.Table;
import io.github.lumbre.scene.SettingType;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;

/** Formats the measurements of scenes: a Markdown table, and JSON with every repetition. */
public record PerfTables(Machine machine, PerfPlan plan) {
  /** The JSON format's identifier; it changes with every incompatible change of the format. */
  static final String FORMAT = "lumbre-bench-1";

  private static final Gson GSON =
      new GsonBuilder()
          .setPrettyPrinting()
          .setFieldNamingPolicy(FieldNamingPolicy.LOWER_CASE_WITH_UNDERSCORES)
          .create();

  private static final Table<PerfResult> MARKDOWN =
      Table.<PerfResult>empty()
          .text("scene", of(Measurement::scene))
          .text("size", of(Measurement::size))
          .number("samples", of(m -> m.settings().samples()))
          .number("threads", of(m -> m.settings().threads()))
          .number("time", of(m -> format("%.3f s", m.seconds())))
          .number("CPU time", of(m -> format("%.3f s", m.cpuSeconds())))
          .number("samples/s", of(m -> Numbers.rate(m.statistics().samples(), m.seconds())))
          .number("rays/s", of(m -> Numbers.rate(m.rays(), m.seconds())))
          .number("rays/CPU s", of(m -> Numbers.rate(m.rays(), m.cpuSeconds())))
          .number("B/ray", of(m -> format("%.0f", m.bytesPerRay())))
          .number("warm-up", result -> result.warmUp().text())
          .number("relMSE", result -> format("%.3g", result.noise().relativeMse()))
          .number("relMSE x s", result -> format("%.3g", result.errorSeconds()))
          .number("to relMSE 0.01", result -> format("%.3g s", result.secondsToTarget()))
          .text("image", of(Measurement::image));

  private static final Table<PerfResult> JSON =
      Table.<PerfResult>empty()
          .text("scene", of(Measurement::scene))
          .text("scene_sha256", of(Measurement::sceneHash))
          .text("size", of(Measurement::size))
          .text("mode", of(m -> SettingType.nameOf(m.settings().mode())))
          .number("samples", of(m -> m.settings().samples()))
          .number("seed", of(m -> m.settings().seed()))
          .number("bucket", of(m -> m.settings().bucketSize()))
          .number("threads", of(m -> m.settings().threads()))
          .number("camera_samples", of(m -> m.statistics().samples()))
          .number("rays", of(m -> m.statistics().rays()))
          .number("shadow_rays", of(m -> m.statistics().shadowRays()))
          .number("rejected", of(m -> m.statistics().rejected()))
          .number("load_seconds", of(Measurement::loadSeconds))
          .text("warmup_seconds", result -> result.warmUp().seconds())
          .text("warm_seconds", result -> result.warmUp().warmSeconds())
          .text("repetitions", of(Measurement::repetitions))
          .text("relative_mse", result -> result.noise().relativeMses())
          .number("seconds_to_relative_mse_0.01", PerfResult::secondsToTarget)
          .text("image_sha256", of(Measurement::imageHash));

  /** Returns the caption and the header of the Markdown table. */
  public List<String> head() {
    return MARKDOWN.head(
        "Lumbre " + Release.number() + " on " + machine.line() + ".",
        machine.loadBefore() < 0
            ? "Load average before: unknown."
            : format("Load average before: %.2f (0 is ideal).", machine.loadBefore()),
        plan.sentences(),
        "Rays include shadow rays. Warm-up: the time until a render reaches 95 % of the final rate;"
            + " only the first scene starts with a cold JVM.",
        "relMSE: mean over pixels and channels of ((a - b)^2 / 2) / (m^2 + 0.01) for pictures a and"
            + " b of two seeds; m: mean of all pictures.",
        "To relMSE 0.01: time extrapolated with an error proportional to 1/samples.");
  }

  /** Returns the Markdown row of one result. */
  public String line(PerfResult result) {
    return MARKDOWN.line(result);
  }

  /** Returns the text of the JSON file. */
  public String json(List<PerfResult> results) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("format", FORMAT);
    values.put("version", Release.number());
    values.put("machine", machine);
    values.put("warmup", plan.warmup());
    values.put("repeat", plan.repeat());
    values.put("pairs", plan.pairs());
    values.put("results", JSON.members(results));
    return GSON.toJson(values) + "\n";
  }

  private static Function<PerfResult, Object> of(Function<Measurement, Object> value) {
    return result -> value.apply(result.renders());
  }

  private static String format(String form, double value) {
    return String.format(Locale.ROOT, form, value);
  }
}
