package io.github.lumbre.lab.trade;

/** A parameter that a study varies. */
public enum Knob {
  SAMPLER("Sampler: Sobol points or independent", "%s samples"),
  LIGHTS("Light selection", "light selection: %s"),
  STRATEGY("Sampling technique: MIS or a single one", "MIS: %s heuristic"),
  ROULETTE("Russian roulette: first vertex", "Russian roulette from vertex %s"),
  SPLIT("Path splitting: number of branches", "path split into %s"),
  DEPTH("Depth: scattering vertices of a path", "depth %s"),
  MODE("Classic ray tracing", "%s tracing"),
  FILTER("Other texture filters than the scene's", "texture filter: %s"),
  CLAMP("Clamping", "samples clamped to %s"),
  ADAPTIVE("Adaptive sampling", "adaptive sampling"),
  DENOISE("Denoising", "denoised (%s)");

  private final String title;
  private final String label;

  Knob(String title, String label) {
    this.title = title;
    this.label = label;
  }

  /** Returns the title of the parameter's chart. */
  String title() {
    return title;
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
