package io.github.lumbre.lab.perf;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import io.github.lumbre.lab.Release;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.SettingType;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Formats the measurements of scenes, with every repetition, as JSON. */
public final class PerfJson {
  /** The JSON format's identifier; it changes with every incompatible change of the format. */
  static final String FORMAT = "lumbre-bench-1";

  private static final Gson GSON = new GsonBuilder().setPrettyPrinting().create();

  private PerfJson() {}

  /** Returns the file's text. */
  public static String text(PerfMachine machine, PerfPlan plan, List<PerfResult> results) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("format", FORMAT);
    values.put("version", Release.number());
    values.put("machine", machine(machine));
    values.put("warmup", plan.warmup());
    values.put("repeat", plan.repeat());
    values.put("pairs", plan.pairs());
    values.put("results", results.stream().map(PerfJson::result).toList());
    return GSON.toJson(values) + "\n";
  }

  private static Map<String, Object> machine(PerfMachine machine) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("cpu", machine.hardware().cpu());
    values.put("cores", machine.hardware().cores());
    values.put("jvm", machine.hardware().jvm());
    values.put("jvm_options", machine.options());
    values.put("max_heap_bytes", machine.maxHeapBytes());
    values.put("collectors", machine.collectors());
    values.put("os", machine.hardware().os());
    values.put("load_before", machine.load());
    return values;
  }

  private static Map<String, Object> result(PerfResult result) {
    Map<String, Object> values = new LinkedHashMap<>();
    putWork(result, values);
    values.put("load_seconds", result.loadSeconds());
    values.put("warmup_seconds", result.warmUp().seconds());
    values.put("warm_seconds", result.warmUp().warmSeconds());
    values.put("repetitions", result.repetitions().stream().map(PerfJson::repetition).toList());
    values.put("relative_mse", result.noise().relativeMses());
    values.put("seconds_to_relative_mse_0.01", result.secondsToTarget());
    values.put("image_sha256", result.imageHash());
    return values;
  }

  private static void putWork(PerfResult result, Map<String, Object> values) {
    RenderSettings settings = result.settings();
    RenderStatistics statistics = result.statistics();
    values.put("scene", result.scene());
    values.put("scene_sha256", result.sceneHash());
    values.put("size", settings.width() + "x" + settings.height());
    values.put("mode", SettingType.nameOf(settings.mode()));
    values.put("samples", settings.samples());
    values.put("seed", settings.seed());
    values.put("bucket", settings.bucketSize());
    values.put("threads", settings.threads());
    values.put("camera_samples", statistics.samples());
    values.put("rays", statistics.rays());
    values.put("shadow_rays", statistics.shadowRays());
    values.put("rejected", statistics.rejected());
  }

  private static Map<String, Object> repetition(PerfResult.Repetition repetition) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("seconds", repetition.seconds());
    values.put("cpu_seconds", repetition.cpuSeconds());
    values.put("allocated_bytes", repetition.allocatedBytes());
    return values;
  }
}
