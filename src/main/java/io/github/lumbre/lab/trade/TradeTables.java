package io.github.lumbre.lab.trade;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import io.github.lumbre.lab.Table;
import io.github.lumbre.scene.SettingType;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

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
          .text("cpu_seconds_of_seeds", row -> row.each(shot -> shot.cost().cpuSeconds()))
          .text("flip", TradeRow::flip)
          .text("signed_error", TradeRow::signedError)
          .text("squared_bias", TradeRow::bias)
          .text("errors", row -> row.seeds().stream().map(shot -> shot.error().byName()).toList());

  private static final Table<ExactRow> EXACT =
      Table.<ExactRow>empty()
          .text("setting", ExactRow::setting)
          .number("time_ratio", ExactRow::timeRatio)
          .number("cpu_ratio", ExactRow::cpuRatio)
          .text("same_picture", ExactRow::isSamePicture);

  private TradeTables() {}

  /** Returns a line for each seed of each setting at each number of samples. */
  public static String csv(TradeResult result) {
    List<TradeShot> shots = result.rows().stream().flatMap(row -> row.seeds().stream()).toList();
    Table<TradeShot> table =
        Table.<TradeShot>empty()
            .text("knob", shot -> SettingType.nameOf(shot.setting().knob()))
            .text("value", shot -> shot.setting().value())
            .text("kind", shot -> SettingType.nameOf(shot.setting().kind()))
            .number("samples", TradeShot::samples)
            .number("seed", TradeShot::seed)
            .number("seconds", shot -> shot.cost().seconds())
            .number("cpu_seconds", shot -> shot.cost().cpuSeconds());
    for (String name : shots.get(0).error().byName().keySet()) {
      table = table.number(name, shot -> shot.error().byName().get(name));
    }
    return table.csv(shots);
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
