package io.github.lumbre.scenefile.internal;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelAnimation;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.section.Sections;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What a model offers, by the names that users give, and where it is.
 *
 * @param cameras the names of its cameras; the index of one that has no name
 * @param animations its animations
 * @param variants the names of its material variants
 * @param materials the names of the materials in use; the place in the file of one that has no name
 * @param unit of its file, from which coordinates are converted to meters; empty if there is none
 * @param surfaces its surfaces in the scene, by the numbers of their primitives
 * @param labels what to draw on its pictures
 * @param title the name of the view
 * @param sheet how lines are drawn on its pictures
 * @param fromFile from the axes and the unit of its file to world space
 * @param min the least coordinates of its vertices: right-handed, +Y up
 * @param max the largest coordinates
 * @param assembled the box around the model before its parts moved apart, in the scene; empty if
 *     they did not
 * @param seen the box around what sections leave, in the same space
 */
public record ModelContents(
    List<String> cameras,
    List<ModelAnimation> animations,
    List<String> variants,
    List<String> materials,
    String unit,
    Map<Integer, PartSurface> surfaces,
    Set<String> labels,
    String title,
    DrawingSheet sheet,
    Transform fromFile,
    Vec3 min,
    Vec3 max,
    Optional<Bounds3> assembled,
    Bounds3 seen) {
  public ModelContents {
    cameras = List.copyOf(cameras);
    animations = List.copyOf(animations);
    variants = List.copyOf(variants);
    materials = List.copyOf(materials);
    surfaces = Map.copyOf(surfaces);
    labels = Set.copyOf(labels);
  }

  /**
   * Returns the contents of a model.
   *
   * @param surfaces its surfaces in the scene, by the numbers of their primitives
   */
  public static ModelContents of(
      Model model, Map<Integer, PartSurface> surfaces, Surroundings around) {
    Vec3 low = around.box().min();
    Vec3 high = around.box().max();
    Bounds3 all =
        new Bounds3(
            new Vec3(low.x(), low.y(), 0 - high.z()), new Vec3(high.x(), high.y(), 0 - low.z()));
    boolean isCut = !around.options().get(ModelOption.SECTION).isEmpty();
    Bounds3 left = isCut ? Sections.bounds(model) : all;
    Map<String, String> materials = new LinkedHashMap<>();
    model.parts().stream()
        .map(part -> part.material())
        .filter(material -> !material.location().isEmpty())
        .forEach(m -> materials.put(m.location(), m.name().isEmpty() ? m.location() : m.name()));
    return new ModelContents(
        cameraNames(model),
        model.animations(),
        model.variants(),
        List.copyOf(materials.values()),
        model.unit(),
        surfaces,
        around.labels(),
        around.title(),
        around.sheet(),
        model.fromFile(),
        all.min(),
        all.max(),
        around.assembled(),
        left.isEmpty() ? all : left);
  }

  /** Returns the parts of the model; finding connected pieces takes time. */
  public PartTable parts(Scene scene) {
    return PartTable.of(scene, surfaces);
  }

  /** Returns the names of a model's cameras, in the order of the file. */
  public static List<String> cameraNames(Model model) {
    List<String> names = new ArrayList<>();
    for (ModelCamera each : model.cameras()) {
      names.add(each.name().isEmpty() ? Integer.toString(names.size()) : each.name());
    }
    return names;
  }
}
