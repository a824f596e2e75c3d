package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.DecodedPictures;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelAnimation;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.model.section.Sections;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.Stage.View;
import io.github.lumbre.scenefile.internal.CameraPose;
import io.github.lumbre.scenefile.internal.FileHashes;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.SceneContents;
import io.github.lumbre.scenefile.internal.ShownLabels;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.internal.ClearSky;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A model on its stage: the scene around it is built of the model that was read, once. Mutable;
 * confined to one thread.
 */
final class StagedModel {
  /** The name of the sky, and the place of its problems. */
  static final String SKY = "sky";

  /** The name of the sun in a clear sky. */
  static final String SUN = "sun";

  /** The name of the ground and of its material. */
  static final String GROUND = "ground";

  /** The reflectance of the ground. */
  private static final double GROUND_GRAY = .6;

  private static final String NOTHING = "nothing of the model is visible in this frame";

  private static final int MAX_TRACE_DEPTH = 12;

  private final Stage stage;
  private final Path folder;
  private final Path file;
  private final boolean isFrame;
  private final Problems problems;
  private final SceneHash hash = new SceneHash();
  private final AssetData data;
  private final ModelPlace place;
  private final Model model;

  /** Of the whole model, so that a cut one is seen from the same place, or of an animation. */
  private Framing framing;

  /**
   * Reads a model.
   *
   * @param folder where asset paths start; contains the model and the sky's picture
   * @param file absolute path of the model
   * @param content of the file
   * @param others has the files that the model names; empty for those in its own folder and in
   *     those of its options
   * @param isFrame whether the model may have nothing to show, in one frame of an animation
   * @throws SceneFormatException if the model cannot be used
   * @throws IOException if the thread is interrupted
   */
  StagedModel(
      Stage stage,
      Path folder,
      Path file,
      byte[] content,
      Optional<ModelFolder> others,
      Limits limits,
      boolean isFrame)
      throws SceneFormatException, IOException {
    this.stage = stage;
    this.folder = folder;
    this.file = file;
    this.isFrame = isFrame;
    problems = new Problems(String.valueOf(file.getFileName()), true);
    place = new ModelPlace.OfFile(problems);
    Allowance allowance = new Allowance(limits);
    allowance.addBytes(content.length).ifPresent(e -> place.spot().error(Kind.LIMIT, e));
    problems.throwIfAny();
    String name = WrittenStage.slashed(folder.relativize(file));
    data = new AssetData(folder.resolve(file.getFileName()), hash, allowance, Map.of(), List.of());
    data.note(name, content);
    ModelOptions options = stage.options().limitedTo(data.allowance().left());
    Model whole =
        read(
            name,
            content,
            others.map(data::counted).orElseGet(() -> data.ownFolderOf(name, options)));
    requireSky();
    framing = Framing.of(whole);
    ShapeReader.isMeasurable(place.spot(), new Bounds3(framing.min(), framing.max()));
    problems.throwIfAny();
    model = cut(whole);
  }

  /** Makes cameras have something else in their frames, on whose lowest point the ground is. */
  void frame(Framing other) {
    framing = other;
  }

  /**
   * Keeps the files in memory, for {@link #hashOf} and {@link #seenFrom(Stage, SceneFile,
   * SceneParser)}.
   */
  void keepFiles() {
    hash.keepFiles();
  }

  private Model cut(Model whole) throws SceneFormatException {
    try {
      return Sections.cut(whole, stage.options().limitedTo(data.allowance().left()), isFrame);
    } catch (ModelFormatException e) {
      place.error(e);
      throw problems.exception();
    }
  }

  private Model read(String name, byte[] content, ModelFolder others)
      throws SceneFormatException, IOException {
    try {
      ModelOptions options = stage.options().limitedTo(data.allowance().left());
      ModelOptions uncut = options.with(ModelOption.SECTION, List.of());
      Model read = ModelReader.readPose(name, content, others, uncut);
      if (!isFrame) {
        read.requireSurface();
      }
      return read;
    } catch (ModelFormatException e) {
      place.error(e);
      throw problems.exception();
    }
  }

  /** Returns whether the model has a surface to show. */
  boolean hasSurface() {
    return model.hasSurface();
  }

  /** Requires the sky's picture, so that a problem names it as the stage does. */
  private void requireSky() throws SceneFormatException {
    Path picture = stage.sky().picture().orElse(file);
    if (!Files.isRegularFile(picture) && stage.sky().picture().isPresent()) {
      String found = Files.isDirectory(picture) ? "a folder" : "none";
      problems.error(
          Kind.ASSET,
          () -> SKY,
          "expected a file, found " + found + " at " + PrintableText.quoted(stage.sky().name()));
      throw problems.exception();
    }
  }

  /** Returns the scene. Call it once. */
  SceneFile scene(SceneParser parser) throws SceneFormatException {
    return scene(parser, new DecodedPictures());
  }

