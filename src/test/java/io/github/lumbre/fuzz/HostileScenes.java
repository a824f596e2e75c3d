package io.github.lumbre.fuzz;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;

/**
 * Hostile scenes that try to break the program, each a function of a seed. Their folder holds files
 * that they may read; files outside are forbidden. Thread-safe.
 */
public final class HostileScenes {
  static final String INSIDE_PICTURE = "inside.png";
  static final String INSIDE_MESH = "inside.obj";

  private static final int MOST_PIXELS = 48;
  private static final int LONGEST_LINE = 2000;
  private static final List<String> SEEDS =
      List.of("thin-lens", "pinhole", "fish-eye", "cylindrical", "spherical");
  private static final String MESH = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

  private final Path folder;
  private final List<JsonObject> seeds = new ArrayList<>();
  private final Vocabulary vocabulary;
  private final List<byte[]> readable = new ArrayList<>();

  /**
   * The result of a scene.
   *
   * @param exitCode the exit code of the command line: 0, 3, 4 or 5
   * @param rejected the number of rejected samples (negative, NaN or infinite)
   */
  public record Ending(int exitCode, long rejected) {}

  /** Creates a folder below the given one. */
  public HostileScenes(Path around) {
    folder = around.resolve("scenes");
    try {
      prepare(around);
      for (String name : SEEDS) {
        seeds.add(sound(name));
      }
      vocabulary = Vocabulary.of(seeds);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void prepare(Path around) throws IOException {
    Files.createDirectories(folder);
    byte[] picture = PictureMutator.sound();
    byte[] mesh = MESH.getBytes(StandardCharsets.US_ASCII);
    Files.write(folder.resolve(INSIDE_PICTURE), picture);
    Files.write(folder.resolve(INSIDE_MESH), mesh);
    Files.write(around.resolve("outside.png"), picture);
    Files.write(around.resolve("outside.obj"), mesh);
    readable.add(picture);
    readable.add(mesh);
    try {
      Files.createSymbolicLink(folder.resolve("link.png"), around.resolve("outside.png"));
      Files.createSymbolicLink(folder.resolve("linked"), around);
    } catch (IOException | UnsupportedOperationException e) {
      // Some systems have no links, so there is nothing to test.
      return;
    }
  }

  private static JsonObject sound(String name) throws IOException {
    try (InputStream in = HostileScenes.class.getResourceAsStream(name + ".json")) {
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return JsonParser.parseString(text).getAsJsonObject();
    }
  }

  /** Returns the text of the scene of a seed. */
  public byte[] text(long seed) {
    return new SceneMutator(seeds, vocabulary, new Random(seed)).next();
  }

  /** Writes the scene of a seed into the folder; the caller may delete it. */
  public Path write(long seed, byte[] text) {
    try {
      return Files.write(folder.resolve(seed + ".json"), text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Reads the scene of a seed and renders a few pixels of it.
   *
   * @throws AssertionError if the ending is not allowed
   */
  public Ending run(long seed) {
    byte[] text = text(seed);
    Path file = write(seed, text);
    try {
      return judged(file, text);
    } catch (IOException | InterruptedException | RuntimeException | Error e) {
      throw new AssertionError("seed " + seed + ": " + new String(text, StandardCharsets.UTF_8), e);
    } finally {
      delete(file);
    }
  }

  private static void delete(Path file) {
    try {
      Files.delete(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Ending judged(Path file, byte[] text) throws IOException, InterruptedException {
    SceneFile scene;
    try {
      scene = new SceneParser().overriding(HostileScenes::quick).parse(file);
    } catch (SceneFormatException e) {
      require(!e.problems().isEmpty() && e.problems().size() <= 20, "number of problems");
      e.problems().forEach(problem -> requireTellable(problem.toString()));
      return new Ending(exitCode(e.kind()), 0);
    }
    scene.warnings().forEach(warning -> requireTellable(warning.toString()));
    require(hashes(text).contains(scene.hash()), "a file outside the folder was read");
    RenderResult result =
        new PictureRenderer(scene.settings()).render(scene.scene(), Progress.NONE);
    requireFinite(result.image());
    return new Ending(0, result.statistics().rejected());
  }

  /** Returns settings for a very short render; other settings are those of the file. */
  private static RenderSettings quick(RenderSettings settings) {
    RenderSettings.Builder builder = settings.toBuilder();
    if ((long) settings.width() * settings.height() > MOST_PIXELS) {
      builder.size(8, 6);
    }
    return builder
        .samples(Math.min(2, settings.samples()))
        .threads(1)
        .maxTraceDepth(Math.min(12, settings.maxTraceDepth()))
        .rayDepths(
            Math.min(6, settings.reflectionTraceDepth()),
            Math.min(6, settings.refractionTraceDepth()))
        .build();
  }

  private static int exitCode(SceneFormatException.Kind kind) {
    return switch (kind) {
      case INVALID -> 3;
      case ASSET -> 4;
      case LIMIT -> 5;
      case OPTION -> 2;
    };
  }

  private static void requireTellable(String line) {
    require(line.contains(".json: "), "no file in: " + line);
    require(line.length() <= LONGEST_LINE, "too long: " + line);
    require(!line.contains("Exception") && !line.contains("java."), "not for people: " + line);
    require(line.codePoints().noneMatch(Character::isISOControl), "controls terminals: " + line);
  }

  /** Returns the possible hashes of a scene that has read none, one or all of its allowed files. */
  private Set<String> hashes(byte[] text) {
    Set<String> hashes = new TreeSet<>();
    hashes.add(hash(text));
    for (byte[] one : readable) {
      hashes.add(hash(text, one));
      readable.forEach(other -> hashes.add(hash(text, one, other)));
    }
    return hashes;
  }

  private static String hash(byte[]... parts) {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      for (byte[] part : parts) {
        digest.update(part);
      }
      return HexFormat.of().formatHex(digest.digest());
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every Java has SHA-256", e);
    }
  }

  private static void requireFinite(Image image) {
    for (int y = 0; y < image.height(); y++) {
      for (int x = 0; x < image.width(); x++) {
        Rgb pixel = image.pixel(x, y);
        require(
            pixel.isFinite() && pixel.r() >= 0 && pixel.g() >= 0 && pixel.b() >= 0,
            "pixel " + x + "," + y + " is " + pixel);
      }
    }
  }

  private static void require(boolean condition, String otherwise) {
    if (!condition) {
      throw new AssertionError(otherwise);
    }
  }
}
