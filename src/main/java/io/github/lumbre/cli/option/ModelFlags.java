package io.github.lumbre.cli.option;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.internal.ModelReach;
import io.github.lumbre.parser.Stage;
import io.github.lumbre.parser.Stage.Sky;
import io.github.lumbre.parser.Stage.View;
import io.github.lumbre.parser.internal.Look;
import io.github.lumbre.parser.internal.ModelSequence.Motion;
import io.github.lumbre.scene.Setting;
import java.lang.reflect.Field;
import java.nio.file.Path;
import java.time.OffsetDateTime;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeFormatterBuilder;
import java.time.format.DateTimeParseException;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags for a model file that is rendered by itself. */
@Command(optionListHeading = Headings.MODEL)
public final class ModelFlags extends Flags {
  private static final String SKY = "sky";
  private static final String TRANSPARENT = "transparent";

  /** A color without the sign before it, which a shell may take for a comment. */
  private static final String HEXADECIMAL = "[0-9a-fA-F]{6}";

  /** A time with a zone in the forms of ISO 8601: Z, +02:00, +0200 and +02. */
  private static final DateTimeFormatter TIME =
      new DateTimeFormatterBuilder()
          .parseCaseInsensitive()
          .append(DateTimeFormatter.ISO_LOCAL_DATE_TIME)
          .appendPattern("[XXX][X]")
          .toFormatter(Locale.ROOT);

  @Option(
      names = "--camera",
      paramLabel = "NAME",
      description = "Camera of the file to use (the first, if it has one).")
  private Optional<String> camera;

  @Option(
      names = "--view",
      paramLabel = "NAME|AZ,EL",
      description =
          "Look from front, back, left, right, top, bottom or iso, or from an azimuth and"
              + " an elevation in degrees (30,20 without a camera in the file).")
  private Optional<String> view;

  @Option(
      names = "--fov",
      paramLabel = "DEGREES",
      description = "Vertical angle of view with --view (35).")
  private Optional<Double> fov;

  @Option(
      names = "--sky",
      paramLabel = "NAME|FILE",
      description =
          "Light from studio, white, sun (a clear day), or a latitude-longitude picture: HDR,"
              + " OpenEXR, PFM, or PNG, JPEG and the other formats of textures (studio).")
  private Optional<String> sky;

  @Option(
      names = "--sun",
      paramLabel = "AZ,EL|LAT,LON@TIME",
      description =
          "Place of the sun with --sky sun: azimuth as of --view, 0 in front, and elevation from 0"
              + " to 90, in degrees (-40,35); or a latitude, an eastern longitude and a time such"
              + " as 2026-06-21T12:00Z, where --view front looks north.")
  private Optional<String> sun;

  @Option(
      names = "--sky-intensity",
      paramLabel = "FACTOR",
      description = "Factor of the sky's radiance (1).")
  private Optional<Double> skyIntensity;

  @Option(
      names = "--sky-rotation",
      paramLabel = "DEGREES",
      description = "Rotation of the sky about the vertical axis (0).")
  private Optional<Double> skyRotation;

  @Option(
      names = "--ground",
      description =
          "Put the model on an infinite gray floor. If the background is transparent, only its"
              + " shadow is seen.")
  private boolean ground;

  @Option(
      names = "--background",
      paramLabel = "COLOR",
      description =
          "Show sky, transparent, or a color behind it: #rrggbb or a CSS name such as white (sky)."
              + " In PNG and JPEG it is this very color, whatever --exposure and --tonemap are.")
  private Optional<String> background;

  @Option(
      names = "--look",
      paramLabel = "LOOK",
      description =
          "Show the shape alone: clay (matte, light gray), lines (black on white: silhouettes,"
              + " creases and borders), or clay,lines.")
  private Optional<String> look;

  @Option(names = "--line-width", paramLabel = "PIXELS", description = "Width of the lines (1.5).")
  private Optional<Double> lineWidth;

  @Option(
      names = "--crease",
      paramLabel = "DEGREES",
      description = "Angle between two faces from which on a line is drawn between them (30).")
  private Optional<Double> crease;

  @Option(
      names = "--labels",
      paramLabel = "LIST",
      description =
          "Draw labels on the picture: view (its name), axes, scale, parts (names), size"
              + " (dimensions of the box around the model), box, or all. Separated by commas.")
  private Optional<String> labels;

  @Option(
      names = "--pose",
      paramLabel = "NAME@SECONDS",
      description = "Pose of an animation at a time (the rest pose).")
  private Optional<String> pose;

  @Option(
      names = "--variant",
      paramLabel = "NAME",
      description = "Material variant to use (the default materials).")
  private Optional<String> variant;

