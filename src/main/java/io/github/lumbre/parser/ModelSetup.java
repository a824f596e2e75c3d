package io.github.lumbre.parser;

import com.google.gson.JsonObject;
import io.github.lumbre.file.FileContent;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.limit.Limits;
import io.github.lumbre.model.Model;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelReader;
import io.github.lumbre.parser.SceneFormatException.Kind;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The scene around a model that is rendered by itself: its camera, its light and its background.
 *
 * @param camera name of a camera in the model; empty for {@code view}
 * @param view the direction to look from; empty for the model's first camera, or {@link
 *     View#DEFAULT} if it has none
 * @param fov vertical angle of view in degrees, in (0, 180); not used with a camera of the model
 * @param sky {@code studio}, {@code white} or the path of a latitude-longitude picture
 * @param skyIntensity factor of the sky's radiance, at least 0
 * @param skyRotation rotation of the sky about the vertical axis, in degrees
 * @param ground whether the model stands on an infinite gray floor, of which only the shadows are
 *     visible if the background is transparent
 * @param background color that the camera sees instead of the sky; empty for the sky
 * @param transparent whether the background is transparent
 * @param options what to read from the model
 */
public record ModelSetup(
    Optional<String> camera,
    Optional<View> view,
    double fov,
    String sky,
    double skyIntensity,
    double skyRotation,
    boolean ground,
    Optional<Rgb> background,
    boolean transparent,
    ModelOptions options) {
  /** The default angle of view, in degrees. */
  public static final double DEFAULT_FOV = 35;

  /** A camera of the model or {@link View#DEFAULT}, in the studio, without a ground. */
  public static final ModelSetup DEFAULT =
      new ModelSetup(
          Optional.empty(),
          Optional.empty(),
          DEFAULT_FOV,
          "studio",
          1,
          0,
          false,
          Optional.empty(),
          false,
          ModelOptions.DEFAULT);

  /** The default size of a picture of a model, in pixels. */
  public static final int DEFAULT_WIDTH = 1024;

  /** The height that belongs to {@link #DEFAULT_WIDTH}. */
  public static final int DEFAULT_HEIGHT = 768;

  private static final String BYTES = "bytes in all files";

  /**
   * A direction to look from.
   *
   * @param azimuth degrees around the vertical axis: 0 in front, 90 to the right of the picture's
   *     front view
   * @param elevation degrees above the horizon, in [-90, 90]
   * @param isTurntable whether the camera keeps its distance to the axis at all azimuths; otherwise
   *     it is as near as this azimuth allows, with the model in the middle of the frame
   */
  public record View(double azimuth, double elevation, boolean isTurntable) {
    /** From the front, a little from the right and above. */
    public static final View DEFAULT = new View(30, 20);

    private static final double ISOMETRIC = 35.264389682754654;

    private static final Map<String, View> STANDARD = new LinkedHashMap<>();

    static {
      STANDARD.put("front", new View(0, 0));
      STANDARD.put("back", new View(180, 0));
      STANDARD.put("left", new View(-90, 0));
      STANDARD.put("right", new View(90, 0));
      STANDARD.put("top", new View(0, 90));
      STANDARD.put("bottom", new View(0, -90));
      STANDARD.put("iso", new View(45, ISOMETRIC));
    }

    /**
     * Returns the standard views by their names: front, back, left, right, top, bottom, iso, in
     * this order. Their pictures are the same in all releases; see docs/models.md.
     */
    public static Map<String, View> standard() {
      return Collections.unmodifiableMap(STANDARD);
    }

    /**
     * Returns the view in a text: the name of a standard view, or an azimuth and an elevation such
     * as {@code -40,15}.
     *
     * @throws IllegalArgumentException if the text is neither, or the elevation is not in [-90, 90]
     */
    public static View of(String text) {
      if (STANDARD.containsKey(text)) {
        return STANDARD.get(text);
      }
      String[] angles = text.split(",", -1);
      if (angles.length != 2) {
        throw new IllegalArgumentException(
            "expected "
                + String.join(", ", STANDARD.keySet())
                + " or AZIMUTH,ELEVATION, found "
                + text);
      }
      double elevation = angle(angles[1]);
      if (Math.abs(elevation) > 90) {
        throw new IllegalArgumentException(
            "expected an elevation from -90 to 90, found " + angles[1]);
      }
      return new View(angle(angles[0]), elevation);
    }

    private static double angle(String text) {
      try {
        double angle = Double.parseDouble(text);
        if (Double.isFinite(angle)) {
          return angle;
        }
      } catch (NumberFormatException e) {
        throw new IllegalArgumentException("expected a number, found " + text, e);
      }
      throw new IllegalArgumentException("expected a finite number, found " + text);
    }

    /** Creates a view that is framed for its own azimuth. */
    public View(double azimuth, double elevation) {
      this(azimuth, elevation, false);
    }

    /** Returns this direction, turned about the vertical axis as a picture of a turntable. */
    public View turned(double degrees) {
      return new View(azimuth + degrees, elevation, true);
    }
  }

  public ModelSetup {
    Objects.requireNonNull(camera, "camera");
    Objects.requireNonNull(view, "view");
    Objects.requireNonNull(sky, "sky");
    Objects.requireNonNull(background, "background");
    Objects.requireNonNull(options, "options");
  }

  /** Returns this setup, seen from a direction instead of by a camera of the model. */
  public ModelSetup seenFrom(View newView) {
    return new ModelSetup(
        Optional.empty(),
        Optional.of(newView),
        fov,
        sky,
        skyIntensity,
        skyRotation,
        ground,
        background,
        transparent,
        options);
  }

  /** Returns this setup with a floor that the model stands on. */
  public ModelSetup onGround() {
    return new ModelSetup(
        camera, view, fov, sky, skyIntensity, skyRotation, true, background, transparent, options);
  }

  /** Returns this setup with a transparent background. */
  public ModelSetup onTransparentBackground() {
    return new ModelSetup(
        camera, view, fov, sky, skyIntensity, skyRotation, ground, Optional.empty(), true, options);
  }

  /** Returns this setup with limits for the model. */
  public ModelSetup limitedTo(Limits limits) {
    return reading(options.limitedTo(limits));
  }

  /** Returns this setup with other options for reading the model. */
  public ModelSetup reading(ModelOptions newOptions) {
    return new ModelSetup(
        camera,
        view,
        fov,
        sky,
        skyIntensity,
        skyRotation,
        ground,
        background,
        transparent,
        newOptions);
  }

  /**
   * Returns whether a file is a model, by the ending of its name. If it is neither that of a model
   * nor .json, the content of the file decides.
   */
  public static boolean isModel(Path file) {
    String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
    if (ModelReader.isModelName(name) || name.endsWith(".json") || !Files.isRegularFile(file)) {
      return ModelReader.isModelName(name);
    }
    try (InputStream in = Files.newInputStream(file)) {
      return ModelReader.isModel(in.readNBytes(FileContent.START), Files.size(file));
    } catch (IOException e) {
      // Reading the scene reports the error.
      return false;
    }
  }

  /**
   * Returns the scene of a model file. Its asset paths start in the nearest folder that contains
   * both the model and the sky's picture.
   *
   * @param aspect width of the frame over its height, to frame the model; empty for the default
   * @throws SceneFormatException if the model does not exist or cannot be used
   * @throws IOException if the model exists but cannot be read
   */
  public SceneText sceneOf(Path file, OptionalDouble aspect)
      throws SceneFormatException, IOException {
    Path model = file.toAbsolutePath().normalize();
    return shown().sceneIn(folderOf(model), model, aspect);
  }

  /** Returns this setup for a model that is rendered by itself: it may lack pictures. */
  private ModelSetup shown() {
    return reading(options.lenient(true));
  }

  /** Returns the nearest folder that contains both the model and the sky's picture. */
  Path folderOf(Path model) {
    Path folder = model.getParent();
    if (!isBuiltIn()) {
      Path picture = Path.of(sky).toAbsolutePath().normalize();
      while (folder.getParent() != null && !picture.startsWith(folder)) {
        folder = folder.getParent();
      }
    }
    return folder;
  }

  /**
   * Returns the scenes of a model file, one for each view. The model is read once.
   *
   * @throws SceneFormatException if the model does not exist or cannot be used
   */
  List<SceneText> scenesOf(Path file, OptionalDouble aspect, List<View> views)
      throws SceneFormatException, IOException {
    Path path = file.toAbsolutePath().normalize();
    Path folder = folderOf(path);
    List<SceneText> texts = new ArrayList<>();
    Optional<Model> model = Optional.empty();
    for (View each : views) {
      if (model.isEmpty()) {
        model = Optional.of(shown().read(path));
      }
      texts.add(seenFrom(each).sceneOf(folder, path, model.get(), aspect));
    }
    return texts;
  }

  /**
   * Returns the scene of a model file, to be written to a file. A missing picture is an error
   * unless the options are lenient, as it is in a scene.
   *
   * @param folder where asset paths start; contains the model and the sky's picture
   */
  public SceneText sceneIn(Path folder, Path file, OptionalDouble aspect)
      throws SceneFormatException, IOException {
    return sceneOf(folder, file, read(file), aspect);
  }

  /** Reads a model within the limits. */
  private Model read(Path file) throws SceneFormatException, IOException {
    String name = String.valueOf(file.getFileName());
    Problems problems = new Problems(name, true);
    if (!Files.exists(file)) {
      String place = Problems.at(file);
      problems.error(Kind.INVALID, () -> "$", "expected a model file, found none" + place);
      throw problems.exception();
    }
    long bytes = Files.size(file);
    Optional<String> excess = Limits.excess(BYTES, options.limits().bytes(), bytes);
    if (excess.isPresent()) {
      problems.error(Kind.LIMIT, () -> "$", excess.get());
      throw problems.exception();
    }
    ModelFolder files = ModelFolder.of(file.getParent(), options.limits().bytes() - bytes);
    return checked(name, () -> ModelReader.read(name, Files.readAllBytes(file), files, options));
  }

  /**
   * Returns the scene of a model whose bytes are known.
   *
   * @param folder where asset paths start; contains the model, which need not exist
   * @param files reads the files that the model names
   */
  SceneText sceneOf(
      Path folder, Path file, byte[] content, ModelFolder files, OptionalDouble aspect)
      throws SceneFormatException, IOException {
    String name = String.valueOf(file.getFileName());
    Model model =
        checked(
            name,
            () -> {
              requireBytes(content.length);
              return ModelReader.read(name, content, files, options.lenient(true));
            });
    return sceneOf(folder, file, model, aspect);
  }

  private SceneText sceneOf(Path folder, Path file, Model model, OptionalDouble aspect)
      throws SceneFormatException, IOException {
    String name = String.valueOf(file.getFileName());
    requireSky(name);
    ModelFraming framing = ModelFraming.of(model);
    JsonObject scene =
        checked(
            name,
            () ->
                new ModelStage(this, model, framing)
                    .scene(folder.relativize(file), folder, aspect));
    // One line, which the header of a checkpoint file can hold.
    return new SceneText(
        scene.toString().getBytes(StandardCharsets.UTF_8),
        folder.resolve(name),
        Optional.of(ModelContents.of(model, framing)));
  }

  /** Work with a model that may be damaged. */
  @FunctionalInterface
  private interface ModelWork<T> {
    T done() throws ModelFormatException, IOException;
  }

  private static <T> T checked(String name, ModelWork<T> work)
      throws SceneFormatException, IOException {
    try {
      return work.done();
    } catch (ModelFormatException e) {
      Problems problems = new Problems(name, true);
      Kind kind = e.kind() == ModelFormatException.Kind.TOO_LARGE ? Kind.LIMIT : Kind.ASSET;
      problems.error(kind, () -> Problems.escaped(e.location()), Problems.escaped(e.detail()));
      throw problems.exception();
    }
  }

  private void requireBytes(long bytes) throws ModelFormatException {
    Optional<String> excess = Limits.excess(BYTES, options.limits().bytes(), bytes);
    if (excess.isPresent()) {
      throw new ModelFormatException(ModelFormatException.Kind.TOO_LARGE, "", excess.get());
    }
  }

  /** Returns the absolute paths of the model and, if it is a file, the sky. */
  public List<Path> files(Path file) {
    Path model = file.toAbsolutePath().normalize();
    return isBuiltIn() ? List.of(model) : List.of(model, Path.of(sky).toAbsolutePath().normalize());
  }

  /** Requires the sky's picture, so that a problem names it as the setup does. */
  private void requireSky(String name) throws SceneFormatException {
    if (isBuiltIn() || Files.isRegularFile(Path.of(sky))) {
      return;
    }
    Problems problems = new Problems(name, true);
    String found = Files.isDirectory(Path.of(sky)) ? "a folder" : "none";
    problems.error(
        Kind.ASSET,
        () -> ModelStage.SKY_PICTURE,
        "expected a file, found " + found + " at " + Problems.quoted(sky));
    throw problems.exception();
  }

  /** Returns whether the sky is no picture. */
  private boolean isBuiltIn() {
    return sky.equals("studio") || sky.equals("white");
  }
}
