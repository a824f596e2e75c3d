package io.github.lumbre.stage;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.OptionTypes;
import io.github.lumbre.model.internal.OptionTypes.NamedType;
import io.github.lumbre.model.internal.OptionTypes.TextType;
import io.github.lumbre.model.internal.OptionValues;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.internal.Look;
import io.github.lumbre.stage.internal.PictureDrawing;
import io.github.lumbre.stage.internal.ShownLabels;
import io.github.lumbre.stage.internal.StageTypes;
import io.github.lumbre.stage.internal.StageTypes.BackgroundType;
import io.github.lumbre.stage.internal.StageTypes.LookType;
import io.github.lumbre.stage.internal.StageTypes.PageType;
import io.github.lumbre.stage.internal.StageTypes.PointType;
import io.github.lumbre.stage.internal.StageTypes.ScaleType;
import io.github.lumbre.stage.internal.StageTypes.ViewType;
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
import java.util.stream.Stream;

/**
 * What is around a model that is rendered by itself: its camera, its light and its background, and
 * what is read of it. {@link StagedModel#read(Path, Stage, SceneParser)} reads the model and builds
 * the scene. Immutable.
 */
public final class Stage {
  /** The vertical angle of view in perspective unless a stage has its own, in degrees. */
  public static final double DEFAULT_FOV = 35;

  private static final double LEAST_ZOOM = 1e-6;

  /** The name of a camera in the model; without it, the view counts. */
  public static final ModelOption<String> CAMERA =
      new ModelOption<>(
              "camera",
              new TextType("a name"),
              "Camera of the file to use (the first, if it has one).")
          .withFlag("camera", "NAME")
          .inTools("camera", "Camera of the file to look through, as 'describe' lists it.");

  /**
   * The direction to look from; without it, the model's first camera, or {@link View#DEFAULT} if it
   * has none.
   */
  public static final ModelOption<View> VIEW =
      new ModelOption<>(
              "view",
              new ViewType(),
              "Look from front, back, left, right, top, bottom or iso (parallel), or azimuth and"
                  + " elevation in degrees (30,20 without a camera in the file).")
          .withFlag("view", "NAME|AZ,EL")
          .inTools(
              "view",
              "front, back, left, right, top, bottom or iso, in parallel projection, or"
                  + " AZIMUTH,ELEVATION in degrees, in perspective, such as 30,20 (the default).");

  /** What the camera at the eye looks at; without it, the middle of the box around the model. */
  public static final ModelOption<Vec3> TARGET =
      new ModelOption<>(
              "target",
              new PointType(),
              "Point that the camera at the eye looks at (the middle of the box around the model,"
                  + " or of the part that is fitted).")
          .withFlag("target", "X,Y,Z")
          .inTools("target", "Point that the camera at the eye looks at: X,Y,Z (the middle).");

  /** Where the camera is, in the file's axes and unit, instead of a view or the file's camera. */
  public static final ModelOption<Vec3> EYE =
      new ModelOption<>(
              "eye",
              new PointType(),
              "Place of the camera, in the file's axes and unit; it looks at "
                  + TARGET.flag()
                  + ".")
          .withFlag("eye", "X,Y,Z")
          .inTools("eye", "Place of the camera, in the file's axes and unit: X,Y,Z.");

  /** How much larger things are in the picture than without it; the camera keeps its place. */
  public static final ModelOption<Double> ZOOM =
      new ModelOption<>(
              "zoom",
              new NumberType(LEAST_ZOOM, 1 / LEAST_ZOOM),
              "Factor by which things in the middle of the picture are larger ({default}).")
          .withDefault(1.)
          .withFlag("zoom", "FACTOR")
          .inTools("zoom", "Factor by which things in the middle of the picture are larger (1).");

  /** The name of the part that the camera frames, as of {@link ModelOption#HIDE}. */
  public static final ModelOption<String> FIT =
      new ModelOption<>(
              "fit",
              new TextType("a name"),
              "Frame this part instead of the whole model; '*' stands for any text.")
          .withFlag("fit", "PART")
          .inTools("fit", "Part that fills the frame, instead of the whole model.");

  /** Whether the projection is parallel, as it is from the standard views without an angle. */
  public static final ModelOption<Boolean> PARALLEL =
      new ModelOption<>(
              "parallel",
              new FlagType(),
              "Parallel projection, as from the views with names: lengths across the view keep"
                  + " their ratios.")
          .withDefault(false)
          .withFlag("parallel", "")
          .inTools("parallel", "Whether the projection is parallel, also without a named view.");

