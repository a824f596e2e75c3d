package io.github.lumbre.testing;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Collects the measurements of exhaustive tests: the number and the largest value of each figure.
 * The end of the run writes them to {@code target/exhaustive-figures.txt}; quick builds write
 * nothing. Thread-safe.
 */
public final class Figures {
  private static final Path FILE = Path.of("target", "exhaustive-figures.txt");
  private static final Map<String, Figure> FIGURES = new TreeMap<>();

  private record Figure(long tries, double worst) {
    Figure plus(Figure o) {
      return new Figure(tries + o.tries, Math.max(worst, o.worst));
    }

    Figure sum(Figure o) {
      return new Figure(tries + o.tries, worst + o.worst);
    }
  }

  static {
    if (Effort.isExhaustive()) {
      Runtime.getRuntime().addShutdownHook(new Thread(Figures::write));
    }
  }

  private Figures() {}

  /** Records one measurement of a figure whose largest value is reported. */
  public static void worst(String what, double figure) {
    worst(what, 1, figure);
  }

  /** Records the largest of the given number of measurements. */
  public static synchronized void worst(String what, long tries, double figure) {
    FIGURES.merge(what + ": worst", new Figure(tries, figure), Figure::plus);
  }

  /** Adds a number of tries and of failures to the totals. */
  public static synchronized void failures(String what, long tries, long failures) {
    FIGURES.merge(what + ": failures", new Figure(tries, failures), Figure::sum);
  }

  private static synchronized void write() {
    String lines =
        FIGURES.entrySet().stream()
            .map(
                e ->
                    String.format(
                        Locale.ROOT,
                        "%s %.4g of %d%n",
                        e.getKey(),
                        e.getValue().worst,
                        e.getValue().tries))
            .collect(Collectors.joining());
    try {
      if (!FIGURES.isEmpty()) {
        Files.writeString(FILE, lines);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
