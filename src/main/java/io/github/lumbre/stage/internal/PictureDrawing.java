package io.github.lumbre.stage.internal;

import io.github.lumbre.base.text.Quantities;
import io.github.lumbre.camera.internal.Projection;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Backdrop;
import io.github.lumbre.image.internal.VectorPicture;
import io.github.lumbre.image.internal.VectorPicture.Page;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.internal.DrawingSheet;
import io.github.lumbre.scenefile.internal.DrawingSheet.Paper;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PartTable;
import io.github.lumbre.scenefile.internal.PartTable.Part;
import io.github.lumbre.stage.drawing.Canvas;
import io.github.lumbre.stage.drawing.DisplayLight;
import io.github.lumbre.stage.drawing.LabeledModel;
import io.github.lumbre.stage.drawing.Labels;
import io.github.lumbre.stage.drawing.LineDrawing;
import io.github.lumbre.stage.drawing.PartMap;
import io.github.lumbre.stage.drawing.PartOf;
import io.github.lumbre.stage.drawing.VectorSheet;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What is drawn on the finished pictures of a scene, and of the same scene from other places:
 * lines, and above them labels. Immutable.
 */
public final class PictureDrawing {
  private final RenderSettings settings;
  private final LineDrawing lines;
  private final Optional<ModelContents> model;
  private final Optional<ModelContents> labeled;

  /** The parts; empty if none is named, and no line belongs to one. */
  private final Optional<PartTable> parts;

  private final Consumer<String> notes;

  private PictureDrawing(ParsedScene file, boolean isVector, Consumer<String> notes) {
    this.notes = notes;
    settings = file.settings();
    model = file.model();
    boolean hasHidden = model.filter(contents -> contents.sheet().hasHidden()).isPresent();
    lines = LineDrawing.of(file.scene(), settings, hasHidden);
    labeled = model.filter(contents -> !contents.labels().isEmpty());
    parts =
        model
            .filter(
                contents -> isVector || hasHidden || contents.labels().contains(ShownLabels.PARTS))
            .map(contents -> contents.parts(file.scene()));
  }

  /**
   * Returns the drawing of a scene.
   *
   * @param notes receives a text for labels of a picture that have no room
   */
  public static PictureDrawing of(ParsedScene file, Consumer<String> notes) {
    return new PictureDrawing(file, false, notes);
  }

  /**
   * Returns a model's lines and labels as vectors, without what is between them.
   *
   * @param title the name of the place, instead of the first one; if it is "", none is drawn
   * @param notes receives a text for labels that have no room
   */
  public static VectorPicture vectors(
      ParsedScene file, Optional<String> title, Consumer<String> notes) {
    return new PictureDrawing(file, true, notes).vectors(file.scene(), title);
  }

  /** Returns whether a scene shows lines on paper alone, so that it needs no samples. */
  public static boolean isAlone(ParsedScene file) {
    return file.model().filter(contents -> contents.sheet().isAlone()).isPresent();
  }

  /** Returns whether the vectors of a scene show areas, which take memory for each pixel. */
  public static boolean hasAreas(ParsedScene file) {
    return file.model()
        .filter(contents -> VectorSheet.hasAreas(file.settings(), contents.surfaces()))
        .isPresent();
  }

  /** Returns whether a scene has lines or labels. */
  public static boolean isNeeded(ParsedScene file) {
    return file.settings().get(Setting.LINE_WIDTH) > 0
        || file.model().filter(model -> !model.labels().isEmpty()).isPresent();
  }

  /**
   * Returns a finished picture for the screen, with lines and labels as dark on bright surfaces as
   * on others.
   *
   * @param scene the scene of this drawing, from any place
   * @param title the name of this place, instead of the first one; if it is "", none is drawn
   * @param picture in linear light
   * @param options exposure and tone curve of the picture
   */
  public DisplayLight onDisplay(
      Scene scene, Optional<String> title, Image picture, ImageWriter.Options options) {
    if (!isDrawnOn(scene)) {
      return new DisplayLight(picture, options);
    }
    DisplayLight light = DisplayLight.of(picture, options);
    return new DisplayLight(drawn(scene, title, light.image()), light.options());
  }

  /**
   * Returns a picture in linear light with lines and labels.
   *
   * @param scene the scene of this drawing, from any place
   * @param title the name of this place, instead of the first one; if it is "", none is drawn
   */
  public Image onLight(Scene scene, Optional<String> title, Image picture) {
    return isDrawnOn(scene) ? drawn(scene, title, picture) : picture;
  }

  /**
   * Returns a picture for the screen of lines on paper, and what is drawn with them: see {@link
   * #isAlone}.
   *
   * @param options of the picture
   */
  public DisplayLight aloneOnDisplay(
      Scene scene, Optional<String> title, ImageWriter.Options options) {
    DisplayLight light = DisplayLight.of(empty(), options);
    return new DisplayLight(drawnAlone(scene, title, light.image()), light.options());
  }

  /** Returns the same picture in linear light. */
  public Image aloneOnLight(Scene scene, Optional<String> title) {
    return drawnAlone(scene, title, Backdrop.asLight(empty(), settings.background()));
  }

