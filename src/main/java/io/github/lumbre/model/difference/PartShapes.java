package io.github.lumbre.model.difference;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelImage;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.PieceModel;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** Finds the shapes of a model's parts. Confined to one thread. */
final class PartShapes {
  private static final int INTERRUPT_MASK = 0xffff;

  private final Map<ModelImage, String> hashes = new IdentityHashMap<>();

  private PartShapes() {}

  /** Returns the parts of a file, or the connected pieces of one that it does not divide. */
  static List<PartShape> of(Model model) {
    PartShapes shapes = new PartShapes();
    Map<ModelNode, List<ModelPart>> surfaces = new LinkedHashMap<>();
    PieceModel.of(model)
        .parts()
        .forEach(part -> surfaces.computeIfAbsent(part.node(), n -> new ArrayList<>()).add(part));
    return surfaces.entrySet().stream()
        .map(part -> shapes.shape(part.getKey(), part.getValue()))
        .toList();
  }

  /** Returns the box around all vertices of a model. */
  static Bounds3 box(Model model) {
    Bounds3 box = Bounds3.EMPTY;
    for (ModelPart part : model.parts()) {
      for (int i = 0; i < part.geometry().vertexCount(); i++) {
        box = box.union(part.toWorld().point(vertex(part.geometry(), i)));
      }
    }
    return box;
  }

  private PartShape shape(ModelNode node, List<ModelPart> surfaces) {
    PartShape.Builder builder =
        new PartShape.Builder(
            surfaces.get(0).toWorld().point(vertex(surfaces.get(0).geometry(), 0)));
    Set<String> materials = new TreeSet<>();
    for (ModelPart surface : surfaces) {
      String material =
          surface.material().location().isEmpty() ? "" : text(surface.material());
      if (!material.isEmpty()) {
        materials.add(material);
      }
      builder.surface(new PartShape.Surface(surface, material));
      add(surface.geometry(), surface.toWorld(), builder);
    }
    return builder.build(node.label(), node.name(), materials);
  }

  private static void add(ModelGeometry mesh, Transform toWorld, PartShape.Builder builder) {
    for (int i = 0; mesh.isPoints() && i < mesh.vertexCount(); i++) {
      builder.point(toWorld.point(vertex(mesh, i)));
    }
    int[] indices = mesh.indices();
    for (int i = 0; i < indices.length; i += 3) {
      if ((i & INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      builder.triangle(
          toWorld.point(vertex(mesh, indices[i])),
          toWorld.point(vertex(mesh, indices[i + 1])),
          toWorld.point(vertex(mesh, indices[i + 2])));
    }
  }

  private static Vec3 vertex(ModelGeometry mesh, int number) {
    double[] p = mesh.positions();
    return new Vec3(p[3 * number], p[3 * number + 1], p[3 * number + 2]);
  }

  /** Returns what a material states, without its name and place in the file. */
  private String text(ModelMaterial material) {
    StringBuilder text = new StringBuilder();
    Map<String, MaterialInput> inputs = new TreeMap<>();
    material.inputs().forEach((parameter, input) -> inputs.put(parameter.key(), input));
    inputs.forEach((key, input) -> add(key, input, text));
    material.normalMap().ifPresent(map -> add("normal", map, text));
    add("emission", material.emission(), text);
    return text.append(material.alphaMode())
        .append(' ')
        .append(material.alphaCutoff())
        .append(material.doubleSided())
        .append(material.unlit())
        .append(material.glossy())
        .toString();
  }

  private void add(String name, MaterialInput input, StringBuilder text) {
    text.append(
        String.format(
            Locale.ROOT,
            "%s %.4f %.4f %.4f",
            name,
            input.factor().r(),
            input.factor().g(),
            input.factor().b()));
    input
        .texture()
        .ifPresent(texture -> text.append(' ').append(input.channel()).append(text(texture)));
    text.append(' ');
  }

  private String text(ModelTexture texture) {
    String hash = hashes.computeIfAbsent(texture.image(), image -> Sha256.of(image.encoded()));
    return hash
        + texture.uvSet()
        + texture.wrapU()
        + texture.wrapV()
        + texture.nearest()
        + texture.uvTransform();
  }
}
