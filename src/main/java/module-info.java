/**
 * Lumbre, a CPU path tracer, as a library.
 *
 * <p>{@link io.github.lumbre.scenefile} reads a scene file, {@link io.github.lumbre.render} renders
 * it, {@link io.github.lumbre.image} writes the picture. The command line and the measurements of
 * the lab are no part of the module: each has a jar of its own.
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
