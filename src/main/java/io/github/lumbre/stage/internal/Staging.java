package io.github.lumbre.stage.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.internal.DecodedPictures;
import io.github.lumbre.model.internal.Explosion;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelAnimation;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelNames;
import io.github.lumbre.model.internal.PartSelection;
import io.github.lumbre.model.section.Sections;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.internal.LoneModel;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.ModelParser;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import io.github.lumbre.scenefile.internal.Surroundings;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A model on its stage: the scene around it is built of the model that was read, once. Mutable;
 * confined to one thread.
 */
public final class Staging {
  private static final int MAX_TRACE_DEPTH = 12;

  private final Stage stage;
  private final ModelParser parser;
  private final LoneModel read;
  private final Model model;

  /** The whole model, so that a cut one is seen from the same place; its parts have moved apart. */
  private final Model whole;

  /** The dimensions of the model before its parts moved apart; empty if they did not. */
  private Optional<Bounds3> assembled;

  /** Of the whole model, or of an animation. */
  private Framing framing;

  /** The height of the films of parallel cameras; empty for those that frame the model. */
  private OptionalDouble film = OptionalDouble.empty();

  Staging(ModelParser parser, Stage stage, ModelParser.Source source)
      throws SceneFormatException, IOException {
    this.stage = stage;
    this.parser = parser;
    read = parser.read(source);
    requireSky();
    Explosion explosion = explosion();
    assembled =
        explosion.isNone() ? Optional.empty() : Optional.of(Framing.of(read.model()).box());
    whole = moved(explosion.assembled(), explosion);
    framing = Framing.of(whole).fittedTo(fitted(stage));
    read.requireMeasurable(framing.box());
    model = moved(cut(explosion.assembled(), source.isFrame()), explosion);
  }

  private Explosion explosion() throws SceneFormatException {
    try {
      return Explosion.of(read.model(), stage.options());
    } catch (ModelFormatException e) {
      throw read.failure(e);
    }
  }

  private Model moved(Model of, Explosion explosion) throws SceneFormatException {
    try {
      return explosion.moved(of);
    } catch (ModelFormatException e) {
      throw read.failure(e);
    }
  }

  /** Returns the part of the model that a stage frames; empty if it frames all of it. */
  private Optional<Framing> fitted(Stage of) throws SceneFormatException {
    Optional<String> part = of.find(Stage.FIT);
    if (part.isEmpty()) {
      return Optional.empty();
    }
    try {
      return Optional.of(
          Framing.of(PartSelection.only(whole, Stage.FIT.name(), part.get())));
    } catch (ModelFormatException e) {
      throw failure(Kind.OPTION, e.location(), PrintableText.escaped(e.detail()));
    }
  }

  /** Makes cameras have something else in their frames, on whose lowest point the ground is. */
  void frame(Framing other) {
    framing = other;
  }

  /** Makes cameras have another pose of the model, whose parts move apart, in their frames, too. */
  void frameWith(Staging other) {
    framing = framing.with(other.framing);
    assembled = assembled.or(() -> other.assembled);
  }

  /** Makes cameras and labels be those of another pose of the model. */
  void frameAs(Staging other) {
    framing = other.framing;
    assembled = other.assembled;
  }

  /**
   * Makes parallel cameras without a scale show the model as large as the one of some stages that
   * shows it smallest.
   */
  void align(List<Stage> stages) throws SceneFormatException {
    double height = 0;
    for (Stage each : stages) {
      try {
        if (camera(each, framing, frameAspect()).lens() instanceof Lens.Orthographic parallel) {
          height = Math.max(height, parallel.height());
        }
      } catch (ModelFormatException e) {
        throw read.failure(e);
      }
    }
    film = height > 0 ? OptionalDouble.of(height) : OptionalDouble.empty();
  }

  /** Keeps the files in memory, for {@link #hashOf} and {@link #seenFrom(Stage, ParsedScene)}. */
  void keepFiles() {
    read.keepFiles();
  }

  private Model cut(Model of, boolean isFrame) throws SceneFormatException {
    try {
      return Sections.cut(of, stage.options().limitedTo(read.left()), isFrame);
    } catch (ModelFormatException e) {
      throw read.failure(e);
    }
  }

  boolean hasSurface() {
    return model.hasSurface();
  }

