package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.DecodedPictures;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.scenefile.internal.FileHashes;
import io.github.lumbre.scenefile.internal.LateHash;
import io.github.lumbre.scenefile.internal.LoneModel;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.ModelParser.Source;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.Surroundings;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads a model once, and the scene around it as if it were in a file that names the model. */
final class ReadModel implements LoneModel {
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
    problems =
        new Problems(
            String.valueOf(source.file().getFileName()),
            Optional.of(WrittenSurroundings.SKY)); // Nothing else around it can be wrong.
    place = new ModelPlace.OfFile(problems);
    Allowance allowance = new Allowance(parser.settings().limits());
    // No field, so that it does not fill the memory while the hierarchy is built.
    Optional<byte[]> known = source.imported().map(Imported::glb).or(source::content);
    byte[] content =
        known.isPresent()
            ? known.get()
            : LoneModels.content(source.file(), parser.settings().limits().bytes());
    allowance.addBytes(content.length).ifPresent(e -> place.problemPlace().error(Kind.LIMIT, e));
    problems.throwIfAny();
    data =
        new AssetData(textPath(), hash, allowance, Map.of(), List.of(), Optional.empty());
    data.note(name(), source.imported().map(Imported::identity).orElse(content));
    model = read(content);
  }

  private Path textPath() {
    return source.folder().resolve(source.file().getFileName());
  }

  private String name() {
    return AssetData.slashed(source.folder().relativize(source.file()));
  }

  private Model read(byte[] content) throws SceneFormatException, IOException {
    ModelOptions options = source.options().limitedTo(left());
    ModelFolder others =
        source
            .others()
            .map(data::counted)
            .orElseGet(() -> data.ownFolderOf(name(), options));
    try {
      ModelOptions uncut =
          options.with(ModelOption.SECTION, List.of()).with(ModelOption.EXPLODE, 0.);
      // The ending chooses the format.
      String name = source.imported().isPresent() ? name() + ".glb" : name();
      Model read = ModelReader.readPose(name, content, others, uncut);
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
    JsonNode root = JsonNode.read(text, problems, Limits.NONE);
    SceneReader world =
        new SceneReader(
            root,
            new AssetTable(root, parser.isLenient()),
            data,
            settings,
            parser.textures(),
            parser.kernel(),
            "",
            Optional.of(new ModelObjects.Known(shown, place, decoded)));
    if (parser.isSearchedLater()) {
      world.searchLater();
    }
    world.read(settings.aspect(), Optional.empty());
    problems.throwIfAny();
    Scene scene = world.scene(Optional.empty());
    SceneChecks.requireNumbers(scene, settings, problems);
    SceneChecks.warnOfLines(scene, settings, new ProblemPlace(problems, () -> "lines"));
    return new ParsedScene(
        scene,
        settings,
        problems.warnings(),
        hash.value(),
        new FileHashes(LateHash.of(text), data.hashes()),
        world.contents(),
        world.origins(),
        Optional.of(new SceneText(text, textPath())),
        Optional.of(ModelContents.of(shown, world.surfaces(), around)),
        source.imported());
  }

  @Override
  public ParsedScene seenIn(Model shown, Surroundings around, ParsedScene built) {
    byte[] text = text(around);
    return new ParsedScene(
        built.scene().seenBy(around.camera().placed(built.settings().aspect())),
        built.settings(),
        built.warnings(),
        new LateHash(() -> hashOf(text)),
        new FileHashes(LateHash.of(text), built.files().assets()),
        built.contents(),
        built.origins(),
        Optional.of(new SceneText(text, textPath())),
        built.model().map(same -> ModelContents.of(shown, same.surfaces(), around)),
        built.imported());
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
}
