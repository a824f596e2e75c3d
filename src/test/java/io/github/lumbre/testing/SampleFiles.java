package io.github.lumbre.testing;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.stream.Stream;

/** Files of samples beside the tests that read them. */
public final class SampleFiles {
  private SampleFiles() {}

  /** Returns the content of a file in the package of a class. */
  public static byte[] bytes(Class<?> beside, String name) {
    try (InputStream in = beside.getResourceAsStream(name)) {
      return in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the cells of each line of a table, but for its head. */
  public static Stream<String[]> rows(Class<?> beside, String name) {
    return new String(bytes(beside, name), StandardCharsets.US_ASCII)
        .lines()
        .skip(1)
        .map(line -> line.split(","));
  }
}