  /** Requires the sky's picture, so that a problem names it as the stage does. */
  private void requireSky() throws SceneFormatException {
    Stage.Sky sky = stage.sky();
    if (sky.picture().filter(picture -> !Files.isRegularFile(picture)).isPresent()) {
      String found = Files.isDirectory(sky.picture().get()) ? "a folder" : "none";
      throw failure(
          Kind.ASSET,
          "sky",
          "expected a file, found " + found + " at " + PrintableText.quoted(sky.name()));
    }
  }

  /** Returns the scene. Call it once. */
  public ParsedScene scene() throws SceneFormatException {
    return scene(new DecodedPictures());
  }

  /** Returns the scene, with decoded pictures of other poses of the model. Call it once. */
  ParsedScene scene(DecodedPictures decoded) throws SceneFormatException {
    return read.scene(model, around(stage), decoded);
  }

  private Surroundings around(Stage of) throws SceneFormatException {
    try {
      PlacedCamera camera = camera(of, framing, frameAspect());
      Stage.Sky sky = of.sky();
      return new Surroundings(
          camera,
          movingCamera(of),
          new Surroundings.Sky(
              sky.name(),
              sky.picture(),
              sky.intensity(),
              sky.rotation(),
              sky.sun().azimuth(),
              sky.sun().elevation()),
          backplate(of),
          of.get(Stage.GROUND),
          framing.box(),
          assembled,
          of.options(),
          settings(of, camera),
          of.labels(),
          ShownLabels.title(of, model),
          StagedSheet.of(of));
    } catch (ModelFormatException e) {
      throw read.failure(e);
    }
  }

  /** Returns what is behind the model, with its contact shadow unless it stands on a ground. */
  private Optional<Backplate> backplate(Stage of) {
    return of.get(Stage.GROUND)
        ? of.backplate()
        : of.backplate().map(seen -> seen.withShadowOf(framing.box()));
  }

  /**
   * Returns the camera of the model that a stage names, or its first; a camera that has something
   * in its frame if the stage frames the model, or the model has no camera.
   */
  private PlacedCamera camera(Stage of, Framing framed, double frameAspect)
      throws ModelFormatException, SceneFormatException {
    Optional<ModelCamera> own = own(of);
    if (own.isPresent()) {
      if (of.find(Stage.SCALE).isPresent()) {
        throw failure(Kind.OPTION, Stage.SCALE.name(), StagedCamera.PARALLEL);
      }
      PlacedCamera camera = PlacedCamera.of(own.get(), Transform.IDENTITY);
      Lens lens = StagedCamera.zoomed(camera.lens(), of.get(Stage.ZOOM));
      return new PlacedCamera(camera.name(), lens, camera.pose(), camera.aspect());
    }
    try {
      boolean isSame = of.find(Stage.FIT).equals(stage.find(Stage.FIT));
      Framing shown = isSame ? framed : framed.fittedTo(fitted(of));
      OptionalDouble scaled = StagedSheet.film(of, model, frame(of).height());
      OptionalDouble height = scaled.isEmpty() && of.isParallel() ? film : scaled;
      return new StagedCamera(of, shown, frameAspect, model.fromFile(), height).camera();
    } catch (StagedCamera.Unsuited e) {
      throw failure(Kind.OPTION, e.option, e.getMessage());
    }
  }

  /** Returns the camera of the model that a stage uses; empty if the whole model is framed. */
  private Optional<ModelCamera> own(Stage of) throws ModelFormatException {
    Optional<String> name = of.find(Stage.CAMERA);
    if (name.isEmpty()) {
      return model.cameras().stream()
          .findFirst()
          .filter(first -> !first.onlyByName() && !of.isFramed());
    }
    List<String> names = ModelContents.cameraNames(model);
    int index = ModelNames.index("cameras", "a camera", names, name.get());
    return Optional.of(model.cameras().get(index));
  }

  /** Returns the name of the model's camera that moves; empty if the camera stands still. */
  private Optional<String> movingCamera(Stage of)
      throws ModelFormatException, SceneFormatException {
    Optional<ModelCamera> own = own(of);
    if (own.isEmpty()) {
      return Optional.empty();
    }
    String name = ModelContents.cameraNames(model).get(model.cameras().indexOf(own.get()));
    boolean isMoving =
        PlacedCamera.inPoses(model, name, Transform.IDENTITY).stream().distinct().count() > 1;
    if (isMoving && of.get(Stage.ZOOM) != 1) {
      throw failure(
          Kind.OPTION,
          Stage.ZOOM.name(),
          "expected a camera that stands still while the picture is taken, found one that moves:"
              + " state a view");
    }
    return isMoving ? Optional.of(name) : Optional.empty();
  }

