package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.Release;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.cli.output.LaterStep;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.output.Summary;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.render.checkpoint.FilmPart;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.RenderSettings.Size;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.SceneText;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * The notes in a film's header that commands need to resume and develop it.
 *
 * @param film the file's path, for messages
 */
public record FilmNotes(Path film, FilmHeader header) {
  private static final String SOFTWARE = "software";
  private static final String SCENE = "scene";
  private static final String SCENE_TEXT = "scene-text";
  private static final String SCENE_FOLDER = "scene-folder";
  private static final String OUTPUT = "output";
  private static final String FILES = "files";
  private static final String SAMPLES = "samples";
  private static final String EXPOSURE = "exposure";
  private static final String TONE_CURVE = "tonemap";
  private static final String LINE_WIDTH = Setting.LINE_WIDTH.name();
  private static final String BITS = "bits";
  private static final String LENIENT = "lenient";
  private static final String TARGET_ERROR = "target-error";
  private static final String CONFIDENCE = "confidence";

  public static Map<String, String> of(
      Path scene, SceneFile file, Path output, int bits, boolean lenient, RunBudget budget) {
    RenderSettings settings = file.settings();
    Map<String, String> notes = new LinkedHashMap<>();
    notes.put(SOFTWARE, "Lumbre " + Release.number());
    notes.put(SCENE, scene.toAbsolutePath().normalize().toString());
    file.text()
        .ifPresent(
            text -> {
              notes.put(SCENE_TEXT, new String(text.json(), StandardCharsets.UTF_8));
              notes.put(SCENE_FOLDER, text.path().toAbsolutePath().getParent().toString());
            });
    FilmFiles.text(file.parsed().files()).ifPresent(text -> notes.put(FILES, text));
    notes.put(OUTPUT, output.toAbsolutePath().normalize().toString());
    notes.put(SAMPLES, String.valueOf(settings.samples()));
    notes.put(EXPOSURE, settings.text(Setting.EXPOSURE));
    notes.put(TONE_CURVE, settings.text(Setting.TONE_MAP));
    if (settings.isSet(Setting.LINE_WIDTH)) {
      notes.put(LINE_WIDTH, settings.text(Setting.LINE_WIDTH));
    }
    notes.put(BITS, String.valueOf(bits));
    notes.put(LENIENT, String.valueOf(lenient));
    budget.targetError().ifPresent(error -> notes.put(TARGET_ERROR, String.valueOf(error)));
    notes.put(CONFIDENCE, String.valueOf(budget.confidence()));
    return notes;
  }

  public Path scene() throws TaskException {
    return note(SCENE, FilmNotes::path);
  }

  /**
   * Returns the scene itself, if it was not read from a file.
   *
   * @param scene path of the model file that it is about
   */
  public Optional<SceneText> sceneText(Path scene) throws TaskException {
    if (!header.notes().containsKey(SCENE_TEXT)) {
      return Optional.empty();
    }
    String json = note(SCENE_TEXT, Function.identity());
    // A model that was moved is used from its new folder, or from the folder that was moved with
    // it.
    Path relative = note(SCENE_FOLDER, FilmNotes::path).relativize(scene());
    Path now = scene.toAbsolutePath().normalize();
    Path folder = now.getParent();
    for (int i = 1; i < relative.getNameCount() && now.endsWith(relative); i++) {
      folder = folder.getParent();
    }
    return Optional.of(
        new SceneText(json.getBytes(StandardCharsets.UTF_8), folder.resolve(scene.getFileName())));
  }

  /**
   * Reads the film's scene.
   *
   * @param scene path of the scene file or of the model
   */
  SceneFile read(SceneParser parser, Path scene)
      throws TaskException, SceneFormatException, IOException {
    return read(parser, scene, Optional.empty());
  }

  /**
   * Reads the film's scene.
   *
   * @param scene path of the scene file or of the model
   * @param imported the model, if a program has converted it
   */
  public SceneFile read(SceneParser parser, Path scene, Optional<Imported> imported)
      throws TaskException, SceneFormatException, IOException {
    Optional<SceneText> text = sceneText(scene);
    if (imported.isPresent()) {
      return parser.ofModels().parse(text.orElseThrow(), imported.get());
    }
    return text.isPresent()
        ? parser.parse(text.get().json(), text.get().path())
        : parser.parse(scene);
  }

