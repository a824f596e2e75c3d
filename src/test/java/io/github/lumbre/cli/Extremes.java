package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.OperatingSystemMXBean;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.testing.Effort;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Numbers that no one means, and what the program may answer to them. */
final class Extremes {
  /** Numbers around the limits of float and double, and what is no number. */
  static final List<String> VALUES =
      List.of(
          "1e-320",
          "-1e-320",
          "1e-160",
          "-1e-39",
          "1e39",
          "-1e155",
          "1e308",
          "-1.7e308",
          "1e400",
          "NaN",
          "Infinity",
          "-inf");

  /** Processor time, longer than any of the calls takes, unless something loops. */
  private static final double SECONDS = 2;

  /** The calls of one that is too slow, since other tests may run meanwhile. */
  private static final int TRIES = 4;

  private static final OperatingSystemMXBean PROCESS =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  private static final Set<Integer> ANSWERS =
      Set.of(
          ExitCodes.OK,
          ExitCodes.DIFFERENT,
          ExitCodes.USAGE,
          ExitCodes.SCENE,
          ExitCodes.ASSET,
          ExitCodes.LIMIT);

  /** The file or the program, a place in it and what is wrong there. */
  private static final Pattern LOCATED = Pattern.compile("[^ ]+: .*[^ ]+ [^ ]+ [^ ]+.*");

  private Extremes() {}

  /** Writes a file with a text, in which one number is replaced, and returns its path. */
  interface Written {
    Path with(String text) throws IOException;
  }

  /**
   * Replaces each number that a pattern finds in a text by values: by all in exhaustive tests, else
   * by one, which differs between numbers.
   */
  static List<String> variants(String text, Pattern numbers) {
    List<String> variants = new ArrayList<>();
    Matcher found = numbers.matcher(text);
    int step = Effort.isExhaustive() ? 1 : VALUES.size();
    for (int number = 0; found.find(); number++) {
      for (int i = number % step; i < VALUES.size(); i += step) {
        String value = VALUES.get(i);
        variants.add(text.substring(0, found.start()) + value + text.substring(found.end()));
      }
    }
    assertThat(variants).isNotEmpty();
    return variants;
  }

  /** Runs a command, which must end soon with a picture or with a refusal that states the place. */
  static void run(String... command) {
    String line = String.join(" ", command);
    for (int i = 1; ; i++) {
      long start = PROCESS.getProcessCpuTime();
      Outcome outcome = Outcome.of(command);
      double seconds = (PROCESS.getProcessCpuTime() - start) * 1e-9;
      assertThat(outcome.err()).as(line).doesNotContain("Exception", "internal error", "\tat ");
      assertThat(ANSWERS).as(line + "\n" + outcome.err()).contains(outcome.exitCode());
      if (outcome.exitCode() > ExitCodes.DIFFERENT) {
        assertThat(outcome.err().lines()).as(line).isNotEmpty().allMatch(Extremes::isLocated);
      }
      if (seconds < SECONDS) {
        return;
      }
      assertThat(i).as("%s: takes %.1f s", line, seconds).isLessThan(TRIES);
    }
  }

  private static boolean isLocated(String message) {
    return message.startsWith("warning: ")
        || message.startsWith("hint: ")
        || LOCATED.matcher(message).matches();
  }
}
