package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.Limits;
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
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.internal.CameraPose;
import io.github.lumbre.scenefile.internal.FileHashes;
import io.github.lumbre.scenefile.internal.LoneModel;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.ModelParser.Source;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import io.github.lumbre.scenefile.internal.SceneContents;
import io.github.lumbre.scenefile.internal.Surroundings;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.internal.ClearSky;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Builds the scene around a model of the model that was read, once. */
final class ReadModel implements LoneModel {
  /** The name of the sky, and the place of its problems. */
  static final String SKY = "sky";

  /** The name of the sun in a clear sky. */
  static final String SUN = "sun";

  /** The name of the ground and of its material. */
  static final String GROUND = "ground";

  /** The reflectance of the ground. */
  private static final double GROUND_GRAY = .6;

  private static final String NOTHING = "nothing of the model is visible in this frame";

  private final SceneParser parser;
  private final Source source;
  private final Problems problems;
  private final ContentHash hash = new ContentHash();
  private final AssetData data;
  private final ModelPlace place;
  private final Model model;

  ReadModel(SceneParser parser, Source source) throws SceneFormatException, IOException {
    this.parser = parser;
    this.source = source;
    problems = new Problems(String.valueOf(source.file().getFileName()), true);
    place = new ModelPlace.OfFile(problems);
    Allowance allowance = new Allowance(parser.settings().limits());
    byte[] content = source.content();
    allowance.addBytes(content.length).ifPresent(e -> place.problemPlace().error(Kind.LIMIT, e));
    problems.throwIfAny();
    data = new AssetData(textPath(), hash, allowance, Map.of(), List.of());
    data.note(name(), content);
    model = read();
  }

  private Path textPath() {
    return source.folder().resolve(source.file().getFileName());
  }

  private String name() {
    return AssetData.slashed(source.folder().relativize(source.file()));
  }

  private Model read() throws SceneFormatException, IOException {
    ModelOptions options = source.options().limitedTo(left());
    ModelFolder others =
        source
            .others()
            .map(data::counted)
            .orElseGet(() -> data.ownFolderOf(name(), options));
    try {
      ModelOptions uncut = options.with(ModelOption.SECTION, List.of());
      Model read = ModelReader.readPose(name(), source.content(), others, uncut);
      if (!source.isFrame()) {
        read.requireSurface();
      }
      return read;
    } catch (ModelFormatException e) {
      throw failure(e);
    }
  }

  @Override
  public Model model() {
    return model;
  }

  @Override
  public Limits left() {
    return data.allowance().left();
  }

  @Override
  public long memory() {
    return data.allowance().memory();
  }

  @Override
  public void requireMeasurable(Bounds3 box) throws SceneFormatException {
    ShapeReader.isMeasurable(place.problemPlace(), box);
    problems.throwIfAny();
  }

  @Override
  public SceneFormatException failure(Kind kind, String path, String message) {
    problems.error(kind, () -> path, message);
    return problems.exception();
  }

  @Override
  public SceneFormatException failure(ModelFormatException e) {
    place.error(e);
    return problems.exception();
  }

  @Override
  public void keepFiles() {
    hash.keepFiles();
  }

  @Override
  public ParsedScene scene(Model shown, Surroundings around, DecodedPictures decoded)
      throws SceneFormatException {
    RenderSettings settings = parser.settings().changed(around.settings(), "size", problems);
    byte[] text = text(around);
    hash.text(text);
    PlacedParts parts = new PlacedParts();
    if (around.hasGround()) {
      addGround(around, parts);
    }
    ModelParts models = new ModelParts(parts, data.allowance(), parser.kernel(), decoded);
    models.add(shown, ModelParts.Placement.alone(place));
    if (!shown.hasSurface()) {
      place.warn(NOTHING);
    }
    addSky(around.sky(), parts);
    problems.throwIfAny();
    Scene scene =
        parts.scene(
            PlacedCamera.placed(around.cameras(), settings.aspect()),
            settings.poses(),
            Optional.empty(),
            parser.kernel(),
            Optional.empty());
    SceneChecks.requireNumbers(scene, settings, problems);
    SceneChecks.warnOfLines(scene, settings, new ProblemPlace(problems, () -> "lines"));
    return new ParsedScene(
        scene,
        settings,
        problems.warnings(),
        hash.value(),
        new FileHashes(Sha256.of(text), data.hashes()),
        contents(around, models),
        parts.origins(List.of(), List.of()),
        Optional.of(new SceneText(text, textPath())),
        Optional.of(ModelContents.of(shown, models.surfaces(), around)));
  }