  @Option(
      names = "--hide",
      paramLabel = "PART",
      description =
          "Leave out a node, object, group or solid, or 'piece N' in a file without them; '*'"
              + " stands for any text. Repeatable; 'lumbre check' lists the parts.")
  private List<String> hidden = List.of();

  @Option(
      names = "--highlight",
      paramLabel = "PART",
      description = "Show a part in its color, or in orange, and all others pale. Repeatable.")
  private List<String> highlighted = List.of();

  @Option(
      names = "--section",
      paramLabel = "PLANE",
      description =
          "Cut the model by a plane: x=0.5 in the file's unit, y=50%%, -z=2 to remove the other"
              + " side, or a point and a normal 0,0,1/1,1,0. Repeatable: two remove a quarter.")
  private List<String> sections = List.of();

  @Option(
      names = "--up",
      paramLabel = "y|z",
      description = "Axis of the file that points up (y; glTF and 3MF: as the file states).")
  private Optional<String> up;

  @Option(
      names = "--unit",
      paramLabel = "LENGTH",
      description = "Length of the file's unit (1; glTF and 3MF: as the file states, in meters).")
  private Optional<Double> unit;

  @Option(
      names = "--assets",
      paramLabel = "DIR",
      description =
          "Further folder from which textures and buffers that the model names may come."
              + " Repeatable.")
  private List<Path> assets = List.of();

  @Option(
      names = "--points",
      paramLabel = "RADIUS",
      description = "Radius of points, in the file's unit (by their density).")
  private Optional<Double> points;

  /**
   * Returns the camera, sky, ground and background of the model.
   *
   * @throws ParameterException that names the flag, if a value is wrong
   */
  public Stage stage() {
    Optional<View> from = view.map(this::view);
    double angle = fov.orElse(Stage.DEFAULT_FOV);
    require(
        angle > 0 && angle < 180, "--fov: expected more than 0 and less than 180, found " + angle);
    require(camera.isEmpty() || from.isEmpty(), "--camera and --view: expected only one of them");
    Look shown = look.map(this::look).orElse(Look.OF_FILE);
    require(
        !shown.isDrawing() || !ground,
        "--ground: cannot be combined with --look lines, which has no shadows");
    return new Stage(
        camera,
        from,
        angle,
        placed(sky(sky.orElse(shown.sky()))),
        ground,
        background.isPresent() ? background.flatMap(this::color) : shown.background(),
        background.filter(TRANSPARENT::equalsIgnoreCase).isPresent(),
        lineSetting("--line-width", lineWidth, Setting.LINE_WIDTH, shown, shown.lineWidth()),
        lineSetting(
            "--crease", crease, Setting.CREASE_ANGLE, shown, Setting.CREASE_ANGLE.missing()),
        shownLabels(),
        options().looking(shown.materials()));
  }

  /**
   * Requires that no folder of files is given, as for a model from standard input.
   *
   * @throws ParameterException if one is
   */
  void requireNoAssets() {
    require(
        assets.isEmpty(),
        "--assets: cannot be used with a model from standard input, which names no files");
  }

  private Set<String> shownLabels() {
    if (labels.equals(Optional.of("all"))) {
      return Set.copyOf(Stage.LABELS);
    }
    Set<String> named = new HashSet<>();
    labels.ifPresent(text -> named.addAll(List.of(text.split(",", -1))));
    require(
        Stage.LABELS.containsAll(named),
        "--labels: expected all, or some of "
            + String.join(", ", Stage.LABELS)
            + ", found "
            + labels.orElse(""));
    return named;
  }

  private Look look(String text) {
    try {
      return Look.of(text);
    } catch (IllegalArgumentException e) {
      throw failure("--look: " + e.getMessage());
    }
  }

  private double lineSetting(
      String flag, Optional<Double> value, Setting<Double> setting, Look shown, double missing) {
    require(value.isEmpty() || shown.hasLines(), flag + ": requires --look lines or clay,lines");
    double number = value.orElse(missing);
    require(
        setting.type().accepts(number),
        flag + ": expected " + setting.type().expected() + ", found " + number);
    return number;
  }

  private ModelOptions options() {
    checks().requireFolders("--assets", assets);
    unit.ifPresent(length -> length("--unit", length));
    up.ifPresent(axis -> require(isAxis(axis), "--up: expected y or z, found " + axis));
    ModelOptions options =
        new ModelOptions(pose.map(this::pose), variant, Up.Y, 1)
            .oriented(
                up.map(axis -> axis.equalsIgnoreCase("z") ? Up.Z : Up.Y),
                unit.map(OptionalDouble::of).orElseGet(OptionalDouble::empty))
            .withAssets(assets)
            .hiding(hidden)
            .highlighting(highlighted);
    return cut(
        points
            .map(radius -> options.withPointRadius(length("--points", radius)))
            .orElse(options));
  }

  private static boolean isAxis(String name) {
    return name.equalsIgnoreCase("y") || name.equalsIgnoreCase("z");
  }

