package io.github.lumbre.lab.report;

import io.github.lumbre.lab.Csv;
import io.github.lumbre.lab.Release;
import io.github.lumbre.lab.perf.Hardware;
import io.github.lumbre.scene.SettingType;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Formats the report's table with this machine's times as comma-separated values. */
public final class BenchmarkCsv {
  private final Hardware hardware;
  private final BenchmarkPlan plan;

  public BenchmarkCsv(Hardware hardware, BenchmarkPlan plan) {
    this.hardware = hardware;
    this.plan = plan;
  }

  /** Returns the file's text: a line of names and a line for each row; empty without rows. */
  public String text(List<BenchmarkResult> results) {
    Stream<String> head = results.stream().limit(1).map(r -> Csv.line(names(r)));
    Stream<String> lines = results.stream().map(r -> Csv.line(List.copyOf(values(r).values())));
    return Stream.concat(head, lines).map(line -> line + "\n").collect(Collectors.joining());
  }

  private List<String> names(BenchmarkResult result) {
    return List.copyOf(values(result).keySet());
  }

  private Map<String, Object> values(BenchmarkResult result) {
    Map<String, Object> values = new LinkedHashMap<>();
    putWork(result, values);
    putTimes(result, values);
    values.put("report_threads", result.row().reportThreads());
    values.put("report_hardware", result.row().reportHardware());
    values.put("report_time", result.row().reportTime());
    values.put("image_sha256", result.imageHash());
    values.put("scene_sha256", result.sceneHash());
    values.put("version", Release.number());
    values.put("cpu", hardware.cpu());
    values.put("cores", hardware.cores());
    values.put("jvm", hardware.jvm());
    values.put("os", hardware.os());
    values.put("note", result.row().note());
    return values;
  }

  private void putWork(BenchmarkResult result, Map<String, Object> values) {
    ReportRow row = result.row();
    values.put("row", row.number());
    values.put("name", row.name());
    values.put("scene", row.scene());
    values.put("size", row.size());
    values.put("mode", SettingType.nameOf(row.mode()));
    values.put("samples", result.samples());
    values.put("all_samples", row.samples());
    values.put("threads", result.threads());
    values.put("bucket", row.bucket());
    values.put("depth", row.depth().isPresent() ? row.depth().getAsInt() : "");
    values.put("warmup", plan.warmup());
    values.put("repeat", plan.repeat());
  }

  private static void putTimes(BenchmarkResult result, Map<String, Object> values) {
    values.put("load_seconds", decimal(result.loadSeconds()));
    values.put("seconds", decimal(result.seconds()));
    values.put("all_seconds", decimal(result.allSeconds()));
    values.put("extrapolated", result.isExtrapolated());
    values.put("all_time", ReportTime.of(result.allSeconds()));
    values.put("samples_per_second", rate(result.statistics().samples(), result.seconds()));
    values.put("rays_per_second", rate(result.rays(), result.seconds()));
  }

  private static String decimal(double seconds) {
    return String.format(Locale.ROOT, "%.3f", seconds);
  }

  private static String rate(long count, double seconds) {
    return String.format(Locale.ROOT, "%.0f", seconds > 0 ? count / seconds : 0);
  }
}
