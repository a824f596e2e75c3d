package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.ByteArrayInputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.stream.Stream;

/** The exit code and the output of a run of the command line. */
public record Outcome(int exitCode, String out, String err) {
  /** Runs the command line in this JVM, with nothing on standard input. */
  public static Outcome of(String... args) {
    return onStandardInput(new byte[0], args);
  }

  /** Runs the command line in this JVM. */
  static Outcome onStandardInput(byte[] input, String... args) {
    // Standard input of a JVM of tests is the channel of the build and never ends.
    System.setIn(new ByteArrayInputStream(input));
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int exitCode = Lumbre.run(args, new PrintWriter(out, true), new PrintWriter(err, true));
    return new Outcome(exitCode, out.toString(), err.toString());
  }

  /** Runs a command line in which T stands for a folder. */
  static Outcome in(Path folder, String line) {
    return of(words(folder, line));
  }

  /** Returns the words of a command line in which T stands for a folder. */
  static String[] words(Path folder, String line) {
    return Stream.of(line.split(" "))
        .map(word -> word.matches("T(/.*)?") ? folder + word.substring(1) : word)
        .toArray(String[]::new);
  }

  /** Checks that the run succeeded. */
  public Outcome done() {
    assertThat(exitCode).as(err).isZero();
    return this;
  }

  /** Returns the object that is the whole standard output. */
  public JsonObject json() {
    return JsonParser.parseString(out).getAsJsonObject();
  }

  /** Checks that the run failed with this code and a single line that contains these texts. */
  public void assertFailed(int code, String... parts) {
    assertThat(err).contains(parts).doesNotContain("Exception", "\tat ");
    assertThat(err.lines()).hasSize(1);
    assertThat(out).isEmpty();
    assertThat(exitCode).isEqualTo(code);
  }
}
