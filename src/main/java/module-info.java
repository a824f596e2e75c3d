/**
 * Lumbre, a CPU path tracer, as a library.
 *
 * <h2>How do I get a picture of my model?</h2>
 *
 * <p>Of a glTF, OBJ, PLY, STL, OFF, 3MF, COLLADA or ZIP file:
 *
 * <pre>{@code
 * import io.github.lumbre.image.*;
 * import io.github.lumbre.render.*;
 * import io.github.lumbre.render.denoise.*;
 * import io.github.lumbre.scenefile.*;
 * import io.github.lumbre.stage.*;
 * import java.nio.file.*;
 *
 * SceneFile file =
 *     StagedModel.read(Path.of("model.glb"), Stage.DEFAULT, new SceneParser()).scene();
 * Image image = BuiltInDenoiser.render(file.settings(), file.scene(), Progress.NONE);
 * ImageWriter.write(image, Path.of("model.png"), file.settings().development());
 * }</pre>
 *
 * <p>Of triangles in memory, by arrays of coordinates and of vertex numbers, it begins with:
 *
 * <pre>{@code
 * import io.github.lumbre.geometry.*;
 *
 * SceneFile file =
 *     StagedModel.of(TriangleMesh.of(positions, indices), Stage.DEFAULT, new SceneParser())
 *         .scene();
 * }</pre>
 *
 * <p>{@link io.github.lumbre.stage.Stage Stage} has the direction of the view, the light and the
 * background; {@link io.github.lumbre.scenefile.SceneParser#overriding overriding} changes the size
 * of the picture and its samples. {@link io.github.lumbre.stage.thumbnail.Thumbnails Thumbnails}
 * serves uploads, within limits.
 *
 * <h2>Other ways</h2>
 *
 * <p>{@link io.github.lumbre.scenefile} reads a scene file, {@link io.github.lumbre.scene} builds
 * one in code, {@link io.github.lumbre.render} renders it, {@link io.github.lumbre.image} writes
 * the picture. The command line and the measurements of the lab are no part of the module: each has
 * a jar of its own.
 */
module io.github.lumbre {
  requires com.google.gson;
  requires transitive java.desktop; // ImageIO, BufferedImage
  requires static org.jspecify; // annotations for compilers and editors

  exports io.github.lumbre.math;
  exports io.github.lumbre.image;
  exports io.github.lumbre.base.limit;
  exports io.github.lumbre.math.sampling;
  exports io.github.lumbre.texture;
  exports io.github.lumbre.geometry;
  exports io.github.lumbre.material;
  exports io.github.lumbre.camera;
  exports io.github.lumbre.light;
  exports io.github.lumbre.scene;
  exports io.github.lumbre.model;
  exports io.github.lumbre.integrator.path;
  exports io.github.lumbre.render;
  exports io.github.lumbre.render.checkpoint;
  exports io.github.lumbre.render.denoise;
  exports io.github.lumbre.render.stopping;
  exports io.github.lumbre.render.preview;
  exports io.github.lumbre.scenefile;
  exports io.github.lumbre.scenefile.audit;
  exports io.github.lumbre.image.compare;
  exports io.github.lumbre.stage;
  exports io.github.lumbre.stage.thumbnail;
}
