package io.github.lumbre.cli.output;

import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/** A step of a picture after its samples. A picture that lacks one is partial. */
public enum LaterStep {
  /** The noise is removed. */
  DENOISING("not denoised"),
  /** Lines and labels are drawn. */
  DRAWING("without lines and labels");

  private final String lack;

  LaterStep(String lack) {
    this.lack = lack;
  }

  /** Returns the name in JSON: {@code denoising}. */
  public String key() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Returns the samples of a picture and what it lacks: {@code 8 samples per pixel, not denoised}.
   *
   * @param samples such as {@code 8 samples per pixel}
   */
  public static String text(String samples, Set<LaterStep> missing) {
    String lacks = missing.stream().sorted().map(s -> ", " + s.lack).collect(Collectors.joining());
    return samples + lacks;
  }
}
