package io.github.lumbre.model.program;

import io.github.lumbre.base.file.ExternalProgram;
import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.file.PrivateFolder;
import io.github.lumbre.math.internal.Sha256;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An installed program that converts a model into GLB. It starts in the folder of the model, gets
 * no input, and writes into a private folder; all of its processes end with it. It has the rights
 * of the user. Immutable.
 */
public final class ImportProgram {
  /** The names of programs whose arguments are known, for messages. */
  public static final String NAMES = KnownProgram.names();

  /** The most bytes that a program may write: what fits into a Java array. */
  private static final long MOST_BYTES = Integer.MAX_VALUE - 8L;

  private static final Duration MOST_TIME = Duration.ofMinutes(10);

  private static final String GLB = "glTF";

  /** Of a known program, whose path differs between machines; otherwise the path. */
  private final String name;

  private final ExternalProgram program;
  private final List<String> arguments;
  private final String script;
  private final long most;

  /**
   * A converted model.
   *
   * @param glb bytes of a file that begins as GLB; they may be anything else from there on
   * @param identity stands for the model in hashes: the template, and the hash of the source
   * @param hash SHA-256 of the GLB: a program may convert the same model differently
   */
  public record Imported(byte[] glb, byte[] identity, String hash) implements Serializable {
    public static Imported of(byte[] glb, byte[] identity) {
      return new Imported(glb, identity, Sha256.of(glb));
    }
  }

  private ImportProgram(
      String name, ExternalProgram program, List<String> arguments, String script, long most) {
    this.name = name;
    this.program = program;
    this.arguments = arguments;
    this.script = script;
    this.most = most;
  }

  /**
   * Returns the program that a text states.
   *
   * @param text {@code NAME} of a known program, {@code NAME=PATH}, or a template such as {@code
   *     /path/program {in} {out}}
   * @param environment has the path of a program that is named without one
   * @throws IllegalArgumentException if the text is none of them
   * @throws IOException if the program is not found
   */
  public static ImportProgram of(String text, Map<String, String> environment)
      throws IOException {
    int equals = text.indexOf('=');
    Optional<KnownProgram> known =
        KnownProgram.named(text.substring(0, equals < 0 ? text.length() : equals));
    if (known.isPresent()) {
      Optional<String> path =
          equals < 0 ? Optional.empty() : Optional.of(text.substring(equals + 1));
      if (path.filter(String::isBlank).isPresent()) {
        // An empty path would be the folder in which the command runs.
        throw new IllegalArgumentException("expected a path after " + text.strip());
      }
      return found(known.get(), path.map(Path::of), environment);
    }
    if (!text.strip().contains(" ") && !text.contains("/")) {
      throw new IllegalArgumentException(
          "expected one of " + NAMES + ", or '/path/program {in} {out}', found " + text);
    }
    Template template = Template.of(text);
    ExternalProgram program = new ExternalProgram(template.program(), MOST_TIME);
    String name = program.path().toString();
    return new ImportProgram(name, program, template.arguments(), "", MOST_BYTES);
  }

  private static ImportProgram found(
      KnownProgram known, Optional<Path> chosen, Map<String, String> environment)
      throws IOException {
    IOException failure = null;
    for (String file : known.files) {
      try {
        ExternalProgram program =
            ExternalProgram.find(file, chosen, known.variable(), environment, known.advice);
        return new ImportProgram(
            known.title(),
            program.within(MOST_TIME),
            known.arguments,
            known.script,
            MOST_BYTES);
      } catch (IOException e) {
        failure = failure == null ? e : failure;
      }
    }
    throw failure;
  }

  /** Returns the names of found programs that suit a file, by the ending of its name. */
  public static List<String> suiting(String file, Map<String, String> environment) {
    return KnownProgram.suiting(file).stream()
        .filter(each -> isFound(each, environment))
        .map(KnownProgram::title)
        .toList();
  }

  private static boolean isFound(KnownProgram known, Map<String, String> environment) {
    try {
      found(known, Optional.empty(), environment);
      return true;
    } catch (IOException | InvalidPathException e) {
      return false;
    }
  }

  /** Returns this program with other limits. */
  ImportProgram within(Duration time, long bytes) {
    return new ImportProgram(name, program.within(time), arguments, script, bytes);
  }

  /**
   * Converts a model.
   *
   * @throws ExternalProgram.LimitException if the program takes too long, or writes too much
   * @throws IOException if the source cannot be read, or the program fails or leaves no GLB; the
   *     message names the program
   * @throws InterruptedException if the thread is interrupted; the program is ended
   */
  public Imported run(Path source) throws IOException, InterruptedException {
    Path in = source.toRealPath();
    byte[] identity = identity(in);
    try (PrivateFolder folder = PrivateFolder.temporary()) {
      Path out = folder.path().resolve("model.glb");
      List<String> words = new ArrayList<>();
      for (String word : arguments) {
        words.add(
            switch (word) {
              case Template.IN -> in.toString();
              case Template.OUT -> out.toString();
              case Template.SCRIPT -> written(folder).toString();
              default -> word;
            });
      }
      String said = program.run(words, new ExternalProgram.Place(in.getParent(), folder, most));
      return Imported.of(read(out, said), identity);
    }
  }

  private byte[] identity(Path source) throws IOException {
    MessageDigest digest = Sha256.digest();
    try (InputStream in = new DigestInputStream(Files.newInputStream(source), digest)) {
      in.transferTo(OutputStream.nullOutputStream());
    }
    String template = name + "\n" + String.join("\n", arguments) + "\n" + script() + "\n";
    return (template + HexFormat.of().formatHex(digest.digest())).getBytes(StandardCharsets.UTF_8);
  }

  private Path written(PrivateFolder folder) throws IOException {
    return Files.writeString(folder.path().resolve(script), script());
  }

  /** Returns the text of the script; nothing if there is none. */
  private String script() throws IOException {
    if (script.isEmpty()) {
      return "";
    }
    try (InputStream in = ImportProgram.class.getResourceAsStream(script)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  /** Returns the bytes of the file that the program left. */
  private byte[] read(Path out, String said) throws IOException {
    long size;
    try {
      size = PrivateFolder.size(out);
    } catch (IOException e) {
      throw new IOException(
          program.path() + ": left no GLB: " + e.getMessage() + ExternalProgram.lastLines(said), e);
    }
    if (size > most) {
      throw program.excess(most);
    }
    byte[] bytes;
    try (InputStream in = Files.newInputStream(out, LinkOption.NOFOLLOW_LINKS)) {
      bytes = in.readNBytes((int) size);
    }
    if (!isGlb(bytes)) {
      String found =
          bytes.length == 0
              ? "an empty file"
              : FileContent.describe(bytes).orElse("another kind of file");
      throw new IOException(program.path() + ": left no GLB: " + found);
    }
    return bytes;
  }

  private static boolean isGlb(byte[] bytes) {
    byte[] start = Arrays.copyOf(bytes, Math.min(GLB.length(), bytes.length));
    return new String(start, StandardCharsets.ISO_8859_1).equals(GLB);
  }
}
