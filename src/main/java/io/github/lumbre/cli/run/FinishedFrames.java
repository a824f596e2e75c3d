package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.PictureTexts;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * The frames of a sequence that an earlier run has completed, recognized by the metadata in their
 * files. Mutable, for one thread.
 */
public final class FinishedFrames {
  private static final String NOTHING = "nothing";

  private final List<String> keywords;
  private final Set<Path> complete = new HashSet<>();
  private Optional<String> exposure = Optional.empty();

  /**
   * @param keywords of the metadata that must be the same
   */
  public FinishedFrames(Set<String> keywords) {
    List<String> ordered = new ArrayList<>(new TreeSet<>(keywords));
    ordered.remove(PictureMetadata.DENOISED);
    // Whatever changes a setting often changes the scene around a model, too, and another model is
    // converted into other bytes.
    for (String last : List.of(PictureMetadata.SCENE_HASH, PictureMetadata.CONVERTED_HASH)) {
      if (ordered.remove(last)) {
        ordered.add(last);
      }
    }
    this.keywords = List.copyOf(ordered);
  }

  /**
   * Adds a frame if its file is there and complete. A partial picture is as good as none.
   *
   * @param picture path of the file
   * @param expected metadata of the frame as it would be rendered now
   * @throws TaskException with {@link ExitCode#USAGE} if the file is something else
   */
  public void add(Path picture, Map<String, String> expected) throws TaskException {
    if (!Files.exists(picture)) {
      return;
    }
    if (!Files.isRegularFile(picture)) {
      // A pipe might wait for ever.
      throw refused(picture, "it is not a regular file");
    }
    Map<String, String> found = read(picture);
    if (found.containsKey(PictureMetadata.PARTIAL)) {
      return;
    }
    boolean isDenoised = found.containsKey(PictureMetadata.DENOISED);
    if (isDenoised != expected.containsKey(PictureMetadata.DENOISED)) {
      throw refused(picture, isDenoised ? "it is denoised" : "it is not denoised");
    }
    for (String keyword : keywords) {
      requireSame(picture, keyword, expected.get(keyword), found.get(keyword));
    }
    Optional<String> chosen = Optional.ofNullable(found.get(PictureMetadata.CHOSEN_EXPOSURE));
    if (exposure.isPresent()) {
      requireSame(picture, PictureMetadata.CHOSEN_EXPOSURE, exposure.get(), chosen.orElse(NOTHING));
    }
    exposure = exposure.or(() -> chosen);
    complete.add(picture);
  }

  private static Map<String, String> read(Path picture) throws TaskException {
    try {
      return PictureTexts.read(picture);
    } catch (ImageFormatException e) {
      throw refused(picture, e.getMessage());
    } catch (IOException e) {
      throw refused(picture, "cannot be read: " + FileFailure.reason(e));
    }
  }

  private static void requireSame(Path picture, String keyword, String expected, String found)
      throws TaskException {
    if (!Objects.equals(expected, found)) {
      throw refused(
          picture,
          switch (keyword) {
            case PictureMetadata.SCENE_HASH ->
                "its scene is another one: the model, one of its files or a flag of the model, such"
                    + " as --view, has changed";
            case PictureMetadata.CONVERTED_HASH ->
                "the program of --import-with has converted the model to other bytes than now: it,"
                    + " or a file that it reads beside the model, may have changed";
            default ->
                "its metadata have %s %s, expected %s"
                    .formatted(
                        keyword,
                        Objects.requireNonNullElse(found, NOTHING),
                        Objects.requireNonNullElse(expected, NOTHING));
          });
    }
  }

  private static TaskException refused(Path picture, String reason) {
    return ExitCode.USAGE.failure(
        picture
            + ": cannot be continued: "
            + reason
            + "; choose another path with -o, or remove it");
  }

  public boolean contains(Path picture) {
    return complete.contains(picture);
  }

  /** Returns the number of complete frames. */
  public int size() {
    return complete.size();
  }

  /** Returns the automatic exposure of the complete frames; empty if they have none. */
  public Optional<Exposure> exposure() throws TaskException {
    try {
      return exposure.map(stops -> Exposure.of(Double.parseDouble(stops)));
    } catch (IllegalArgumentException e) {
      throw ExitCode.USAGE.failure(
          "--continue: the frames have a damaged " + PictureMetadata.CHOSEN_EXPOSURE, e);
    }
  }
}
