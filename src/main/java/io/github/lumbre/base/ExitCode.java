package io.github.lumbre.base;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/** The reasons for which the program ends; several have the same number. */
public enum ExitCode {
  OK(0, "done"),
  PARTIAL(0, "stopped by --timeout with a partial picture"),
  WARNINGS(1, "there are warnings under --strict"),
  DIFFERENT(1, "something differs"),
  TARGET(1, "the target error is not reached"),
  USAGE(2, "the command line is invalid"),
  ABSENT(2, "it names something that does not exist"),
  SCENE(3, "the scene or model is missing, unreadable or invalid"),
  FILM(3, "the checkpoint file is missing, damaged or of another scene"),
  ASSET(4, "a mesh or picture cannot be decoded"),
  LIMIT(5, "a limit or the available memory is exceeded"),
  LATE(5, "--timeout ended before a picture was begun"),
  OUTPUT(6, "an output file cannot be written"),
  DENOISER(6, "the denoiser failed"),
  PORT(6, "the port is in use"),
  INTERNAL(7, "internal error"),
  REJECTED(7, "samples are rejected under --strict"),
  HUNG_UP(129, Meaning.STOPPED),
  INTERRUPTED(130, Meaning.STOPPED),
  TERMINATED(143, Meaning.STOPPED),
  SAVED(130, Meaning.STOPPED + "; results so far are saved");

  private static final class Meaning {
    static final String STOPPED = "stopped by SIGHUP, SIGINT (Ctrl-C), SIGTERM";
  }

  private final int number;
  private final String meaning;

  ExitCode(int number, String meaning) {
    this.number = number;
    this.meaning = meaning;
  }

  /** Returns the number that the program exits with. */
  public int number() {
    return number;
  }

  /** Returns the code with the larger number. */
  public ExitCode or(ExitCode other) {
    return other.number > number ? other : this;
  }

  /** Returns whether the command failed, and not only a condition is not met. */
  public boolean isFailure() {
    return number > WARNINGS.number;
  }

  /** Returns an exception for this reason; see {@link TaskException}. */
  public TaskException failure(String message) {
    return new TaskException(this, message);
  }

  /** Returns an exception for this reason, with its cause. */
  public TaskException failure(String message, Throwable cause) {
    return new TaskException(this, message, cause);
  }

  /**
   * Returns the meanings of codes by number, in sentences for people.
   *
   * @param codes in the order of this type
   * @param different what {@link #DIFFERENT} means; empty for its own meaning
   */
  public static Map<String, String> meanings(Set<ExitCode> codes, String different) {
    Map<String, Set<String>> reasons = new LinkedHashMap<>();
    for (ExitCode code : codes) {
      String number = code.number >= HUNG_UP.number ? "129, 130, 143" : "" + code.number;
      String meaning = code == DIFFERENT && !different.isEmpty() ? different : code.meaning;
      reasons.computeIfAbsent(number, n -> new LinkedHashSet<>()).add(meaning);
    }
    Map<String, String> sentences = new LinkedHashMap<>();
    reasons.forEach(
        (number, all) -> {
          String text = String.join(", or ", all);
          sentences.put(number, Character.toUpperCase(text.charAt(0)) + text.substring(1));
        });
    return sentences;
  }
}
