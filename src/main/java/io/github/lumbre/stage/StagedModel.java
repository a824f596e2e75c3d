package io.github.lumbre.stage;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.internal.ModelFormat;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.internal.Framing;
import io.github.lumbre.stage.internal.ModelSource;
import io.github.lumbre.stage.internal.Staging;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;

/**
 * A model on a stage, which is read and built once, and can be seen from several directions. Its
 * scenes share everything but the camera. Confined to one thread at a time.
 */
public final class StagedModel {
  /** The name of triangles in memory, for messages. */
  private static final String TRIANGLES = "triangles.ply";

  private final Staging model;
  private final ParsedScene scene;

  private StagedModel(Staging model) throws SceneFormatException {
    this.model = model;
    scene = model.scene();
  }

  /**
   * Reads a model and builds the scene around it. The parser's settings may state the picture's
   * size; otherwise its longer side is 1024, with the aspect ratio of the model's camera, or 4:3.
   * The model may lack pictures.
   *
   * @param model path of a glTF, OBJ, PLY, STL, OFF, 3MF, COLLADA or ZIP file
   * @throws SceneFormatException if the model does not exist or cannot be used; it lists the errors
   * @throws IOException if the model exists but cannot be read
   * @throws CancellationException if the calling thread is interrupted
   */
  public static StagedModel read(Path model, Stage stage, SceneParser parser)
      throws SceneFormatException, IOException {
    return read(ModelSource.of(parser, model), stage);
  }

  /**
   * Builds the scene around a model whose bytes are known; see {@link #read(Path, Stage,
   * SceneParser)}. Nothing is read from files, except what the folder reads and a picture of a sky
   * that the stage names.
   *
   * @param name of the model without folders; its ending chooses the format
   * @param model bytes of the file
   * @param files has other files that the model names; {@link ModelFolder#NONE} if there are none,
   *     as for a GLB file or a ZIP archive
   * @throws SceneFormatException if the model cannot be used; it lists the errors
   * @throws IOException if the folder fails
   * @throws CancellationException if the calling thread is interrupted
   */
  public static StagedModel read(
      String name, byte[] model, ModelFolder files, Stage stage, SceneParser parser)
      throws SceneFormatException, IOException {
    return read(ModelSource.of(parser, name, model.clone(), files), stage);
  }

  /**
   * Builds the scene around triangles that a program has in memory. Its picture has the bits of
   * that of a PLY file with the same numbers; the same limits are checked, and the mesh is copied.
   * Without colors, it is light gray, otherwise colored paint, transparent where alpha is below 1.
   * Texture coordinates, tangents and the mesh's {@link TriangleMesh.Front} have no effect.
   *
   * @param mesh with an area, at least 1e-100 in size and within 1e100 of the origin; y points up
   *     unless an option of the stage states another axis
   * @throws SceneFormatException if the mesh cannot be used; it lists the errors, of the file
   *     {@code triangles.ply}
   * @throws IOException if a picture that the stage names cannot be read
   * @throws CancellationException if the calling thread is interrupted
   */
  public static StagedModel of(TriangleMesh mesh, Stage stage, SceneParser parser)
      throws SceneFormatException, IOException {
    return of(ModelFormat.plyOf(mesh), stage, parser);
  }

  /**
   * Builds the scene around triangles with named parts, which the options of the stage can label,
   * hide, highlight and explode; see {@link #of(TriangleMesh, Stage, SceneParser)}. Vertices and
   * triangles are counted through all parts in messages, in the alphabetical order of their names,
   * whatever the order of the map.
   *
   * @param parts by their names: words with single spaces between them
   * @throws IllegalArgumentException if a name is not of this form
   */
  public static StagedModel of(Map<String, TriangleMesh> parts, Stage stage, SceneParser parser)
      throws SceneFormatException, IOException {
    return of(ModelFormat.plyOf(new TreeMap<>(parts)), stage, parser);
  }

