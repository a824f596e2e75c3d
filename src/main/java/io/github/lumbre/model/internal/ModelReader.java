package io.github.lumbre.model.internal;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.section.Sections;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.ClosedByInterruptException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Reads model files of all supported formats. Stateless. */
public final class ModelReader {
  private ModelReader() {}

  /** Returns whether a file's name ends like the name of a model. */
  public static boolean isModelName(String name) {
    return ModelFormat.named(name).isPresent();
  }

  /**
   * Returns whether the content of a file is a model, whatever its name.
   *
   * @param start the first {@link FileContent#START} bytes, or more; all if the file has fewer
   * @param size of the file in bytes
   */
  public static boolean isModel(byte[] start, long size) {
    return ModelFormat.in(start, size).isPresent();
  }

  /**
   * Returns whether a file is a model, by the ending of its name. If the ending is of neither a
   * model nor .json, the content of the file decides.
   */
  public static boolean isModel(Path file) {
    String name = String.valueOf(file.getFileName());
    boolean isNamed = isModelName(name);
    boolean isScene = name.toLowerCase(Locale.ROOT).endsWith(".json");
    if (isNamed || isScene || !Files.isRegularFile(file)) {
      return isNamed;
    }
    try (InputStream in = Files.newInputStream(file)) {
      return isModel(in.readNBytes(FileContent.START), Files.size(file));
    } catch (IOException e) {
      // Reading the file reports the error.
      return false;
    }
  }

  /**
   * Returns the bytes of a model file.
   *
   * @throws ModelFormatException if there are more than the limits, an array or the heap allow
   * @throws IOException if the file cannot be read
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static byte[] bytes(Path file, Limits limits) throws ModelFormatException, IOException {
    try {
      long size = Files.size(file);
      ModelLimits.require("", "bytes", Math.min(limits.bytes(), FileFolder.MAX_BYTES), size);
      ModelLimits.require("", "bytes, the whole heap", Limits.NONE.heap(), size);
      return Files.readAllBytes(file);
    } catch (ClosedByInterruptException e) {
      throw Interrupts.cancelled(e);
    }
  }

  /**
   * Returns the content of a model file. The ending of its name chooses the format; if it is
   * unknown, such as .vrm, the content does. The model has a point, a triangle with an area, or a
   * light.
   *
   * @param name of the file
   * @param content bytes of the file
   * @param folder reads other files that the model names
   * @throws ModelFormatException if the file is damaged, unsupported or too large
   * @throws IOException if the folder fails
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static Model read(String name, byte[] content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    Model model = readPose(name, content, folder, options);
    if (model.lights().isEmpty()) {
      model.requireSurface();
    }
    return model;
  }

  /**
   * Returns the content of a model file, as {@link #read} does; in a pose of an animation, it may
   * have nothing to show.
   */
  public static Model readPose(
      String name, byte[] content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    Interrupts.check();
    ModelFormat format = format(name, content);
    if (format != ModelFormat.GLTF && format != ModelFormat.ZIP) {
      Optional<String> animation = options.find(ModelOption.POSE).map(Pose::animation);
      requireNone("animations", "an animation", animation);
      requireNone("variants", "a variant", options.find(ModelOption.VARIANT));
    }
    try {
      Model read = format.read(content, folder, options);
      return format == ModelFormat.ZIP ? read : finished(read, format, options);
    } catch (ModelFormatException e) {
      Optional<String> other = format.otherThanThis(content);
      if (other.isEmpty() || e.kind() == Kind.TOO_LARGE || e.kind() == Kind.ASSET) {
        throw e;
      }
      throw Kind.MALFORMED.at("", "expected " + format.title() + ", found " + other.get());
    }
  }

  /**
   * Returns what a file states of its motion; nothing for files in archives, and for formats
   * without motion.
   *
   * @param name of the file
   * @param content bytes of the file
   * @param folder reads other files that the model names
   */
  public static ModelMotions motions(
      String name, byte[] content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    return format(name, content).motions(content, folder, options);
  }

  /** Returns what the options show of a model, except for one of an archive, which is finished. */
  private static Model finished(Model read, ModelFormat format, ModelOptions options)
      throws ModelFormatException {
    Model placed = placed(read, format, options);
    double radius =
        options.find(ModelOption.POINT_RADIUS).isPresent()
            ? options.get(ModelOption.POINT_RADIUS) * options.find(ModelOption.UNIT).orElse(1.)
            : PointSpacing.radius(checked(placed, options));
    List<Model> poses = new ArrayList<>();
    for (Model pose : read.poses()) {
      poses.add(shown(placed(pose, format, options), options, radius));
    }
    Model all = poses.isEmpty() ? shown(placed, options, radius) : Model.inMotion(poses);
    Explosion exploded = Explosion.of(all, options);
    return exploded.moved(Sections.cut(exploded.assembled(), options));
  }

  /** Returns a model in the up axis and the unit of the options. */
  private static Model placed(Model read, ModelFormat format, ModelOptions options) {
    return switch (format) {
      case GLTF -> ModelCorrection.of(read, options);
      case THREE_MF, COLLADA -> read; // Their readers apply them to what the files state.
      default -> read.from(options.toWorld(), "");
    };
  }

  private static Model shown(Model read, ModelOptions options, double pointRadius)
      throws ModelFormatException {
    Model model = PartSelection.labeled(Looks.of(checked(read, options), options));
    Model sized = model.withPointRadius(pointRadius);
    ModelReach.require(sized);
    return PartSelection.shown(sized, options);
  }

  private static ModelFormat format(String name, byte[] content) throws ModelFormatException {
    Optional<ModelFormat> named = ModelFormat.named(name);
    Optional<ModelFormat> format =
        named.isPresent() ? named : ModelFormat.in(content, content.length);
    return format.orElseThrow(
        () ->
            Kind.UNSUPPORTED.at(
                "",
                "expected a model (%s), found %s"
                    .formatted(
                        ModelFormat.ENDINGS,
                        ModelFormat.describe(content).orElse("another kind of file"))));
  }

  private static Model checked(Model model, ModelOptions options) throws ModelFormatException {
    long items = 0;
    for (ModelPart part : model.parts()) {
      items += part.geometry().itemCount();
      ModelLimits.requireItems(part.location(), part.geometry(), items, options.limits());
    }
    if (model.lights().isEmpty() && options.find(ModelOption.POSE).isEmpty()) {
      model.requireSurface();
    }
    return model;
  }

  private static void requireNone(String location, String what, Optional<String> name)
      throws ModelFormatException {
    if (name.isPresent()) {
      ModelNames.index(location, what, List.of(), name.get());
    }
  }
}
