package io.github.lumbre.lab.trade;

/** A parameter that a study varies. */
public enum Knob {
  SAMPLER("%s samples"),
  LIGHTS("light selection: %s"),
  STRATEGY("MIS: %s heuristic"),
  ROULETTE("Russian roulette from vertex %s"),
  SPLIT("path split into %s"),
  DEPTH("depth %s"),
  MODE("%s tracing"),
  FILTER("texture filter: %s"),
  CLAMP("samples clamped to %s"),
  ADAPTIVE("adaptive sampling"),
  DENOISE("denoised (%s)");

  private final String label;

  Knob(String label) {
    this.label = label;
  }

  /** Returns the display name of a value. */
  String label(String value) {
    return switch (value) {
      case "light" -> "light sampling only";
      case "bsdf" -> "BSDF sampling only";
      default -> label.formatted(value.replace("from ", ""));
    };
  }
}
