package io.github.lumbre.parser;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.limit.internal.Interrupts;
import io.github.lumbre.parser.internal.Origin;
import io.github.lumbre.parser.internal.SceneOrigins;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneAssembly;
import io.github.lumbre.scene.internal.Names;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/** The parts of a scene in their order, with their places in the file. Not reusable. */
final class SceneParts {
  private final List<Part> parts = new ArrayList<>();
  private final List<Origin> primitives = new ArrayList<>();
  private final List<Origin> materials = new ArrayList<>();
  private final List<Origin> emitters = new ArrayList<>();

  private record Part(
      Origin origin, Origin material, String lightGroup, Consumer<SceneAssembly> action) {}

  /**
   * Adds a part.
   *
   * @param action adds the part to the scene
   */
  void add(Origin origin, Origin material, String lightGroup, Consumer<SceneAssembly> action) {
    parts.add(new Part(origin, material, lightGroup, action));
  }

  /**
   * Returns the scene of the parts.
   *
   * @param backplate color that the camera sees instead of environment lights
   * @param kernel traversal kernel of the bounding volume hierarchies
   * @param known the same scene, if code has built it: it gets the names of the file
   */
  Scene scene(Camera camera, Optional<Rgb> backplate, Kernel kernel, Optional<Scene> known) {
    SceneAssembly scene = new SceneAssembly(camera).searchedBy(kernel);
    backplate.ifPresent(scene::backplate);
    OriginNames objects = new OriginNames("object");
    OriginNames materialNames = new OriginNames("default");
    for (Part part : parts) {
      Interrupts.check();
      scene.lightGroup(part.lightGroup);
      scene.named(objects.of(part.origin), materialNames.of(part.material));
      part.action.accept(scene);
      note(part, scene);
    }
    return known.map(same -> same.named(scene)).orElseGet(scene::build);
  }

  /** Records the origin of the primitives or lights that were just added. */
  private void note(Part part, SceneAssembly scene) {
    while (scene.primitiveCount() > primitives.size()) {
      primitives.add(part.origin);
      materials.add(part.material);
    }
    while (scene.emitterCount() > emitters.size()) {
      emitters.add(part.origin);
    }
  }

  /** Returns the places of the scene's objects; requires an earlier call of {@link #scene}. */
  SceneOrigins origins(List<SceneOrigins.TextureUse> textures, List<SceneOrigins.Unused> unused) {
    return new SceneOrigins(primitives, materials, emitters, textures, unused);
  }

  /**
   * Gives each place in a scene file its own name: the name in the file, followed by a number if
   * another place has the same; without a name, the path. Mutable.
   */
  private static final class OriginNames {
    /** The names by path and name in the file, between them a NUL, which is in neither. */
    private final Map<String, String> names = new HashMap<>();

    private final Names given;
    private final String missing;

    /**
     * @param missing name of {@link Origin#NONE}
     */
    OriginNames(String missing) {
      this.missing = missing;
      given = new Names(missing);
    }

    String of(Origin origin) {
      String key = origin.path() + '\0' + origin.name();
      return key.length() == 1 ? missing : names.computeIfAbsent(key, k -> unused(origin));
    }

    private String unused(Origin origin) {
      return given.unused(origin.name().isEmpty() ? origin.path() : origin.name());
    }
  }
}