  private static StagedModel of(byte[] ply, Stage stage, SceneParser parser)
      throws SceneFormatException, IOException {
    return read(ModelSource.of(parser, TRIANGLES, ply, ModelFolder.NONE), stage);
  }

  private static StagedModel read(ModelSource source, Stage stage)
      throws SceneFormatException, IOException {
    return source.timed(() -> new StagedModel(source.read(source.inMotion(stage), false)));
  }

  /**
   * Reads a model and builds the scene around it, whose text is to be written to a file. A missing
   * picture is an error unless the options of the stage are lenient, as it is in a scene.
   *
   * @param folder where asset paths start; contains the model and the sky's picture
   * @throws SceneFormatException if the scene cannot be used; it lists the errors
   * @throws IOException if the model exists but cannot be read
   * @throws CancellationException if the calling thread is interrupted
   */
  public static StagedModel readIn(Path folder, Path model, Stage stage)
      throws SceneFormatException, IOException {
    ModelSource source = ModelSource.of(new SceneParser(), model);
    return source.timed(() -> new StagedModel(source.readIn(folder, stage)));
  }

  /** Returns the scene as the stage sees it. */
  public SceneFile scene() {
    return scene;
  }

  /**
   * Returns the scenes as they are seen from other directions. Their pictures have the bits of
   * those of {@link Stage#seenFrom}.
   */
  public List<Scene> seenFrom(List<View> views) throws SceneFormatException {
    List<Scene> scenes = new ArrayList<>();
    for (View view : views) {
      scenes.add(model.seenFrom(view, scene));
    }
    return scenes;
  }

  /**
   * Returns the model from another direction, framed for a picture of another size.
   *
   * @param width of the picture in pixels, at least 1
   * @param height of the picture in pixels, at least 1
   */
  public SceneFile seenFrom(View view, int width, int height) throws SceneFormatException {
    return seenFrom(view, width, height, model.framing());
  }

  /**
   * Returns two models, as the camera of the second one's stage sees them, with both in its frame.
   *
   * @param width of the pictures in pixels, at least 1
   * @param height of the pictures in pixels, at least 1
   */
  public static List<SceneFile> seenTogether(
      StagedModel first, StagedModel second, int width, int height) throws SceneFormatException {
    Framing both = second.model.framing().with(first.model.framing());
    List<SceneFile> seen = new ArrayList<>();
    for (StagedModel each : List.of(first, second)) {
      SceneFile sized = each.sized(width, height);
      double aspect = (double) width / height;
      seen.add(sized.with(second.model.seenOn(second.model.stage(), sized, aspect, both)));
    }
    return seen;
  }

  private SceneFile sized(int width, int height) {
    return scene.with(scene.settings().toBuilder().size(width, height).build());
  }

  /**
   * Returns the model as the camera of another stage sees it, framed for a picture of another size.
   *
   * @param stage that differs from this model's in its camera alone
   * @param width of the picture in pixels, at least 1
   * @param height of the picture in pixels, at least 1
   * @throws SceneFormatException if the model lacks the camera that the stage names
   */
  public SceneFile seenOn(Stage stage, int width, int height) throws SceneFormatException {
    SceneFile sized = sized(width, height);
    return sized.with(model.seenOn(stage, sized, (double) width / height, model.framing()));
  }

  /**
   * Returns the model as the camera of another stage sees it, which frames this model and another
   * one; see {@link #seenOn}.
   *
   * @param other whose scene has the same camera
   */
  public SceneFile seenBeside(StagedModel other, Stage stage, int width, int height)
      throws SceneFormatException {
    SceneFile sized = sized(width, height);
    Framing both = model.framing().with(other.model.framing());
    return sized.with(model.seenOn(stage, sized, (double) width / height, both));
  }

  private SceneFile seenFrom(View view, int width, int height, Framing framing)
      throws SceneFormatException {
    SceneFile sized = sized(width, height);
    return sized.with(model.seenFrom(view, sized, (double) width / height, framing));
  }

  /** Returns about how many bytes of memory the model and its scenes take. */
  public long memory() {
    return model.memory();
  }
}