  private ModelOptions cut(ModelOptions options) {
    try {
      return options.cutBy(sections);
    } catch (IllegalArgumentException e) {
      throw failure("--section: " + e.getMessage());
    }
  }

  private double length(String flag, double length) {
    require(
        length >= ModelReach.SMALLEST && length <= ModelReach.LARGEST,
        flag + ": expected a number from 1e-100 to 1e100, found " + length);
    return length;
  }

  private View view(String text) {
    return view("--view", text);
  }

  private View view(String flag, String text) {
    try {
      return View.of(text);
    } catch (IllegalArgumentException e) {
      throw failure(flag + ": " + e.getMessage());
    }
  }

  private Sky sky(String name) {
    try {
      return new Sky(name, skyIntensity.orElse(1.), skyRotation.orElse(0.));
    } catch (IllegalArgumentException e) {
      throw failure("--sky-" + e.getMessage());
    }
  }

  /** Returns a sky with its sun where the flag says. */
  private Sky placed(Sky of) {
    if (sun.isEmpty()) {
      return of;
    }
    require(of.name().equals("sun"), "--sun: requires --sky sun");
    View place = sun.get().indexOf('@') < 0 ? highSun(sun.get()) : sunAt(sun.get());
    return new Sky(of.name(), of.intensity(), of.rotation(), place);
  }

  private View highSun(String text) {
    View place = view("--sun", text);
    require(
        place.elevation() >= 0,
        "--sun: expected an elevation from 0 to 90, found " + place.elevation());
    return place;
  }

  /** Returns the sun's place for a latitude, a longitude and a time. */
  private View sunAt(String text) {
    int at = text.indexOf('@');
    String[] place = text.substring(0, at).split(",", -1);
    require(place.length == 2, "--sun: expected LATITUDE,LONGITUDE@TIME, found " + text);
    double latitude = number("--sun", place[0]);
    double longitude = number("--sun", place[1]);
    View found = sunAt(latitude, longitude, text.substring(at + 1));
    require(
        found.elevation() >= 0,
        String.format(
            Locale.ROOT,
            "--sun: expected a time when the sun is up, found an elevation of %.2f degrees",
            found.elevation()));
    return found;
  }

  private View sunAt(double latitude, double longitude, String time) {
    try {
      return Sky.sunAt(latitude, longitude, OffsetDateTime.parse(time, TIME).toInstant());
    } catch (DateTimeParseException e) {
      throw failure("--sun: expected a time such as 2026-06-21T12:00Z, found " + time);
    } catch (IllegalArgumentException e) {
      throw failure("--sun: " + e.getMessage());
    }
  }

  private Pose pose(String text) {
    int at = text.lastIndexOf('@');
    require(at >= 0, "--pose: expected NAME@SECONDS, such as " + text + "@0, found " + text);
    double seconds = number("--pose", text.substring(at + 1));
    require(seconds >= 0, "--pose: expected a time of at least 0 s, found " + seconds);
    return new Pose(text.substring(0, at), seconds);
  }

  private Optional<Rgb> color(String text) {
    if (text.equalsIgnoreCase(SKY) || text.equalsIgnoreCase(TRANSPARENT)) {
      return Optional.empty();
    }
    try {
      return Setting.BACKPLATE.type().parse(text.matches(HEXADECIMAL) ? "#" + text : text);
    } catch (IllegalArgumentException e) {
      throw failure(
          "--background: " + e.getMessage().replace("expected ", "expected sky, transparent, "));
    }
  }

  private double number(String flag, String text) {
    try {
      double number = Double.parseDouble(text);
      if (Double.isFinite(number)) {
        return number;
      }
    } catch (NumberFormatException e) {
      throw failure(flag + ": expected a number, found " + text);
    }
    throw failure(flag + ": expected a finite number, found " + text);
  }

  /**
   * Requires that no flag is given which a motion sets.
   *
   * @throws ParameterException that names the flag
   */
  void requireSuits(Motion motion) {
    require(
        motion.turns() == 0 || camera.isEmpty(),
        "--turntable: cannot be combined with --camera; --view sets the first view");
    require(
        motion.turns() > 0 || pose.isEmpty(),
        "--animation: cannot be combined with --pose, which is one picture of an animation");
  }

  /**
   * Requires that no flag for models is given.
   *
   * @throws ParameterException that names the first one that is
   */
  public void requireNone() {
    for (OptionSpec option : spec.commandLine().getParseResult().matchedOptions()) {
      require(
          !(option.userObject() instanceof Field field)
              || field.getDeclaringClass() != ModelFlags.class,
          option.longestName() + ": requires a model file: " + Models.NAMES);
    }
  }

  private ParameterException failure(String message) {
    return new ParameterException(spec.commandLine(), message);
  }
}
