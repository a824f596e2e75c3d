package io.github.lumbre.lab.trade;

import com.google.gson.annotations.SerializedName;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** A study's JSON file written by {@link TradeTables#json}; Gson fills the fields. */
public final class TradeFile {
  public String format = "";
  private Map<String, String> facts = Map.of();

  @SerializedName("reference_samples")
  private int referenceSamples;

  @SerializedName("reference_noise")
  private Noise referenceNoise = new Noise();

  private List<Row> rows = List.of();

  private static final class Noise {
    private double relativeMse;
  }

  private static final class Row {
    private String knob = "";
    private String value = "";
    private String kind = "";
    private int samples;

    @SerializedName("rays_per_sample")
    private double rays;

    @SerializedName("shadow_rays_per_sample")
    private double shadowRays;

    @SerializedName("nodes_per_sample")
    private double nodes;

    @SerializedName("texture_look_ups_per_sample")
    private double lookUps;

    @SerializedName("cpu_seconds_of_seeds")
    private List<Double> cpuSeconds = List.of();

    @SerializedName("squared_bias")
    private Bias bias = new Bias();

    private List<Map<String, Double>> errors = List.of();

    SceneTrade.Row row() {
      List<Double> relativeMse = errors.stream().map(e -> e.get("relmse")).toList();
      return new SceneTrade.Row(
          knob,
          value,
          "noise".equals(kind),
          new TimeToError.Cost(samples, relativeMse, cpuSeconds),
          new TradeWork(rays, shadowRays, nodes, lookUps),
          new TradeRow.Bias(bias.squared, bias.low, bias.high));
    }
  }

  private static final class Bias {
    private double squared;
    private double low;
    private double high;
  }

  /** Returns the data that the tables need. */
  public SceneTrade trade() {
    String[] size = facts.getOrDefault("size", "1x1").split("x");
    List<SceneTrade.Row> all = new ArrayList<>();
    rows.forEach(row -> all.add(row.row()));
    return new SceneTrade(
        facts.getOrDefault("scene", "").replaceAll("\\.json$", ""),
        Integer.parseInt(size[0]),
        Integer.parseInt(size[1]),
        all.get(0).cost().relativeMse().size(),
        referenceSamples,
        Math.sqrt(referenceNoise.relativeMse),
        facts,
        all);
  }
}