  /** Whether a standard view is in perspective, as others are; {@link #PARALLEL} wins. */
  public static final ModelOption<Boolean> PERSPECTIVE =
      new ModelOption<>(
              "perspective",
              new FlagType(),
              "Perspective, also from the views with names.")
          .withDefault(false)
          .withFlag("perspective", "")
          .inTools("perspective", "Whether named views are in perspective, as others are.");

  /**
   * The vertical angle of view in degrees; without it, {@link #DEFAULT_FOV}. It puts standard views
   * in perspective, and is not used in parallel projection or with a camera of the model.
   */
  public static final ModelOption<Double> FOV =
      new ModelOption<>(
              "fov",
              new NumberType(Range.open(0, 180)),
              ("Vertical angle of view in perspective, also from the views with names (%s); not"
                      + " used with a camera of the file.")
                  .formatted(PrintableText.number(DEFAULT_FOV)))
          .withFlag("fov", "DEGREES")
          .inTools("fov", "Vertical angle of view in degrees, in perspective (35).");

  /** The name of the {@link Sky}; without it, that of the look. */
  public static final ModelOption<String> SKY =
      new ModelOption<>(
              "sky",
              new TextType("a name or a file"),
              "Light from relief (a studio with contrast), studio (softer), white, sun (a clear"
                  + " day), or a latitude-longitude picture (relief; with a look, ground or"
                  + " background, studio).")
          .withFlag("sky", "NAME|FILE");

  /** See {@link Sky#sun}. */
  public static final ModelOption<View> SUN =
      new ModelOption<>(
              "sun",
              StageTypes.SUN,
              ("Place of the sun with %s sun: azimuth as of %s, 0 in front, and elevation from 0"
                      + " to 90, in degrees ({default}); or a latitude, an eastern longitude and a"
                      + " time such as 2026-06-21T12:00Z, where %2$s front looks north.")
                  .formatted(SKY.flag(), VIEW.flag()))
          .withDefault(Sky.SUN)
          .withFlag("sun", "AZ,EL|LAT,LON@TIME");

  /** See {@link Sky#intensity}. */
  public static final ModelOption<Double> SKY_INTENSITY =
      new ModelOption<>(
              "skyIntensity", StageTypes.INTENSITY, "Factor of the sky's radiance ({default}).")
          .withDefault(1.)
          .withFlag("sky-intensity", "FACTOR");

  /** See {@link Sky#rotation}. */
  public static final ModelOption<Double> SKY_ROTATION =
      new ModelOption<>(
              "skyRotation",
              StageTypes.ROTATION,
              "Rotation of the sky about the vertical axis ({default}).")
          .withDefault(0.)
          .withFlag("sky-rotation", "DEGREES");

  /**
   * Whether the model stands on an infinite gray floor; if the background is transparent, only
   * shadows are visible on it.
   */
  public static final ModelOption<Boolean> GROUND =
      new ModelOption<>(
              "ground",
              new FlagType(),
              "Put the model on an infinite gray floor. If the background is transparent, only its"
                  + " shadow is seen.")
          .withDefault(false)
          .withFlag("ground", "")
          .inTools("ground", "Whether the model stands on a floor, which shows its shadow.");

  /** {@code sky}, {@code transparent} or a color of CSS; without it, that of the look. */
  public static final ModelOption<String> BACKGROUND =
      new ModelOption<>(
              "background",
              new BackgroundType(),
              "Show sky, transparent, or a color behind it: #rrggbb or a CSS name such as white"
                  + " (sky). In PNG and JPEG it is this very color, whatever "
                  + Setting.EXPOSURE.flag()
                  + " and "
                  + Setting.TONE_MAP.flag()
                  + " are.")
          .withFlag("background", "COLOR")
          .inTools(
              "background",
              "What is behind the model: sky, transparent, #rrggbb, or a CSS name such as white.");

  /** {@code clay}, {@code lines} or {@code clay,lines}: the shape alone. */
  public static final ModelOption<String> LOOK =
      new ModelOption<>(
              "look",
              new LookType(),
              "Show the shape alone: clay (matte, light gray), lines (black on white: silhouettes,"
                  + " creases and borders), or clay,lines.")
          .withFlag("look", "LOOK")
          .inTools(
              "look",
              "Shows the shape alone: clay (matte, light gray), lines (black on white: silhouettes,"
                  + " creases and borders), or clay,lines. Without it, as the file says.");

  /** The width of lines on silhouettes, creases and borders, in pixels; without it, of the look. */
  public static final ModelOption<Double> LINE_WIDTH =
      new ModelOption<>(
              "lineWidth",
              new NumberType(Range.above(0, 100)),
              "Width of the lines (" + Look.LINE_WIDTH + ").")
          .withFlag("line-width", "PIXELS");

