package io.github.lumbre.cli.option;

/** The headings of flags in help texts. */
public final class Headings {
  public static final String SCENE = "Scene";
  public static final String MODEL = "Model";
  static final String SEQUENCE = "Frames of a turntable or an animation";
  static final String FRAME = "Frame";
  static final String TRANSPORT = "Light transport";
  static final String SAMPLES = "Samples";
  static final String STOP = "When to stop";
  static final String PICTURE = "Picture";
  static final String CHECKPOINTS = "Checkpoints";
  static final String EXECUTION = "Execution";

  private Headings() {}
}
