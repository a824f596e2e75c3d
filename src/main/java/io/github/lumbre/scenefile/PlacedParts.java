package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneAssembly;
import io.github.lumbre.scene.internal.Names;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.SceneOrigins;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The parts of a scene in their order, with their places in the file; those that move have parts of
 * their own in each pose. Not reusable.
 */
final class PlacedParts {
  private boolean isSearchedLater;
  private final List<Entry> entries = new ArrayList<>();
  private final List<Origin> primitives = new ArrayList<>();
  private final List<Origin> materials = new ArrayList<>();
  private final List<Origin> emitters = new ArrayList<>();

  private record Part(
      Origin origin, Origin material, String lightGroup, Consumer<SceneAssembly> action) {}

  /** Parts in each pose; the same ones in all poses if there is one list. */
  private record Entry(List<List<Part>> poses) {
    List<Part> in(int pose) {
      return poses.get(poses.size() == 1 ? 0 : pose);
    }
  }

  /**
   * Adds a part.
   *
   * @param action adds the part to the scene
   */
  void add(Origin origin, Origin material, String lightGroup, Consumer<SceneAssembly> action) {
    entries.add(new Entry(List.of(List.of(new Part(origin, material, lightGroup, action)))));
  }

  /**
   * Adds parts that move.
   *
   * @param poses the parts in each pose, without parts that move themselves
   */
  void addPoses(List<PlacedParts> poses) {
    entries.add(
        new Entry(
            poses.stream()
                .map(pose -> pose.entries.stream().flatMap(e -> e.in(0).stream()).toList())
                .toList()));
  }

  /** Delays building the hierarchy; see {@link SceneAssembly#searchedLater}. */
  void searchLater() {
    isSearchedLater = true;
  }

  /** Returns whether some parts move. */
  boolean areMoving() {
    return entries.stream().anyMatch(entry -> entry.poses.size() > 1);
  }

  /**
   * Returns the scene of the parts.
   *
   * @param cameras in each pose; a single one stands still
   * @param poses number of poses; all parts that move have so many
   * @param backplate what the camera sees instead of environment lights
   * @param kernel traversal kernel of the bounding volume hierarchies
   * @param known the same scene, if code has built it: it gets the names of the file; not used if
   *     there are several poses
   */
  Scene scene(
      List<Camera> cameras,
      int poses,
      Optional<Backplate> backplate,
      Kernel kernel,
      Optional<Scene> known) {
    List<SceneAssembly> all = new ArrayList<>();
    for (int pose = 0; pose < poses; pose++) {
      SceneAssembly scene =
          new SceneAssembly(cameras.get(cameras.size() == 1 ? 0 : pose)).searchedBy(kernel);
      if (isSearchedLater) {
        scene.searchedLater();
      }
      backplate.ifPresent(scene::backplate);
      add(pose, scene, pose == poses / 2);
      all.add(scene);
    }
    return known
        .filter(same -> poses == 1)
        .map(same -> same.named(all.get(0)))
        .orElseGet(() -> SceneAssembly.inMotion(all));
  }

  private void add(int pose, SceneAssembly scene, boolean isNoted) {
    OriginNames objects = new OriginNames("object");
    OriginNames materialNames = new OriginNames("default");
    for (Entry entry : entries) {
      for (Part part : entry.in(pose)) {
        Interrupts.check();
        scene.lightGroup(part.lightGroup);
        scene.named(objects.of(part.origin), materialNames.of(part.material));
        part.action.accept(scene);
        if (isNoted) {
          note(part, scene);
        }
      }
    }
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