  @Override
  public ParsedScene seenIn(Surroundings around, ParsedScene built) {
    byte[] text = text(around);
    return new ParsedScene(
        built.scene().seenBy(around.camera().placed(built.settings().aspect())),
        built.settings(),
        built.warnings(),
        hashOf(text),
        new FileHashes(Sha256.of(text), built.files().assets()),
        built.contents(),
        built.origins(),
        Optional.of(new SceneText(text, textPath())),
        built.model().map(contents -> contents.titled(around.title())));
  }

  @Override
  public byte[] text(Surroundings around) {
    return new WrittenSurroundings(around, source.folder())
        .scene(source.file())
        .toString()
        .getBytes(StandardCharsets.UTF_8);
  }

  @Override
  public String hashOf(byte[] text) {
    return hash.over(text);
  }

  private static void addGround(Surroundings around, PlacedParts parts) {
    Vec3 place = new Vec3(0, around.box().min().y(), 0);
    Plane plane = new Plane(Transform.translation(place), false);
    Material material = groundMaterial(around);
    Origin origin = new Origin(GROUND, GROUND);
    parts.add(origin, origin, "", scene -> scene.add(plane, material));
  }

  /** Returns the material of the ground. */
  static Material groundMaterial(Surroundings around) {
    Texture<Rgb> gray = Texture.constant(Rgb.gray(GROUND_GRAY));
    return around.settings().transparent() ? new ShadowCatcher(gray) : new Matte(gray);
  }

  private void addSky(Surroundings.Sky sky, PlacedParts parts) {
    ProblemPlace place = new ProblemPlace(problems, () -> SKY);
    if (sky.intensity() == 0) {
      place.warn("the light emits nothing");
    }
    Rgb radiance = Rgb.gray(sky.intensity());
    Frame axes = new CameraPose(Vec3.ZERO, new Vec3(0, sky.rotation(), 0)).axes();
    if (sky.hasSun()) {
      ClearSky clear = new ClearSky(sky.azimuth(), sky.elevation());
      add(SKY, parser.textures().clear(axes, radiance, clear), parts);
      add(SUN, parser.textures().sun(axes, radiance, clear), parts);
      return;
    }
    Optional<EnvironmentLight> light =
        sky.picture().isPresent()
            ? picture(place, sky.picture().get())
                .map(picture -> parser.textures().dome(axes, radiance, picture))
            : Optional.of(
                sky.name().equals("studio")
                    ? parser.textures().studio(axes, radiance)
                    : EnvironmentLight.uniform(radiance));
    light.ifPresent(made -> add(SKY, made, parts));
  }

  private static void add(String name, EnvironmentLight light, PlacedParts parts) {
    parts.add(new Origin(name, name), Origin.NONE, "", scene -> scene.add(light));
  }

  private Optional<Picture> picture(ProblemPlace place, Path picture) {
    PictureDecoder decoder = new PictureDecoder(data.allowance(), parser.isLenient());
    String name = AssetData.slashed(source.folder().relativize(picture));
    Filter filter = parser.textures().filter(Filter.BILINEAR);
    return data.file(place, name).flatMap(content -> decoder.read(content, filter));
  }

  private static SceneContents contents(Surroundings around, ModelParts models) {
    int ground = around.hasGround() ? 1 : 0;
    return new SceneContents(
        around.camera().type(),
        ground + models.count(),
        models.meshes(),
        models.triangles(),
        models.points(),
        (around.sky().hasSun() ? 2 : 1) + models.lights(),
        ground + models.materials(),
        models.pictures() + (around.sky().picture().isPresent() ? 1 : 0));
  }
}
