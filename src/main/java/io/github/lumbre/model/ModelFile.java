package io.github.lumbre.model;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.light.Light;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.model.internal.ModelSurface;
import io.github.lumbre.scene.SceneContent;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * A model file for scenes that are built in code, with everything that it names. All places of the
 * model share its meshes and textures. Immutable; {@link Models} reads it.
 */
public final class ModelFile implements SceneContent {
  private final String name;
  private final byte[] content;
  private final Map<String, byte[]> files;
  private final ModelOptions options;
  private final Model model;
  private final ModelScene local;
  private final boolean movable;
  private final boolean usesLights;

  /**
   * @param content bytes of the file; not copied
   * @param files bytes of the files that it names, by their names; not copied
   * @throws ModelFormatException if a texture is too large
   */
  ModelFile(
      String name, byte[] content, Map<String, byte[]> files, ModelOptions options, Model model)
      throws ModelFormatException {
    this.name = name;
    this.content = content;
    this.files = new TreeMap<>(files);
    this.options = options;
    local = new ModelScene(model, ModelScene.TO_LEFT_HANDED, Kernel.AUTO, Limits.NONE, false);
    local.decode();
    this.model = model.warning(local.warnings());
    movable = false;
    usesLights = true;
  }

  private ModelFile(ModelFile other, boolean movable, boolean usesLights) {
    name = other.name;
    content = other.content;
    files = other.files;
    options = other.options;
    model = other.model;
    local = other.local;
    this.movable = movable;
    this.usesLights = usesLights;
  }

  /**
   * Returns this model with hierarchies in its own space, which are built once, so that moving it
   * costs nothing. Rays take a little longer to find their hits.
   */
  public ModelFile movable() {
    return new ModelFile(this, true, usesLights);
  }

  /** Returns this model without the lights of the file. */
  public ModelFile withoutLights() {
    return new ModelFile(this, movable, false);
  }

  /** Returns the file's name. */
  public String name() {
    return name;
  }

  /** Returns the bytes of the file. */
  public byte[] content() {
    return content.clone();
  }

  /** Returns the bytes of the files that the model names, by their names. */
  public Map<String, byte[]> files() {
    Map<String, byte[]> copies = new TreeMap<>(files);
    copies.replaceAll((file, bytes) -> bytes.clone());
    return copies;
  }

  /** Returns what was read of the file. */
  public ModelOptions options() {
    return options;
  }

  /** Returns the content of the file. */
  Model model() {
    return model;
  }

  /** Returns whether hierarchies are in the model's own space; see {@link #movable()}. */
  public boolean isMovable() {
    return movable;
  }

  /** Returns whether the lights of the file shine. */
  public boolean usesLights() {
    return usesLights;
  }

  @Override
  public Placed placed(Transform toWorld) {
    Transform fromModel = toWorld.times(ModelScene.TO_LEFT_HANDED);
    List<ModelSurface> surfaces;
    List<Light> lights;
    try {
      ModelScene scene = local.at(fromModel, movable);
      surfaces = scene.surfaces();
      lights = usesLights ? scene.lights() : List.of();
    } catch (ModelFormatException e) {
      throw new IllegalStateException("model: its textures have been decoded before", e);
    }
    return scene -> {
      for (ModelSurface surface : surfaces) {
        ModelPart part = surface.part();
        ModelMaterial material = part.material();
        scene.named(
            part.name().isEmpty() ? part.location() : part.name(),
            material.name().isEmpty() ? material.location() : material.name());
        surface.addTo(scene);
      }
      lights.forEach(scene::add);
    };
  }

  /** Returns the name and the size of the file, for people. */
  @Override
  public String toString() {
    return name + ", a model of " + content.length + " bytes";
  }
}