  /**
   * Returns the scene. Call it once.
   *
   * @param decoded the pictures of other poses of the model
   */
  SceneFile scene(SceneParser parser, DecodedPictures decoded) throws SceneFormatException {
    StageCamera camera = camera(stage, parser.settings().frameAspect(), framing);
    RenderSettings settings = parser.settings().changed(settings(camera, parser), "size", problems);
    byte[] text = text(stage, camera, parser);
    hash.text(text);
    Optional<String> moving = movingCamera(stage);
    List<StageCamera> cameras = moving.isPresent() ? inPoses(moving.get()) : List.of(camera);
    SceneParts parts = new SceneParts();
    if (stage.ground()) {
      addGround(parts);
    }
    ModelParts models = new ModelParts(parts, data.allowance(), parser.kernel(), decoded);
    models.add(model, ModelParts.Placement.alone(place));
    if (!model.hasSurface()) {
      place.warn(NOTHING);
    }
    addSky(parts, parser);
    problems.throwIfAny();
    Scene scene =
        parts.scene(
            StageCamera.placed(cameras, settings.aspect()),
            settings.poses(),
            Optional.empty(),
            parser.kernel(),
            Optional.empty());
    SceneParser.requireNumbers(scene, settings, problems);
    SceneParser.warnOfLines(scene, settings, new Spot(problems, () -> "lines"));
    return new ParsedScene(
        scene,
        settings,
        problems.warnings(),
        hash.value(),
        new FileHashes(Sha256.of(text), data.hashes()),
        contents(camera, models),
        parts.origins(List.of(), List.of()),
        Optional.of(sceneText(text)),
        Optional.of(
            ModelContents.of(
                model,
                models.surfaces(),
                ShownLabels.of(stage, model),
                framing.min(),
                framing.max())));
  }

  /** Returns the name of the model's camera that moves; empty if the camera stands still. */
  private Optional<String> movingCamera(Stage of) throws SceneFormatException {
    try {
      Optional<ModelCamera> own = StageCamera.own(of, model);
      if (own.isEmpty()) {
        return Optional.empty();
      }
      String name = ModelContents.cameraNames(model).get(model.cameras().indexOf(own.get()));
      boolean isMoving = inPoses(name).stream().distinct().count() > 1;
      return isMoving ? Optional.of(name) : Optional.empty();
    } catch (ModelFormatException e) {
      place.error(e);
      throw problems.exception();
    }
  }

  /** Returns a camera of the model in each pose. */
  private List<StageCamera> inPoses(String name) throws SceneFormatException {
    try {
      return StageCamera.inPoses(model, name, Transform.IDENTITY);
    } catch (ModelFormatException e) {
      place.error(e);
      throw problems.exception();
    }
  }

  /** Returns the text of the scene: one line, which the header of a checkpoint file can hold. */
  private byte[] text(Stage of, StageCamera camera, SceneParser parser)
      throws SceneFormatException {
    WrittenStage written = new WrittenStage(of, camera, movingCamera(of), framing.min().y());
    JsonObject scene = written.scene(folder, file, settings(camera, parser));
    return scene.toString().getBytes(StandardCharsets.UTF_8);
  }

  private SceneText sceneText(byte[] text) {
    return new SceneText(text, folder.resolve(file.getFileName()));
  }

  /** Returns the text of the scene on another stage, whose model has the same pose. */
  byte[] textOf(Stage of, SceneParser parser) throws SceneFormatException {
    return text(of, camera(of, parser.settings().frameAspect(), framing), parser);
  }

  /**
   * Returns the hash of a scene around this model, once one has been built with the files kept.
   *
   * @param text of the scene
   */
  String hashOf(byte[] text) {
    return hash.over(text);
  }

  /**
   * Returns the scene on a stage that differs in its view alone, once one has been built with the
   * files kept. The scenes share everything but the camera.
   */
  SceneFile seenFrom(Stage of, SceneFile built, SceneParser parser) throws SceneFormatException {
    ParsedScene first = ParsedScene.of(built);
    StageCamera camera = camera(of, parser.settings().frameAspect(), framing);
    byte[] text = text(of, camera, parser);
    return new ParsedScene(
        first.scene().seenBy(camera.placed(first.settings().aspect())),
        first.settings(),
        first.warnings(),
        hashOf(text),
        new FileHashes(Sha256.of(text), first.files().assets()),
        first.contents(),
        first.origins(),
        Optional.of(sceneText(text)),
        first.model().map(contents -> contents.labeled(ShownLabels.of(of, model))));
  }

  /**
   * Returns a scene of this model as it is seen from each of some directions.
   *
   * @param frameAspect width over height of the frame into which the model is to fit
   */
  List<Scene> seenFrom(List<View> views, SceneFile scene, double frameAspect)
      throws SceneFormatException {
    return seenFrom(views, scene, frameAspect, framing);
  }

  /**
   * Returns a scene of this model as it is seen from each of some directions by cameras that frame
   * something else.
   */
  List<Scene> seenFrom(List<View> views, SceneFile scene, double frameAspect, Framing of)
      throws SceneFormatException {
    List<Scene> scenes = new ArrayList<>();
    for (View view : views) {
      StageCamera camera = camera(stage.seenFrom(view), frameAspect, of);
      scenes.add(scene.scene().seenBy(camera.placed(scene.settings().aspect())));
    }
    return scenes;
  }

