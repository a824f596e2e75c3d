package io.github.lumbre.scene;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.Viewpoint;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFile;
import io.github.lumbre.model.Models;
import io.github.lumbre.render.PictureRenderer;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Frames of an animation share what does not move, and have the bits of single renders. */
class AnimatedSceneTest {
  private static final int FRAMES = 6;
  private static final RenderSettings SETTINGS =
      new RenderSettings.Builder().size(24, 24).samples(1).threads(1).build();

  private static Vec3 eye(int frame) {
    return new Vec3(30 * Math.sin(frame), 14, -30 * Math.cos(frame));
  }

  private static Transform turn(int frame) {
    return Transform.rotationDegrees(new Vec3(0, 60 * frame, 0));
  }

  private static Scene single(ModelFile lantern, int moved, int seen) {
    return Scene.builder()
        .lookingAt(eye(seen), new Vec3(0, 12, 0), Lens.pinhole(50))
        .add("floor", Plane.floor(0), Matte.GRAY)
        .group("turntable", turn(moved), group -> group.add(lantern))
        .addBackground(Rgb.WHITE)
        .build();
  }

  private static ModelFile lantern() throws Exception {
    return Models.read(Path.of("scenes", "models", "lantern.glb"));
  }

  private static int hash(Scene scene) {
    try {
      return Arrays.hashCode(new PictureRenderer(SETTINGS).render(scene).rgb());
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private static Set<Object> identities() {
    return Collections.newSetFromMap(new IdentityHashMap<>());
  }

  @Test
  void movedCamerasShareTheWholeScene() throws Exception {
    Scene first = single(lantern(), 0, 0);
    Set<Object> hierarchies = identities();
    List<Integer> frames =
        IntStream.range(0, FRAMES)
            .parallel()
            .mapToObj(
                frame -> {
                  Viewpoint from =
                      new Viewpoint(eye(frame), new Vec3(0, 12, 0), Vec3.Y, Lens.pinhole(50));
                  Scene scene = first.seenFrom(from);
                  Scene built = first.toBuilder().seenFrom(from).build();
                  synchronized (hierarchies) {
                    hierarchies.add(scene.hierarchy());
                    hierarchies.add(built.hierarchy());
                  }
                  assertThat(hash(built)).isEqualTo(hash(scene));
                  return hash(scene);
                })
            .toList();
    assertThat(hierarchies).hasSize(1);
    for (int frame = 0; frame < FRAMES; frame++) {
      assertThat(frames.get(frame)).isEqualTo(hash(single(lantern(), 0, frame)));
    }
    assertThat(frames).doesNotHaveDuplicates();
  }

  private static Set<Object> sharedMeshes(Scene scene) {
    Set<Object> meshes = identities();
    for (Primitive primitive : scene.primitives()) {
      if (primitive.shape() instanceof MeshInstance instance) {
        meshes.add(instance.shared());
      }
    }
    return meshes;
  }

  /** The surfaces that emit light are not among these: they are divided anew. */
  @Test
  void movedModelsBuildTheirHierarchiesOnce() throws Exception {
    ModelFile lantern = lantern().movable();
    Scene first = single(lantern, 0, 0);
    Set<Object> meshes = identities();
    List<Integer> frames =
        IntStream.range(0, FRAMES)
            .parallel()
            .mapToObj(
                frame -> {
                  Scene scene = first.toBuilder().place("turntable", turn(frame)).build();
                  synchronized (meshes) {
                    meshes.addAll(sharedMeshes(scene));
                  }
                  return hash(scene);
                })
            .toList();
    assertThat(meshes).hasSizeGreaterThan(3).isEqualTo(sharedMeshes(first));
    for (int frame = 0; frame < FRAMES; frame++) {
      assertThat(frames.get(frame)).isEqualTo(hash(single(lantern().movable(), frame, 0)));
    }
    assertThat(frames).doesNotHaveDuplicates();
  }
}
