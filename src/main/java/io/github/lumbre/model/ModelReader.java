package io.github.lumbre.model;

import io.github.lumbre.model.ModelOptions.Pose;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/** Reads model files of all supported formats. Stateless. */
public final class ModelReader {
  /** The name endings of supported files, in lower case, without a dot. */
  public static final List<String> ENDINGS = List.of("gltf", "glb", "obj", "ply", "stl");

  private ModelReader() {}

  /**
   * Returns the content of a model file. The ending of its name chooses the format. The model has a
   * triangle with an area, or a light.
   *
   * @param name of the file
   * @param content bytes of the file
   * @param folder reads other files that the model names
   * @throws ModelFormatException if the file is damaged, unsupported or too large
   * @throws IOException if the thread is interrupted
   */
  public static Model read(String name, byte[] content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
    if (!ending.equals("gltf") && !ending.equals("glb")) {
      requireNone("animations", "an animation ", options.pose().map(Pose::animation));
      requireNone("variants", "a variant ", options.variant());
    }
    try {
      Model model = switch (ending) {
        case "gltf", "glb" -> GltfReader.read(content, folder, options);
        case "obj" -> ObjModelReader.read(content, folder, options);
        case "ply" -> PlyReader.read(content, options);
        case "stl" -> StlReader.read(content, options);
        default ->
            throw new ModelFormatException(
                ModelFormatException.Kind.UNSUPPORTED,
                "",
                "no reader of ." + PrintableText.shortened(ending) + " files");
      };
      long triangles = 0;
      for (ModelPart part : model.parts()) {
        triangles += part.geometry().triangleCount();
        ModelLimits.requireTriangles(part.location(), triangles, options.limits());
      }
      if (model.lights().isEmpty()) {
        model.requireSurface();
      }
      return model;
    } catch (CancellationException e) {
      throw (IOException) new InterruptedIOException(e.getMessage()).initCause(e);
    }
  }

  private static void requireNone(String location, String what, Optional<String> name)
      throws ModelFormatException {
    if (name.isPresent()) {
      throw new ModelFormatException(
          ModelFormatException.Kind.MALFORMED,
          location,
          "expected " + what + PrintableText.quoted(name.get()) + ", found none in the model");
    }
  }
}
