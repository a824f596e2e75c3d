package io.github.lumbre.lab.trade;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import io.github.lumbre.compare.PictureError;
import io.github.lumbre.lab.Csv;
import io.github.lumbre.scene.SettingType;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Formats the results of a study as CSV and JSON, with each seed of each setting. */
public final class TradeTables {
  /** The JSON format's identifier; it changes with every incompatible change of the format. */
  public static final String FORMAT = "lumbre-trade-2";

  private static final Gson GSON =
      new GsonBuilder().setPrettyPrinting().serializeSpecialFloatingPointValues().create();

  private TradeTables() {}

  /** Returns a line for each seed of each setting at each number of samples. */
  public static String csv(TradeResult result) {
    List<String> lines = new ArrayList<>();
    List<Object> head =
        new ArrayList<>(
            List.of("knob", "value", "kind", "samples", "seed", "seconds", "cpu_seconds"));
    head.addAll(result.rows().get(0).errors().get(0).byName().keySet());
    lines.add(Csv.line(head));
    for (TradeRow row : result.rows()) {
      for (int seed = 0; seed < row.errors().size(); seed++) {
        List<Object> values =
            new ArrayList<>(
                List.of(
                    row.setting().knob(),
                    row.setting().value(),
                    SettingType.nameOf(row.setting().kind()),
                    row.samples(),
                    seed + 1,
                    row.seconds().get(seed),
                    row.cpuSeconds().get(seed)));
        values.addAll(row.errors().get(seed).byName().values());
        lines.add(Csv.line(values));
      }
    }
    return String.join("\n", lines) + "\n";
  }

  /** Returns the whole study as a JSON object. */
  public static String json(Map<String, String> facts, TradeResult result) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("format", FORMAT);
    values.put("facts", facts);
    values.put("reference_samples", result.referenceSamples());
    values.put("reference_noise", result.referenceNoise());
    values.put("rows", result.rows().stream().map(TradeTables::row).toList());
    values.put("exact", result.exact().stream().map(TradeTables::exact).toList());
    return GSON.toJson(values) + "\n";
  }

  private static Map<String, Object> row(TradeRow row) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("knob", row.setting().knob());
    values.put("value", row.setting().value());
    values.put("samples", row.samples());
    values.put("kind", SettingType.nameOf(row.setting().kind()));
    values.put("rays_per_sample", row.work().rays());
    values.put("shadow_rays_per_sample", row.work().shadowRays());
    values.put("nodes_per_sample", row.work().nodes());
    values.put("texture_look_ups_per_sample", row.work().lookUps());
    values.put("pixels", row.picture().width() * row.picture().height());
    values.put("relative_mse", row.relativeMse());
    values.put("seconds", row.time());
    values.put("cpu_seconds", row.cpuTime());
    values.put("cpu_seconds_of_seeds", row.cpuSeconds());
    values.put("flip", row.flip());
    values.put("signed_error", row.signedError());
    values.put("squared_bias", row.bias());
    values.put("errors", row.errors().stream().map(PictureError::byName).toList());
    return values;
  }

  private static Map<String, Object> exact(ExactRow row) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("setting", row.setting());
    row.timeRatio().ifPresent(ratio -> values.put("time_ratio", ratio));
    row.cpuRatio().ifPresent(ratio -> values.put("cpu_ratio", ratio));
    values.put("same_picture", row.isSamePicture());
    return values;
  }
}
