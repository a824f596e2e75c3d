package io.github.lumbre.parser;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.parser.internal.ShownLabels;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.text.PrintableText;
import io.github.lumbre.texture.internal.ClearSky;
import io.github.lumbre.texture.internal.SunPosition;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * What is around a model that is rendered by itself: its camera, its light and its background.
 * {@link SceneParser#parse(Path, Stage)} reads the model and builds the scene.
 *
 * @param camera name of a camera in the model; empty for {@code view}
 * @param view the direction to look from; empty for the model's first camera, or {@link
 *     View#DEFAULT} if it has none
 * @param fov vertical angle of view in degrees, in (0, 180); not used with a camera of the model
 * @param ground whether the model stands on an infinite gray floor; if the background is
 *     transparent, only shadows are visible on it
 * @param background linear color of the screen, each component in [0,1], that finished pictures
 *     show instead of the sky; see {@link Setting#BACKPLATE}. Empty for the sky
 * @param transparent whether the background is transparent
 * @param lineWidth width in pixels of lines on silhouettes, creases and borders, 0 to 100; 0 for no
 *     lines
 * @param creaseDegrees angle between two triangles from which on their edge is a crease, 0 to 180
 * @param labels what is drawn on finished pictures: some of {@link #LABELS}
 * @param options what to read from the model
 */
public record Stage(
    Optional<String> camera,
    Optional<View> view,
    double fov,
    Sky sky,
    boolean ground,
    Optional<Rgb> background,
    boolean transparent,
    double lineWidth,
    double creaseDegrees,
    Set<String> labels,
    ModelOptions options) {
  /**
   * The names of labels: {@code view} is the name of the view, {@code axes} the directions of the
   * file's axes, {@code scale} a scale bar, {@code size} the dimensions of the box around the model
   * in the unit of the file, {@code box} its edges, and {@code parts} the names of visible parts.
   */
  public static final List<String> LABELS = ShownLabels.KINDS;

  /** The default angle of view, in degrees. */
  public static final double DEFAULT_FOV = 35;

  /** A camera of the model or {@link View#DEFAULT}, in the studio, without a ground. */
  public static final Stage DEFAULT =
      new Stage(
          Optional.empty(),
          Optional.empty(),
          DEFAULT_FOV,
          Sky.STUDIO,
          false,
          Optional.empty(),
          false,
          Setting.LINE_WIDTH.missing(),
          Setting.CREASE_ANGLE.missing(),
          Set.of(),
          ModelOptions.DEFAULT);

  /** The default size of a picture of a model, in pixels. */
  public static final int DEFAULT_WIDTH = 1024;

  /** The height that belongs to {@link #DEFAULT_WIDTH}. */
  public static final int DEFAULT_HEIGHT = 768;

  /**
   * The environment light.
   *
   * @param name {@code studio}, {@code white}, {@code sun} for a clear day's sky with the sun, or
   *     the path of a latitude-longitude picture
   * @param intensity factor of its radiance, 0 to 1e150
   * @param rotation about the vertical axis, in degrees, finite
   * @param sun the view from the sun: where it stands if the sky is not turned. Its elevation is at
   *     least 0; other skies ignore it
   */
  public record Sky(String name, double intensity, double rotation, View sun) {
    /** The largest factor of a sky's radiance: the light of all its directions is finite. */
    static final double MAX_INTENSITY = 1e150;

    /** Where the sun stands if nothing else is said. */
    static final View SUN = new View(-40, 35);

    /** The lights of a photographer's studio. */
    public static final Sky STUDIO = new Sky("studio");

    public Sky {
      Objects.requireNonNull(name, "name");
      if (!(intensity >= 0 && intensity <= MAX_INTENSITY)) {
        throw new IllegalArgumentException(
            "intensity: expected a number from 0 to "
                + PrintableText.number(MAX_INTENSITY)
                + ", found "
                + intensity);
      }
      if (!Double.isFinite(rotation)) {
        throw new IllegalArgumentException("rotation: expected a finite number, found " + rotation);
      }
      Objects.requireNonNull(sun, "sun");
      if (!(sun.elevation() >= ClearSky.LOWEST && sun.elevation() <= 90)) {
        throw new IllegalArgumentException(
            "sun: expected an elevation from 0 to 90, found " + sun.elevation());
      }
    }

    /** Creates a sky whose sun stands to the left in front of the model, 35 degrees high. */
    public Sky(String name, double intensity, double rotation) {
      this(name, intensity, rotation, SUN);
    }

    /** Creates a sky of intensity 1 that is not turned. */
    public Sky(String name) {
      this(name, 1, 0);
    }

    /**
     * Returns where the sun stands at a place and a time, right to about 0.01 degrees: the front
     * view looks north.
     *
     * @param latitude degrees to the north of the equator, -90 to 90
     * @param longitude degrees to the east of Greenwich, -180 to 180
     * @param time from 1950 to 2050
     * @return the view from the sun; its elevation is negative at night
     * @throws IllegalArgumentException if an argument is out of its range
     */
    public static View sunAt(double latitude, double longitude, Instant time) {
      SunPosition sun = SunPosition.of(latitude, longitude, time);
      return new View(180 - sun.azimuth(), sun.elevation());
    }

    /** Returns whether it is a clear day's, with the sun. */
    boolean hasSun() {
      return name.equals("sun");
    }

    /** Returns the absolute path of its picture; empty if it has none. */
    Optional<Path> picture() {
      return hasSun() || name.equals("studio") || name.equals("white")
          ? Optional.empty()
          : Optional.of(Path.of(name).toAbsolutePath().normalize());
    }
  }

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
     * this order. Their pictures are the same in all releases; see docs/model-pictures.md.
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
            "expected %s or AZIMUTH,ELEVATION, found %s"
                .formatted(String.join(", ", STANDARD.keySet()), text));
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

  public Stage {
    Objects.requireNonNull(camera, "camera");
    Objects.requireNonNull(view, "view");
    Objects.requireNonNull(sky, "sky");
    if (!Setting.BACKPLATE.type().accepts(background)) {
      throw new IllegalArgumentException(
          "background: expected components from 0 to 1, found " + background.orElseThrow());
    }
    Objects.requireNonNull(options, "options");
    labels = Set.copyOf(labels);
    if (!LABELS.containsAll(labels)) {
      throw new IllegalArgumentException(
          "labels: expected some of " + String.join(", ", LABELS) + ", found " + labels);
    }
    if (!Setting.LINE_WIDTH.type().accepts(lineWidth)) {
      throw new IllegalArgumentException(
          "lineWidth: expected " + Setting.LINE_WIDTH.type().expected() + ", found " + lineWidth);
    }
    if (!Setting.CREASE_ANGLE.type().accepts(creaseDegrees)) {
      throw new IllegalArgumentException(
          "creaseDegrees: expected %s, found %s"
              .formatted(Setting.CREASE_ANGLE.type().expected(), creaseDegrees));
    }
    if (!(fov > 0 && fov < 180)) {
      throw new IllegalArgumentException(
          "fov: expected more than 0 and less than 180, found " + fov);
    }
  }

  private Stage with(
      Optional<String> newCamera,
      Optional<View> newView,
      Sky newSky,
      boolean hasGround,
      ModelOptions newOptions) {
    return new Stage(
        newCamera,
        newView,
        fov,
        newSky,
        hasGround,
        background,
        transparent,
        lineWidth,
        creaseDegrees,
        labels,
        newOptions);
  }

  private Stage drawn(
      Optional<Rgb> color, boolean isTransparent, double width, Set<String> newLabels) {
    return new Stage(
        camera,
        view,
        fov,
        sky,
        ground,
        color,
        isTransparent,
        width,
        creaseDegrees,
        newLabels,
        options);
  }

  /** Returns this stage, seen from a direction instead of by a camera of the model. */
  public Stage seenFrom(View newView) {
    return with(Optional.empty(), Optional.of(newView), sky, ground, options);
  }

  /** Returns this stage under another sky. */
  public Stage under(Sky newSky) {
    return with(camera, view, newSky, ground, options);
  }

  /** Returns this stage with a floor that the model stands on. */
  public Stage onGround() {
    return with(camera, view, sky, true, options);
  }

  /** Returns this stage with a transparent background. */
  public Stage onTransparentBackground() {
    return drawn(Optional.empty(), true, lineWidth, labels);
  }

  /**
   * Returns this stage before a color of the screen, which finished pictures show behind the model.
   *
   * @param color linear, each component in [0,1]
   */
  public Stage onBackground(Rgb color) {
    return drawn(Optional.of(color), false, lineWidth, labels);
  }

  /** Returns this stage with other options for reading the model. */
  public Stage reading(ModelOptions newOptions) {
    return with(camera, view, sky, ground, newOptions);
  }

  /**
   * Returns this stage with lines on silhouettes, creases and borders.
   *
   * @param width in pixels, 0 to 100; 0 for no lines
   */
  public Stage withLines(double width) {
    return drawn(background, transparent, width, labels);
  }

  /** Returns this stage with labels: some of {@link #LABELS}. */
  public Stage labeled(Set<String> newLabels) {
    return drawn(background, transparent, lineWidth, newLabels);
  }

  /** Returns the nearest folder that contains both the model and the sky's picture. */
  Path folderOf(Path model) {
    Path folder = model.getParent();
    Path picture = sky.picture().orElse(folder);
    while (folder.getParent() != null && !picture.startsWith(folder)) {
      folder = folder.getParent();
    }
    return folder;
  }

  /** Returns the absolute paths of the model and, if it has one, the sky's picture. */
  public List<Path> files(Path model) {
    Path absolute = model.toAbsolutePath().normalize();
    return sky.picture().map(picture -> List.of(absolute, picture)).orElse(List.of(absolute));
  }
}