  /** The angle between two triangles from which on their edge is a crease, in degrees. */
  public static final ModelOption<Double> CREASE =
      new ModelOption<>(
              "creaseAngle",
              Setting.CREASE_ANGLE.type(),
              "Angle between two faces from which on a line is drawn between them ({default}).")
          .withDefault(Setting.CREASE_ANGLE.defaultValue())
          .withFlag("crease", "DEGREES");

  /** Whether hidden lines are drawn as dashes; otherwise they are left out. */
  public static final ModelOption<Boolean> HIDDEN =
      new ModelOption<>(
              "hidden",
              new NamedType<>(Map.of("dashed", true, "none", false)),
              "Draw hidden lines as dashes, or none (none).")
          .withDefault(false)
          .withFlag("hidden", "dashed|none");

  /** How long things are on paper in parallel projection: 1:2, 5:1. */
  public static final ModelOption<String> SCALE =
      new ModelOption<>(
              "scale",
              new ScaleType(),
              "Scale on paper of a parallel view, such as 1:2; a pixel is 1/96 inch, and a file"
                  + " without a unit is in millimeters.")
          .withFlag("scale", "N:N");

  /** The sheet of paper of a picture: {@code a4}, {@code a3-landscape}, {@code 200x100}. */
  public static final ModelOption<String> PAGE =
      new ModelOption<>(
              "page",
              new PageType(),
              "Sheet of paper, instead of a size: a0 to a5 or letter, perhaps with -landscape, or"
                  + " millimeters such as 200x100.")
          .withFlag("page", "PAGE");

  /** What is drawn on finished pictures: {@code all}, or some of {@link #LABELS}. */
  public static final ModelOption<List<String>> LABEL =
      new ModelOption<>(
              "labels",
              StageTypes.LABELS,
              "Draw labels on the picture: view (its name), axes, scale, parts (names), size"
                  + " (dimensions of the box around the model), box, or all. Separated by commas.")
          .withDefault(List.of())
          .withFlag("labels", "LIST")
          .inTools(
              "labels",
              "Labels to draw, some of: "
                  + String.join(", ", ShownLabels.KINDS)
                  + ". Axes and dimensions are in the file's axes and unit; parts are names.");

  private static final List<ModelOption<?>> OWN =
      List.of(
          CAMERA,
          VIEW,
          EYE,
          TARGET,
          ZOOM,
          FIT,
          PARALLEL,
          PERSPECTIVE,
          FOV,
          SKY,
          SUN,
          SKY_INTENSITY,
          SKY_ROTATION,
          GROUND,
          BACKGROUND,
          LOOK,
          LINE_WIDTH,
          CREASE,
          HIDDEN,
          SCALE,
          PAGE,
          LABEL);

  /**
   * The names of labels: {@code view} is the name of the view, {@code axes} the directions of the
   * file's axes, {@code scale} a scale bar, {@code size} the dimensions of the box around the model
   * in the unit of the file, {@code box} its edges, and {@code parts} the names of visible parts.
   */
  public static final List<String> LABELS = ShownLabels.KINDS;

  /** A camera of the model or {@link View#DEFAULT}, in {@link Sky#RELIEF}, without a ground. */
  public static final Stage DEFAULT = new Stage(OptionValues.NONE, ModelOptions.DEFAULT);

  /** The default size of a picture of a model, in pixels. */
  public static final int DEFAULT_WIDTH = 1024;

  /** The light behind the model in a studio, at the upper and lower edge of the frame. */
  private static final double TOP = .32;

  private static final double BOTTOM = .25;

  /** The height that belongs to {@link #DEFAULT_WIDTH}. */
  public static final int DEFAULT_HEIGHT = 768;

  /**
   * The environment light.
   *
   * @param name {@code relief}, {@code studio}, {@code white}, {@code sun} for a clear day's sky
   *     with the sun, or the path of a latitude-longitude picture
   * @param intensity factor of its radiance, 0 to 1e150
   * @param rotation about the vertical axis, in degrees, finite
   * @param sun the view from the sun: where it stands if the sky is not turned. Its elevation is at
   *     least 0; other skies ignore it
   */
  public record Sky(String name, double intensity, double rotation, View sun) {
    /** Where the sun stands if nothing else is said. */
    static final View SUN = new View(ClearSky.AZIMUTH, ClearSky.ELEVATION);

    /** The lights of a studio that show shape: sides differ, and edges of dark models shine. */
    public static final Sky RELIEF = new Sky("relief");

