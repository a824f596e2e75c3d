package io.github.lumbre.lab.trade;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import io.github.lumbre.compare.PictureError;
import io.github.lumbre.lab.Table;
import io.github.lumbre.scene.SettingType;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.IntStream;

/** Formats the results of a study as CSV and JSON, with each seed of each setting. */
public final class TradeTables {
  /** The JSON format's identifier; it changes with every incompatible change of the format. */
  public static final String FORMAT = "lumbre-trade-2";

  private static final Gson GSON =
      new GsonBuilder().setPrettyPrinting().serializeSpecialFloatingPointValues().create();

  private static final Table<TradeRow> JSON =
      Table.<TradeRow>empty()
          .text("knob", row -> SettingType.nameOf(row.setting().knob()))
          .text("value", row -> row.setting().value())
          .number("samples", TradeRow::samples)
          .text("kind", row -> SettingType.nameOf(row.setting().kind()))
          .number("rays_per_sample", row -> row.work().rays())
          .number("shadow_rays_per_sample", row -> row.work().shadowRays())
          .number("nodes_per_sample", row -> row.work().nodes())
          .number("texture_look_ups_per_sample", row -> row.work().lookUps())
          .number("pixels", row -> row.picture().width() * row.picture().height())
          .text("relative_mse", TradeRow::relativeMse)
          .text("seconds", TradeRow::time)
          .text("cpu_seconds", TradeRow::cpuTime)
          .text("cpu_seconds_of_seeds", TradeRow::cpuSeconds)
          .text("flip", TradeRow::flip)
          .text("signed_error", TradeRow::signedError)
          .text("squared_bias", TradeRow::bias)
          .text("errors", row -> row.errors().stream().map(PictureError::byName).toList());

  private static final Table<ExactRow> EXACT =
      Table.<ExactRow>empty()
          .text("setting", ExactRow::setting)
          .number("time_ratio", ExactRow::timeRatio)
          .number("cpu_ratio", ExactRow::cpuRatio)
          .text("same_picture", ExactRow::isSamePicture);

  private TradeTables() {}

  private record Seed(TradeRow row, int index) {}

  /** Returns a line for each seed of each setting at each number of samples. */
  public static String csv(TradeResult result) {
    Table<Seed> table =
        Table.<Seed>empty()
            .text("knob", seed -> SettingType.nameOf(seed.row.setting().knob()))
            .text("value", seed -> seed.row.setting().value())
            .text("kind", seed -> SettingType.nameOf(seed.row.setting().kind()))
            .number("samples", seed -> seed.row.samples())
            .number("seed", seed -> seed.index + 1)
            .number("seconds", seed -> seed.row.seconds().get(seed.index))
            .number("cpu_seconds", seed -> seed.row.cpuSeconds().get(seed.index));
    for (String name : result.rows().get(0).errors().get(0).byName().keySet()) {
      table = table.number(name, seed -> seed.row.errors().get(seed.index).byName().get(name));
    }
    return table.csv(
        result.rows().stream()
            .flatMap(row -> IntStream.range(0, row.errors().size()).mapToObj(i -> new Seed(row, i)))
            .toList());
  }

  /** Returns the whole study as a JSON object. */
  public static String json(Map<String, String> facts, TradeResult result) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("format", FORMAT);
    values.put("facts", facts);
    values.put("reference_samples", result.referenceSamples());
    values.put("reference_noise", result.referenceNoise());
    values.put("rows", JSON.members(result.rows()));
    values.put("exact", EXACT.members(result.exact()));
    return GSON.toJson(values) + "\n";
  }
}
