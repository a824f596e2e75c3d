package io.github.lumbre.cli.option;

import io.github.lumbre.base.text.Numbers;
import java.util.Map;

/**
 * One of the equal shares into which a job array divides the samples or the frames of a render.
 *
 * @param index of the share, from 0
 * @param count number of shares, at least 1
 */
record Share(int index, int count) {
  /** The variable that states the number of shares beside {@code JOB_COMPLETION_INDEX}. */
  static final String COUNT = "LUMBRE_SHARES";

  private static final int MOST = 1 << 20;

  Share {
    if (count < 1 || count > MOST) {
      throw new IllegalArgumentException("expected 1 to " + MOST + " shares, found " + count);
    }
    if (index < 0 || index >= count) {
      throw new IllegalArgumentException(
          "expected a share from 0 to " + (count - 1) + ", found " + index);
    }
  }

  /**
   * Returns the share that a text names: {@code I/N}, or {@code auto} for the share of this process
   * in a job array of Kubernetes, Slurm or AWS Batch.
   *
   * @param environment the variables of the process
   * @throws IllegalArgumentException if there is none
   */
  static Share parse(String text, Map<String, String> environment) {
    if (text.equals("auto")) {
      return auto(environment);
    }
    String[] parts = text.split("/", -1);
    if (parts.length != 2) {
      throw new IllegalArgumentException("expected I/N, such as 0/8, or auto, found " + text);
    }
    return new Share(number(parts[0], "I/N"), number(parts[1], "I/N"));
  }

  private static Share auto(Map<String, String> environment) {
    if (environment.containsKey("SLURM_ARRAY_TASK_ID")) {
      int id = of(environment, "SLURM_ARRAY_TASK_ID");
      int low = of(environment, "SLURM_ARRAY_TASK_MIN");
      int step = environment.containsKey("SLURM_ARRAY_TASK_STEP") ? step(environment) : 1;
      return new Share((id - low) / step, of(environment, "SLURM_ARRAY_TASK_COUNT"));
    }
    if (environment.containsKey("AWS_BATCH_JOB_ARRAY_INDEX")) {
      return new Share(
          of(environment, "AWS_BATCH_JOB_ARRAY_INDEX"),
          of(environment, "AWS_BATCH_JOB_ARRAY_SIZE"));
    }
    if (environment.containsKey("JOB_COMPLETION_INDEX")) {
      return new Share(of(environment, "JOB_COMPLETION_INDEX"), of(environment, COUNT));
    }
    throw new IllegalArgumentException(
        "auto: expected one of the variables JOB_COMPLETION_INDEX (with "
            + COUNT
            + "), SLURM_ARRAY_TASK_ID and AWS_BATCH_JOB_ARRAY_INDEX, found none;"
            + " give the share as I/N");
  }

  private static int step(Map<String, String> environment) {
    return Math.max(1, of(environment, "SLURM_ARRAY_TASK_STEP"));
  }

  private static int of(Map<String, String> environment, String name) {
    String value = environment.get(name);
    if (value == null) {
      throw new IllegalArgumentException("auto: expected the variable " + name + ", found none");
    }
    return number(value, "auto: " + name);
  }

  private static int number(String text, String what) {
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(what + ": expected an integer, found " + text, e);
    }
  }

  /**
   * Returns the number of things before this share.
   *
   * @param all number of the things of all shares together
   * @param thing their name, such as "sample"
   * @throws IllegalArgumentException if there are fewer things than shares
   */
  int first(int all, String thing) {
    if (all < count) {
      throw new IllegalArgumentException(
          "expected at least one %s for each share, found %s and %s shares"
              .formatted(thing, Numbers.count(all, thing), count));
    }
    return (int) ((long) all * index / count);
  }

  /** Returns the number of things before the next share; see {@link #first}. */
  int end(int all) {
    return (int) ((long) all * (index + 1) / count);
  }
}