  /** Returns the text of the scene on another stage, whose model has the same pose. */
  byte[] textOf(Stage of) throws SceneFormatException {
    return read.text(around(of));
  }

  /**
   * Returns the hash of a scene around this model, once one has been built with the files kept.
   *
   * @param text of the scene
   */
  String hashOf(byte[] text) {
    return read.hashOf(text);
  }

  /**
   * Returns the scene on a stage that differs in its view alone, once one has been built with the
   * files kept. The scenes share everything but the camera.
   */
  ParsedScene seenFrom(Stage of, ParsedScene built) throws SceneFormatException {
    return read.seenIn(model, around(of), built);
  }

  /** Returns the scene, as it is seen from another direction. */
  public Scene seenFrom(View view, SceneFile scene) throws SceneFormatException {
    return seenFrom(view, scene, frameAspect(), framing);
  }

  /**
   * Returns the scene, as it is seen from another direction by a camera that frames something else.
   *
   * @param frameAspect width over height of the frame into which it is to fit
   */
  public Scene seenFrom(View view, SceneFile scene, double frameAspect, Framing of)
      throws SceneFormatException {
    return seenOn(stage.seenFrom(view), scene, frameAspect, of);
  }

  /**
   * Returns the scene, as it is seen by the camera of another stage, which may frame something
   * else.
   *
   * @param frameAspect width over height of the frame into which it is to fit
   */
  public Scene seenOn(Stage other, SceneFile scene, double frameAspect, Framing of)
      throws SceneFormatException {
    try {
      PlacedCamera camera = camera(other, of, frameAspect);
      return scene.scene().seenBy(camera.placed(scene.settings().aspect()));
    } catch (ModelFormatException e) {
      throw read.failure(e);
    }
  }

  public long memory() {
    return read.memory();
  }

  /** Returns the stage on which the model was read. */
  public Stage stage() {
    return stage;
  }

  /** Returns what the model's cameras have in their frames. */
  public Framing framing() {
    return framing;
  }

  /** Returns whether the camera is one of the model's, so that it needs no framing. */
  boolean hasOwnCamera() throws SceneFormatException {
    try {
      return own(stage).isPresent();
    } catch (ModelFormatException e) {
      throw read.failure(e);
    }
  }

  List<ModelAnimation> animations() {
    return model.animations();
  }

  SceneFormatException failure(Kind kind, String place, String message) {
    return read.failure(kind, place, message);
  }

  /** Returns the aspect ratio for which the model is framed. */
  private double frameAspect() {
    return frame(stage).aspect();
  }

  /** Returns the settings for whose frame the model is framed. */
  private RenderSettings frame(Stage of) {
    return parser.changed(
        StagedSheet.sized(
                RenderSettings.builder(), of, Stage.DEFAULT_WIDTH, Stage.DEFAULT_HEIGHT)
            .build());
  }

  /** Returns the settings. The longer side of the picture is {@link Stage#DEFAULT_WIDTH}. */
  private RenderSettings settings(Stage of, PlacedCamera camera) {
    double ratio = camera.aspect().orElse((double) Stage.DEFAULT_WIDTH / Stage.DEFAULT_HEIGHT);
    double side = Stage.DEFAULT_WIDTH;
    return StagedSheet.sized(
            parser.defaults().toBuilder(),
            of,
            (int) Math.max(1, Math.round(side * Math.min(1, ratio))),
            (int) Math.max(1, Math.round(side / Math.max(1, ratio))))
        .maxTraceDepth(MAX_TRACE_DEPTH)
        .toneCurve(
            of.options().find(ModelOption.LOOK).isEmpty()
                ? Setting.TONE_MAP.inModels().orElseThrow()
                : Setting.TONE_MAP.defaultValue())
        .set(Setting.LINE_WIDTH, of.lineWidth())
        .set(Setting.CREASE_ANGLE, of.get(Stage.CREASE))
        .transparent(of.transparent())
        .set(Setting.BACKPLATE, of.background())
        .build();
  }
}