  /** Returns about how many bytes of memory the model and its scene take. */
  long memory() {
    return data.allowance().memory();
  }

  /** Returns what the model's cameras have in their frames. */
  Framing framing() {
    return framing;
  }

  /** Returns whether the camera is one of the model's, so that it needs no framing. */
  boolean hasOwnCamera() throws SceneFormatException {
    try {
      return StageCamera.own(stage, model).isPresent();
    } catch (ModelFormatException e) {
      place.error(e);
      throw problems.exception();
    }
  }

  /** Returns the animations of the model. */
  List<ModelAnimation> animations() {
    return model.animations();
  }

  /** Returns the exception for the model, which cannot be used. */
  SceneFormatException failure(Kind kind, String place, String message) {
    problems.error(kind, () -> place, message);
    return problems.exception();
  }

  private StageCamera camera(Stage of, double frameAspect, Framing framed)
      throws SceneFormatException {
    try {
      return StageCamera.of(of, model, framed, frameAspect);
    } catch (ModelFormatException e) {
      place.error(e);
      throw problems.exception();
    }
  }

  /** Returns the settings. The longer side of the picture is {@link Stage#DEFAULT_WIDTH}. */
  private RenderSettings settings(StageCamera camera, SceneParser parser) {
    double ratio = camera.aspect().orElse((double) Stage.DEFAULT_WIDTH / Stage.DEFAULT_HEIGHT);
    double side = Stage.DEFAULT_WIDTH;
    return parser.settings().missing().toBuilder()
        .size(
            (int) Math.max(1, Math.round(side * Math.min(1, ratio))),
            (int) Math.max(1, Math.round(side / Math.max(1, ratio))))
        .maxTraceDepth(MAX_TRACE_DEPTH)
        .toneCurve(
            stage.options().find(ModelOption.LOOK).isEmpty()
                ? Setting.TONE_MAP.inModels().orElseThrow()
                : Setting.TONE_MAP.missing())
        .set(Setting.LINE_WIDTH, stage.lineWidth())
        .set(Setting.CREASE_ANGLE, stage.creaseDegrees())
        .transparent(stage.transparent())
        .set(Setting.BACKPLATE, stage.background())
        .build();
  }

  private void addGround(SceneParts parts) {
    Plane plane = new Plane(Transform.translation(new Vec3(0, framing.min().y(), 0)), false);
    Material material = groundMaterial(stage);
    Origin origin = new Origin(GROUND, GROUND);
    parts.add(origin, origin, "", scene -> scene.add(plane, material));
  }

  /** Returns the material of the ground. */
  static Material groundMaterial(Stage stage) {
    Texture<Rgb> gray = Texture.constant(Rgb.gray(GROUND_GRAY));
    return stage.transparent() ? new ShadowCatcher(gray) : new Matte(gray);
  }

  private void addSky(SceneParts parts, SceneParser parser) {
    Spot spot = new Spot(problems, () -> SKY);
    if (stage.sky().intensity() == 0) {
      spot.warn("the light emits nothing");
    }
    Rgb radiance = Rgb.gray(stage.sky().intensity());
    Frame axes = new CameraPose(Vec3.ZERO, new Vec3(0, stage.sky().rotation(), 0)).axes();
    if (stage.sky().hasSun()) {
      View place = stage.sky().sun();
      ClearSky clear = new ClearSky(place.azimuth(), place.elevation());
      add(SKY, parser.textures().clear(axes, radiance, clear), parts);
      add(SUN, parser.textures().sun(axes, radiance, clear), parts);
      return;
    }
    Optional<EnvironmentLight> sky =
        stage.sky().picture().isPresent()
            ? picture(spot, parser).map(picture -> parser.textures().dome(axes, radiance, picture))
            : Optional.of(
                stage.sky().name().equals("studio")
                    ? parser.textures().studio(axes, radiance)
                    : EnvironmentLight.uniform(radiance));
    sky.ifPresent(light -> add(SKY, light, parts));
  }

  private static void add(String name, EnvironmentLight light, SceneParts parts) {
    parts.add(new Origin(name, name), Origin.NONE, "", scene -> scene.add(light));
  }

  private Optional<Picture> picture(Spot spot, SceneParser parser) {
    PictureDecoder decoder = new PictureDecoder(data.allowance(), parser.isLenient());
    String name = WrittenStage.slashed(folder.relativize(stage.sky().picture().orElseThrow()));
    Filter filter = parser.textures().filter(Filter.BILINEAR);
    return data.file(spot, name).flatMap(content -> decoder.read(content, filter));
  }

  private SceneContents contents(StageCamera camera, ModelParts models) {
    int ground = stage.ground() ? 1 : 0;
    return new SceneContents(
        camera.type(),
        ground + models.count(),
        models.meshes(),
        models.triangles(),
        models.points(),
        (stage.sky().hasSun() ? 2 : 1) + models.lights(),
        ground + models.materials(),
        models.pictures() + (stage.sky().picture().isPresent() ? 1 : 0));
  }
}
