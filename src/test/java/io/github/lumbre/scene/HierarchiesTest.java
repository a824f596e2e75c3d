package io.github.lumbre.scene;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the second hierarchy, which rays to lights search. */
class HierarchiesTest {
  private static final Shape LAMP =
      Rectangle.facing(new Vec3(0, 1.99, 0), new Vec3(0, -1, 0), 1, 1);
  private static final Light LIGHT = new AreaLight(LAMP, Emission.of(Rgb.WHITE));
  private static final Shape FLOOR = Rectangle.facing(Vec3.ZERO, Vec3.Y, 4, 4);
  private static final Shape CEILING =
      Rectangle.facing(new Vec3(0, 2, 0), new Vec3(0, -1, 0), 4, 4);
  private static final Shape WALL = Rectangle.facing(new Vec3(-2, 1, 0), new Vec3(1, .1, .2), 4, 4);

  /** A shelf whose lower side is open: it faces up, to the lamp. */
  private static final Shape SHELF = Rectangle.facing(new Vec3(.4, 1, 0), new Vec3(.1, 1, 0), 1, 1);

  private static final Shape BOX = Box.of(new Vec3(.3, .3, .2), new Vec3(.6, .6, .6));

  /** Faces down, between the lamp and the floor. */
  private static final Shape SCREEN =
      Rectangle.facing(new Vec3(-.5, 1.2, 0), new Vec3(0, -1, 0), 1, 1);

  private static final Shape WALL_TO_THE_LEFT = Rectangle.facing(new Vec3(-2, 0, 0), Vec3.X, 4, 4);

  private static final List<Shape> ROOM =
      List.of(LAMP, FLOOR, CEILING, WALL, SHELF, BOX, SCREEN, Plane.floor(-1));

  @Test
  void bothFindTheSameBlockersOfRaysToTheLamp() {
    for (Kernel kernel : List.of(Kernel.AUTO, Kernel.SCALAR)) {
      Bvh all = Bvh.over(ROOM, kernel);
      List<Shape> kept = new ArrayList<>();
      Bvh blockers = blockers(all, ROOM, List.of(LIGHT), kept);
      assertThat(kept).containsExactly(LAMP, BOX, SCREEN);
      SplittableRandom random = new SplittableRandom(7);
      NearestHit hit = new NearestHit();
      int blocked = 0;
      for (int i = 0; i < 200_000; i++) {
        // From anywhere, also from points of the floor, the ceiling and behind the walls.
        double y = i % 3 == 0 ? 0 : i % 3 == 1 ? 2 : random.nextDouble(-3, 3);
        Vec3 from = new Vec3(random.nextDouble(-3, 3), y, random.nextDouble(-3, 3));
        Vec3 to = new Vec3(random.nextDouble(-.5, .5), 1.99, random.nextDouble(-.5, .5));
        Ray ray = new Ray(from, to.minus(from), 1 - 1e-9);
        boolean isBlocked = all.isOccluded(ray, hit);
        assertThat(blockers.isOccluded(ray, hit)).isEqualTo(isBlocked);
        blocked += isBlocked ? 1 : 0;
      }
      assertThat(blocked).isBetween(20_000, 180_000);
    }
  }

  @Test
  void wallsBehindAnyLightAreKept() {
    Light below = new PointLight(new Vec3(0, -.5, 0), Rgb.WHITE, Falloff.INVERSE_SQUARE);
    Light onTheWall = new PointLight(new Vec3(-2, 1, 0), Rgb.WHITE, Falloff.INVERSE_SQUARE);
    List<Shape> kept = new ArrayList<>();
    blockers(Bvh.over(ROOM), ROOM, List.of(LIGHT, below, onTheWall), kept);
    assertThat(kept).containsExactly(LAMP, FLOOR, WALL, SHELF, BOX, SCREEN);
  }

  @Test
  void twoSidedWallsAreKept() {
    List<Shape> shapes = List.of(LAMP, Rectangle.facing(Vec3.ZERO, Vec3.Y, 4, 4).twoSided());
    Bvh all = Bvh.over(shapes);
    assertThat(Hierarchies.of(all, shapes, List.of(LIGHT), all::part).blockers()).isSameAs(all);
  }

  @Test
  void lightFromInfinityNeedsNoSecondHierarchy() {
    Bvh all = Bvh.over(ROOM);
    Light sky = EnvironmentLight.uniform(Rgb.WHITE);
    assertThat(Hierarchies.of(all, ROOM, List.of(sky), all::part).blockers()).isSameAs(all);
  }

  /** A scene of an animation shares hierarchies, but another lamp may lie behind a wall. */
  @Test
  void anotherLampIsHiddenByTheWallsOfASharedHierarchy() {
    Scene first =
        Scene.builder()
            .lookingAt(new Vec3(0, 0, 3), Vec3.ZERO, 60)
            .add(WALL_TO_THE_LEFT, new Matte(Texture.constant(Rgb.gray(.5))))
            .add(new PointLight(Vec3.ZERO, Rgb.WHITE, Falloff.INVERSE_SQUARE))
            .build();
    Scene second =
        first.toBuilder()
            .add(new PointLight(new Vec3(-3, 0, 0), Rgb.WHITE, Falloff.INVERSE_SQUARE))
            .build();
    NearestHit ray = new NearestHit();
    ray.aim(1, 0, 0, -4, 0, 0, 1);
    assertThat(first.isLightOccluded(ray, true)).isFalse();
    ray.aim(1, 0, 0, -4, 0, 0, 1);
    assertThat(second.isLightOccluded(ray, true)).isTrue();
  }

  /** Returns a room whose wall hides the light from the rest if the light is on the left. */
  private static SceneAssembly room(Camera camera, double x) {
    return new SceneAssembly(camera)
        .add(WALL_TO_THE_LEFT, Matte.GRAY)
        .add(new PointLight(new Vec3(x, 0, 0), Rgb.WHITE, Falloff.INVERSE_SQUARE));
  }

  @Test
  void cameraOrLightMayMoveAlone() {
    Camera camera = Lens.pinhole(60).camera(new Vec3(0, 0, 3), Frame.WORLD, 1);
    Camera other = Lens.pinhole(60).camera(new Vec3(0, 1, 3), Frame.WORLD, 1);
    List<Scene> poses =
        SceneAssembly.inMotion(
                List.of(room(camera, 0), room(camera, 0), room(other, 0), room(other, -3)))
            .poses();
    assertThat(poses.get(1)).isSameAs(poses.get(0));
    assertThat(poses.get(2).camera()).isSameAs(other);
    assertThat(poses.get(3).hierarchy()).isSameAs(poses.get(0).hierarchy());
    NearestHit ray = new NearestHit();
    ray.aim(1, 0, 0, -4, 0, 0, 1);
    assertThat(poses.get(2).isLightOccluded(ray, true)).isFalse();
    ray.aim(1, 0, 0, -4, 0, 0, 1);
    assertThat(poses.get(3).isLightOccluded(ray, true)).isTrue();
  }

  /** Returns the second hierarchy, and stores its shapes. */
  private static Bvh blockers(Bvh all, List<Shape> shapes, List<Light> lights, List<Shape> kept) {
    return Hierarchies.of(
            all,
            shapes,
            lights,
            some -> {
              kept.addAll(some);
              return all.part(some);
            })
        .blockers();
  }
}