  /** Returns a picture that shows nothing but what will be behind it. */
  private Image empty() {
    Crop window = settings.window();
    int pixels = Math.multiplyExact(window.width(), window.height());
    return new Image(
        window.width(), window.height(), new float[3 * pixels], new float[pixels]);
  }

  private boolean isDrawnOn(Scene scene) {
    return lines.areOn(scene) || labeled.isPresent();
  }

  private Image drawn(Scene scene, Optional<String> title, Image picture) {
    Canvas canvas = new Canvas(picture);
    draw(scene, title, canvas, picture);
    return canvas.image();
  }

  private Image drawnAlone(Scene scene, Optional<String> title, Image paper) {
    Canvas canvas = new Canvas(paper);
    lines.drawSurfaces(scene, model.orElseThrow().surfaces(), numbers(), canvas);
    draw(scene, title, canvas, paper);
    return canvas.image();
  }

  private void draw(Scene scene, Optional<String> title, Canvas canvas, Image picture) {
    lines.draw(scene, numbers(), canvas);
    labeled.ifPresent(
        contents ->
            labels(scene, contents, title.orElse(contents.title()))
                .draw(canvas, Backdrop.asLight(picture, settings.background())));
  }

  private PartOf numbers() {
    return parts.isPresent() ? parts.get()::at : PartOf.ONE;
  }

  private VectorPicture vectors(Scene scene, Optional<String> title) {
    ModelContents contents = model.orElseThrow();
    PartTable table = parts.orElseThrow();
    List<String> names = table.parts().stream().map(Part::name).toList();
    VectorSheet sheet = new VectorSheet(lines, scene, names, numbers());
    sheet.addLines(contents.surfaces());
    Optional<Rgb> background = settings.background();
    labeled.ifPresent(
        of ->
            sheet.addLabels(
                labels(scene, of, title.orElse(of.title())), background.orElse(Rgb.WHITE)));
    return sheet.picture(page(contents.sheet()), background);
  }

  private Page page(DrawingSheet sheet) {
    Crop window = settings.window();
    if (!sheet.isInMillimeters()) {
      return Page.ofPixels(window.width(), window.height());
    }
    double width = window.width() * DrawingSheet.PIXEL;
    double height = window.height() * DrawingSheet.PIXEL;
    Optional<Paper> paper = sheet.paper().filter(whole -> settings.crop().isEmpty());
    double paperWidth = paper.map(Paper::width).orElse(width);
    double paperHeight = paper.map(Paper::height).orElse(height);
    return new Page(
        paperWidth,
        paperHeight,
        .5 * (paperWidth - width),
        .5 * (paperHeight - height),
        DrawingSheet.PIXEL,
        "mm");
  }

  private Labels labels(Scene scene, ModelContents contents, String title) {
    Crop window = settings.window();
    Labels labels = new Labels(window.width(), window.height());
    LabeledModel model = model(scene, contents);
    for (String kind : ShownLabels.KINDS) {
      if (contents.labels().contains(kind)) {
        switch (kind) {
          case ShownLabels.VIEW -> labels.addTitle(title);
          case ShownLabels.AXES -> labels.addAxes(model);
          case ShownLabels.SCALE -> labels.addScale(model);
          case ShownLabels.PARTS -> labels.addParts(map(scene));
          case ShownLabels.SIZE ->
              contents
                  .assembled()
                  .ifPresentOrElse(
                      box -> labels.addSizes(size(box, contents)), () -> labels.addSizes(model));
          default -> labels.addBox(model);
        }
      }
    }
    labels.leftOut().forEach(notes);
    return labels;
  }

  /** Returns the dimensions of a box in the scene, in the axes and the unit of the file. */
  private static String size(Bounds3 box, ModelContents contents) {
    Vec3 side = contents.fromFile().inverseVector(box.max().minus(box.min()));
    return Stream.of(side.x(), side.y(), side.z())
        .map(length -> Quantities.text(Math.abs(length), contents.unit()))
        .collect(Collectors.joining(" × ", "assembled ", ""));
  }

  private LabeledModel model(Scene scene, ModelContents contents) {
    Transform fromFile = contents.fromFile();
    Projection projection = ViewNumbers.projection(scene, settings).orElseThrow().from(fromFile);
    Frame camera = scene.camera().axes();
    List<Vec3> axes =
        Stream.of(Vec3.X, Vec3.Y, Vec3.Z)
            .map(axis -> ModelScene.TO_LEFT_HANDED.vector(fromFile.vector(axis)).normalized())
            .map(camera::toLocal)
            .toList();
    Bounds3 box =
        Bounds3.EMPTY
            .union(fromFile.inversePoint(contents.seen().min()))
            .union(fromFile.inversePoint(contents.seen().max()));
    return new LabeledModel(projection, axes, box.min(), box.max(), contents.unit());
  }

  private PartMap map(Scene scene) {
    PartTable table = parts.orElseThrow();
    List<String> names = table.parts().stream().map(Part::name).toList();
    int[] shown = ViewNumbers.parts(scene, settings, table);
    return new PartMap(names, settings.window().width(), shown);
  }
}
