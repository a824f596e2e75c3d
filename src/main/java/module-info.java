/**
 * Lumbre, a CPU path tracer.
 *
 * <p>The route through it: {@link io.github.lumbre.parser} reads a scene file, {@link
 * io.github.lumbre.render} renders it, {@link io.github.lumbre.image} writes the picture.
 */
module io.github.lumbre {
  requires com.google.gson;
  requires java.desktop; // ImageIO
  // The command line's alone.
  requires static info.picocli;
  requires static java.management;
  requires static jdk.management;

  exports io.github.lumbre.math;
  exports io.github.lumbre.image;
  exports io.github.lumbre.sampling;
  exports io.github.lumbre.texture;
  exports io.github.lumbre.geometry;
  exports io.github.lumbre.material;
  exports io.github.lumbre.camera;
  exports io.github.lumbre.light;
  exports io.github.lumbre.scene;
  exports io.github.lumbre.integrator;
  exports io.github.lumbre.render;
  exports io.github.lumbre.checkpoint;
  exports io.github.lumbre.measure;
  exports io.github.lumbre.parser;
  exports io.github.lumbre.audit;
  exports io.github.lumbre.laws;

  opens io.github.lumbre.cli to
      info.picocli;
}