  private static Path path(String text) {
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw new IllegalArgumentException(FileFailure.reason(e), e);
    }
  }

  /** Returns the picture of the film; empty if it has none, like a merged film. */
  public Optional<Path> output() throws TaskException {
    return header.notes().containsKey(OUTPUT)
        ? Optional.of(note(OUTPUT, FilmNotes::path))
        : Optional.empty();
  }

  /** Returns the header of a merged film, which has no picture of its own. */
  public static FilmHeader ofMerged(FilmHeader header) {
    Map<String, String> notes = new LinkedHashMap<>(header.notes());
    notes.remove(OUTPUT);
    return header.withNotes(notes);
  }

  /**
   * Returns the names of the scene's files that have changed since the film was created. The list
   * is empty if the film has no hashes, like films of older versions.
   */
  public List<String> changedFiles(Path scene, SceneFile now) {
    return Optional.ofNullable(header.notes().get(FILES))
        .map(
            then ->
                FilmFiles.changed(then, now.parsed().files(), String.valueOf(scene.getFileName())))
        .orElse(List.of());
  }

  /** Returns the film's target number of samples per pixel, at least the number it already has. */
  public int samples() throws TaskException {
    int most = header.parts().stream().mapToInt(FilmPart::most).max().orElse(0);
    return Math.max(most, note(SAMPLES, Integer::valueOf));
  }

  /** Returns the film's target error; empty if it has none. */
  public OptionalDouble targetError() throws TaskException {
    return header.notes().containsKey(TARGET_ERROR)
        ? OptionalDouble.of(note(TARGET_ERROR, text -> share(text, Double.MIN_VALUE)))
        : OptionalDouble.empty();
  }

  /** Returns the confidence level of the target error. */
  public double confidence() throws TaskException {
    return header.notes().containsKey(CONFIDENCE)
        ? note(CONFIDENCE, text -> share(text, .5))
        : Budget.CONFIDENCE;
  }

  private static double share(String text, double least) {
    double share = Double.parseDouble(text);
    if (!(share >= least && share < 1)) {
      throw new IllegalArgumentException("expected a fraction below 1, found " + text);
    }
    return share;
  }

  public Exposure exposure() throws TaskException {
    return note(EXPOSURE, Setting.EXPOSURE.type()::parse);
  }

  public ToneCurve toneCurve() throws TaskException {
    return note(TONE_CURVE, Setting.TONE_MAP.type()::parse);
  }

  /** Returns whether the film's picture has lines, which the film does not hold. */
  public boolean hasLines() {
    return header.notes().containsKey(LINE_WIDTH);
  }

  /**
   * Returns what a picture of a film has and lacks: {@code 24.7 of 4000 samples per pixel, not
   * denoised}; empty if it has all samples and steps. A render with a target error may end before
   * it has all samples.
   *
   * @param isNoisy whether the picture shall be denoised, and is not
   */
  public Optional<String> lack(Film samples, boolean isNoisy) throws TaskException {
    Set<LaterStep> missing = EnumSet.noneOf(LaterStep.class);
    if (isNoisy) {
      missing.add(LaterStep.DENOISING);
    }
    if (hasLines()) {
      missing.add(LaterStep.DRAWING);
    }
    long pixels = header.window().pixels();
    boolean isOpen = samples() == RenderSettings.MAX_SAMPLES || targetError().isPresent();
    boolean isSampled = isOpen || samples.totalSamples() >= pixels * samples();
    return isSampled && missing.isEmpty()
        ? Optional.empty()
        : Optional.of(
            LaterStep.text(Summary.sampled(samples.totalSamples(), pixels, samples()), missing));
  }

  public int bits() throws TaskException {
    return note(BITS, text -> text.equals("16") ? 16 : 8);
  }

  /** Returns the metadata for a picture of the film, in a mutable map. */
  public Map<String, String> metadata() throws TaskException {
    Map<String, String> metadata = new LinkedHashMap<>();
    metadata.put("Software", note(SOFTWARE, Function.identity()));
    metadata.put("Scene", String.valueOf(scene().getFileName()));
    metadata.put("SceneHash", identity(FilmHeader.SCENE_HASH, Function.identity()));
    metadata.put("Mode", identity(FilmHeader.MODE, Function.identity()));
    for (Setting<?> setting : FilmHeader.named()) {
      if (header.identity().containsKey(setting.name())) {
        String value = identity(setting.name(), Function.identity());
        metadata.put(PictureMetadata.keyword(setting), value);
      }
    }
    metadata.put("Seed", identity(FilmHeader.SEED, Function.identity()));
    metadata.put("Size", identity(FilmHeader.SIZE, Function.identity()));
    metadata.put("Window", header.window().toString());
    metadata.put("Film", String.valueOf(header.parts()));
    return metadata;
  }

  public boolean lenient() throws TaskException {
    return note(LENIENT, Boolean::valueOf);
  }

  /**
   * Returns a parser that reads a scene with the film's settings.
   *
   * @param change last change to the settings
   */
  public SceneParser parser(Consumer<RenderSettings.Builder> change) throws TaskException {
    RenderSettings.Mode mode = identity(FilmHeader.MODE, Setting.MODE.type()::parse);
    Size size = identity(FilmHeader.SIZE, Size::of);
    long seed = identity(FilmHeader.SEED, Long::valueOf);
    int[] depths = identity(FilmHeader.DEPTH, FilmNotes::depths);
    UnaryOperator<RenderSettings.Builder> named = namedSettings();
    int samples = samples();
    Exposure exposure = exposure();
    ToneCurve toneCurve = toneCurve();
    SceneParser parser = lenient() ? new SceneParser().lenient() : new SceneParser();
    return parser
        .limitedTo(SceneParser.MAX_PIXELS_EVER)
        .inMode(mode)
        .overriding(
            inScene -> {
              RenderSettings.Builder builder = inScene.toBuilder();
              builder.size(size.width(), size.height()).seed(seed);
              Crop whole = new Crop(0, 0, size.width(), size.height());
              if (!header.window().equals(whole)) {
                builder.crop(header.window());
              }
              builder.samples(samples).exposure(exposure).toneCurve(toneCurve);
              builder.set(Setting.LAYERS, header.layers().kinds());
              named.apply(builder);
              switch (mode) {
                case PATH -> builder.maxTraceDepth(depths[0]);
                case RAY -> builder.rayDepths(depths[0], depths[depths.length - 1]);
              }
              change.accept(builder);
              return builder.build();
            });
  }

  /** Returns a change that sets all named settings of the film's identity. */
  private UnaryOperator<RenderSettings.Builder> namedSettings() throws TaskException {
    RenderSettings.Builder read = RenderSettings.builder();
    List<Setting<?>> stated =
        FilmHeader.named().stream().filter(s -> header.identity().containsKey(s.name())).toList();
    for (Setting<?> setting : stated) {
      identity(setting.name(), text -> set(setting, text, read));
    }
    RenderSettings settings = read.build();
    return builder -> {
      FilmHeader.named().forEach(setting -> copy(setting, settings, builder));
      return builder;
    };
  }

  private static <T> RenderSettings.Builder set(
      Setting<T> setting, String text, RenderSettings.Builder builder) {
    T value = setting.type().parse(text);
    if (!setting.type().accepts(value)) {
      throw new IllegalArgumentException(
          "expected " + setting.type().expected() + ", found " + text);
    }
    return builder.set(setting, value);
  }

  private static <T> void copy(
      Setting<T> setting, RenderSettings from, RenderSettings.Builder builder) {
    builder.set(setting, from.get(setting));
  }

  private static int[] depths(String text) {
    String[] parts = text.split(",");
    int[] depths = new int[parts.length];
    for (int i = 0; i < parts.length; i++) {
      depths[i] = Integer.parseInt(parts[i]);
    }
    return depths;
  }

  private <T> T note(String name, Function<String, T> reader) throws TaskException {
    return read(name, Optional.ofNullable(header.notes().get(name)), reader);
  }

  private <T> T identity(String name, Function<String, T> reader) throws TaskException {
    return read(name, Optional.ofNullable(header.identity().get(name)), reader);
  }

  private <T> T read(String name, Optional<String> text, Function<String, T> reader)
      throws TaskException {
    try {
      return reader.apply(text.orElseThrow(() -> new IllegalArgumentException("is missing")));
    } catch (IllegalArgumentException e) {
      throw ExitCode.SCENE.failure(film + ": " + name + " in its header: " + e.getMessage(), e);
    }
  }
}