    /** The lights of a photographer's studio, softer than {@link #RELIEF}. */
    public static final Sky STUDIO = new Sky("studio");

    public Sky {
      Objects.requireNonNull(name, "name");
      StageTypes.INTENSITY.require("intensity", intensity);
      StageTypes.ROTATION.require("rotation", rotation);
      StageTypes.SUN.require("sun", sun);
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

    /** Returns the absolute path of its picture; empty if it has none. */
    public Optional<Path> picture() {
      return Set.of("relief", "studio", "white", "sun").contains(name)
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
   * @param isParallel whether the projection is parallel unless a stage says otherwise
   */
  public record View(double azimuth, double elevation, boolean isTurntable, boolean isParallel) {
    /** From the front, a little from the right and above. */
    public static final View DEFAULT = new View(30, 20);

    private static final double ISOMETRIC = 35.264389682754654;

    private static final Map<String, View> STANDARD = new LinkedHashMap<>();

    static {
      STANDARD.put("front", new View(0, 0, false, true));
      STANDARD.put("back", new View(180, 0, false, true));
      STANDARD.put("left", new View(-90, 0, false, true));
      STANDARD.put("right", new View(90, 0, false, true));
      STANDARD.put("top", new View(0, 90, false, true));
      STANDARD.put("bottom", new View(0, -90, false, true));
      STANDARD.put("iso", new View(45, ISOMETRIC, false, true));
    }

    /**
     * Returns the standard views by their names: front, back, left, right, top, bottom, iso, in
     * this order. They are parallel projections. Their pictures are the same in all releases; see
     * docs/model-pictures.md.
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
      double elevation = OptionTypes.finite(angles[1]);
      if (Math.abs(elevation) > 90) {
        throw new IllegalArgumentException(
            "expected an elevation from -90 to 90, found " + angles[1]);
      }
      return new View(OptionTypes.finite(angles[0]), elevation);
    }

    /** Creates a view in perspective that is framed for its own azimuth. */
    public View(double azimuth, double elevation) {
      this(azimuth, elevation, false, false);
    }

    /**
     * Returns this direction, turned about the vertical axis as a picture of a turntable, in
     * perspective.
     */
    public View turned(double degrees) {
      return new View(azimuth + degrees, elevation, true, false);
    }

    /** Returns the name of the standard view with this direction; empty if there is none. */
    public Optional<String> name() {
      return STANDARD.entrySet().stream()
          .filter(named -> !isTurntable && named.getValue().hasDirectionOf(this))
          .map(Map.Entry::getKey)
          .findFirst();
    }

    private boolean hasDirectionOf(View other) {
      return azimuth == other.azimuth && elevation == other.elevation;
    }
  }

  private final OptionValues values;
  private final ModelOptions options;

  private Stage(OptionValues values, ModelOptions options) {
    this.values = values;
    this.options = Objects.requireNonNull(options, "options");
  }

  /** Returns all options: those of this class, and those of {@link ModelOption}. */
  public static List<ModelOption<?>> all() {
    return Stream.concat(OWN.stream(), ModelOption.all().stream()).toList();
  }

  /**
   * Returns this stage with another value of an option.
   *
   * @throws IllegalArgumentException if it is out of range; the message names the option
   */
  public <T> Stage with(ModelOption<T> option, T value) {
    if (!OWN.contains(option)) {
      return reading(options.with(option, value));
    }
    OptionValues changed = values.with(option, value);
    return new Stage(
        changed,
        option == LOOK ? options.with(ModelOption.LOOK, look(changed).materials()) : options);
  }

  /** Returns the value of an option, or its default; empty if it has none. */
  public <T> Optional<T> find(ModelOption<T> option) {
    return OWN.contains(option) ? values.find(option) : options.find(option);
  }

  /** Returns the value of an option that has a default. */
  public <T> T get(ModelOption<T> option) {
    return find(option).orElseThrow();
  }

  private static Look look(OptionValues values) {
    return Look.of(values.find(LOOK));
  }

  /** Returns whether the model is framed by this stage, and not seen by a camera of its own. */
  public boolean isFramed() {
    return find(CAMERA).isEmpty()
        && (Stream.of(VIEW, EYE, FIT).anyMatch(option -> find(option).isPresent())
            || get(PARALLEL)
            || get(PERSPECTIVE)
            || options.get(ModelOption.EXPLODE) > 0);
  }

  /** Returns whether a model that is framed is seen in parallel projection. */
  public boolean isParallel() {
    boolean isOfView = find(EYE).isEmpty() && find(VIEW).filter(View::isParallel).isPresent();
    return get(PARALLEL) || isOfView && !get(PERSPECTIVE) && find(FOV).isEmpty();
  }

  /**
   * Returns the environment light. If none is asked for, it is {@link Sky#RELIEF}, or that of the
   * look, the ground or the background that is.
   */
  public Sky sky() {
    String otherwise = isPlain() ? Sky.RELIEF.name() : look(values).sky();
    String name = values.find(SKY).orElse(otherwise);
    return new Sky(name, get(SKY_INTENSITY), get(SKY_ROTATION), get(SUN));
  }

  /** Returns whether neither look nor ground nor background is asked for. */
  private boolean isPlain() {
    return values.find(LOOK).isEmpty() && values.find(BACKGROUND).isEmpty() && !get(GROUND);
  }

  /** Returns the linear color that pictures show instead of the sky; empty for the sky. */
  public Optional<Rgb> background() {
    Optional<String> named = values.find(BACKGROUND);
    return named.isPresent() ? named.flatMap(BackgroundType::color) : look(values).background();
  }

  /**
   * Returns what the camera sees instead of the lamps and walls of the studio: an even ground, a
   * little brighter at the top; empty if something else is asked for.
   */
  public Optional<Backplate> backplate() {
    Sky sky = sky();
    boolean isStudio = Set.of(Sky.RELIEF.name(), Sky.STUDIO.name()).contains(sky.name());
    boolean isSeen = isStudio && values.find(BACKGROUND).isEmpty();
    return isSeen && background().isEmpty()
        ? Optional.of(
            new Backplate(
                Rgb.gray(TOP * sky.intensity()), Rgb.gray(BOTTOM * sky.intensity())))
        : Optional.empty();
  }

  /** Returns whether the background is transparent. */
  public boolean transparent() {
    return values.find(BACKGROUND).filter(BackgroundType.TRANSPARENT::equalsIgnoreCase).isPresent();
  }

  /** Returns the width of lines in pixels; 0 for no lines. */
  public double lineWidth() {
    return values.find(LINE_WIDTH).orElse(look(values).lineWidth());
  }

  /** Returns what is drawn on finished pictures: some of {@link #LABELS}. */
  public Set<String> labels() {
    return Set.copyOf(StageTypes.labels(get(LABEL)));
  }

  /** Returns what to read from the model. */
  public ModelOptions options() {
    return options;
  }

  /** Returns this stage, seen from a direction instead of by a camera of the model or an eye. */
  public Stage seenFrom(View newView) {
    OptionValues changed =
        values
            .with(CAMERA, Optional.empty())
            .with(EYE, Optional.empty())
            .with(TARGET, Optional.empty())
            .with(VIEW, newView);
    return new Stage(changed, options);
  }

  /** Returns this stage, which frames the model if a camera of the model would count. */
  public Stage framed() {
    return isFramed() ? this : seenFrom(View.DEFAULT);
  }

  /** Returns this stage under another sky. */
  public Stage under(Sky newSky) {
    return with(SKY, newSky.name())
        .with(SKY_INTENSITY, newSky.intensity())
        .with(SKY_ROTATION, newSky.rotation())
        .with(SUN, newSky.sun());
  }

  /**
   * Returns this stage before a color of the screen, which finished pictures show behind the model.
   *
   * @param color linear, each component in [0,1]
   */
  public Stage onBackground(Rgb color) {
    if (!CssColor.isOnScreen(color)) {
      throw new IllegalArgumentException(
          "background: expected components from 0 to 1, found " + color);
    }
    return with(BACKGROUND, CssColor.text(color));
  }

  /** Returns this stage with other options for reading the model. */
  public Stage reading(ModelOptions newOptions) {
    return new Stage(values, newOptions);
  }

  /**
   * Returns a picture of a scene with the lines that its settings ask for, and the labels of its
   * stage: the same picture if there are none. Cameras that bend straight lines show no lines.
   * Labels that have no room are left out.
   *
   * @param picture in linear light, of the size of the settings' frame or crop
   */
  public static Image withDrawing(SceneFile file, Image picture) {
    return PictureDrawing.of(file.parsed(), note -> {})
        .onLight(file.scene(), Optional.empty(), picture);
  }

  /** Returns the absolute paths of the model and, if it has one, the sky's picture. */
  public List<Path> files(Path model) {
    Path absolute = model.toAbsolutePath().normalize();
    return sky().picture().map(picture -> List.of(absolute, picture)).orElse(List.of(absolute));
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Stage that
        && values.equals(that.values)
        && options.equals(that.options);
  }

  @Override
  public int hashCode() {
    return Objects.hash(values, options);
  }

  @Override
  public String toString() {
    return "Stage" + values + " of " + options;
  }
}
