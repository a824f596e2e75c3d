package io.github.lumbre.integrator;

import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.testing.TestScenes.at;
import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.floor;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.plastic;
import static io.github.lumbre.testing.TestScenes.point;
import static io.github.lumbre.testing.TestScenes.turned;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SharedMesh;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.testing.TestScenes;
import io.github.lumbre.texture.Texture;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Surfaces at the place of others that rays pass: the others have the same light, bit for bit, as
 * if they were alone.
 */
class CoincidingSurfacesTest {
  private static final int RAYS = 200;

  /** A kind of surface, in the xz plane, with its front up or down. */
  private enum Kind {
    RECTANGLE {
      @Override
      Shape of(Transform place, double size, boolean isUp) {
        return new Rectangle(isUp ? place : place.times(turned(180, 0, 0)), size, size, true);
      }
    },
    MESH {
      @Override
      Shape of(Transform place, double size, boolean isUp) {
        return Mesh.of(quad(size, isUp), place);
      }
    },
    INSTANCE {
      @Override
      Shape of(Transform place, double size, boolean isUp) {
        return new MeshInstance(new SharedMesh(quad(size, isUp)), place);
      }
    };

    abstract Shape of(Transform place, double size, boolean isUp);
  }

  private static TriangleMesh quad(double size, boolean isUp) {
    double h = size / 2;
    double[] p = {-h, 0, -h, h, 0, -h, h, 0, h, -h, 0, h};
    int[] f = isUp ? new int[] {0, 2, 1, 0, 3, 2} : new int[] {0, 1, 2, 0, 2, 3};
    return TriangleMesh.of(p, new double[0], new double[0], f);
  }

  private static Material veil(double opacity) {
    return plastic(0).set(OPACITY, ScalarChannel.of(opacity)).build();
  }

  private static SceneBuilder lit() {
    return empty()
        .add(EnvironmentLight.uniform(new Rgb(.5, .6, .7)))
        .add(point(new Vec3(1, 9, 2), 20))
        .add(new Sphere(at(0, 4, 0), .5), matte(.3));
  }

  private static Scene scene(
      Shape wall, Material ofWall, Shape twin, Material ofTwin, boolean isFirst) {
    return isFirst
        ? lit().add(twin, ofTwin).add(wall, ofWall).build()
        : lit().add(wall, ofWall).add(twin, ofTwin).build();
  }

  /** Returns rays from above to points of the square between -1/2 and 1/2. */
  private static List<Ray> raysDown(Transform place, Random random) {
    List<Ray> rays = new ArrayList<>();
    for (int i = 0; i < RAYS; i++) {
      Vec3 target = place.point(new Vec3(random.nextDouble() - .5, 0, random.nextDouble() - .5));
      Vec3 from =
          place.point(
              new Vec3(4 * random.nextDouble() - 2, 1 + random.nextDouble(), random.nextDouble()));
      rays.add(new Ray(from, target.minus(from).normalized()));
    }
    return rays;
  }

  private static List<Transform> places() {
    return List.of(Transform.IDENTITY, at(.3, 0, -.7), at(.1, .2, .3).times(turned(20, 130, -15)));
  }

  private static List<Integrator> integrators(Scene scene) {
    return List.of(
        new PathTracer(scene, 5),
        new PathTracer(scene, PathOptions.toDepth(4).splitInto(3)),
        new RayTracer(scene, 4, 8));
  }

  /** Returns the light along each ray for each integrator. */
  private static List<List<Rgb>> light(Scene scene, List<Ray> rays) {
    List<List<Rgb>> all = new ArrayList<>();
    for (Integrator integrator : integrators(scene)) {
      List<Rgb> light = light(integrator, rays);
      assertThat(light.stream().mapToDouble(Rgb::g).average().orElseThrow()).isGreaterThan(.05);
      all.add(light);
    }
    return all;
  }

  private static List<Rgb> light(Integrator integrator, List<Ray> rays) {
    return IntStream.range(0, rays.size())
        .mapToObj(sample -> radiance(integrator, rays.get(sample), sample))
        .toList();
  }

  private static void assertSameLight(Scene twins, List<List<Rgb>> alone, List<Ray> rays) {
    assertThat(light(twins, rays)).as("%s", rays).isEqualTo(alone);
  }

  private static Rgb radiance(Integrator integrator, Ray ray, int sample) {
    SobolSampler sampler = new SobolSampler(3);
    sampler.startSample(1, 2, sample);
    RenderContext context = new RenderContext();
    context.startSample();
    Rgb light = integrator.radiance(ray, sampler, context);
    assertThat(context.hitSomething()).isTrue();
    return light;
  }

  /** The twins of a card: each side of it is the front of one of them. */
  @ParameterizedTest
  @EnumSource(Kind.class)
  void cardsOfTwoOneSidedSurfacesAreWhole(Kind kind) {
    Random random = new Random(1);
    Material single = plastic(.8).singleSided().build();
    for (Transform place : places()) {
      Shape up = kind.of(place, 1, true);
      Shape down = kind.of(place, 1, false);
      List<Ray> rays = raysDown(place, random);
      List<List<Rgb>> alone = light(lit().add(up, single).build(), rays);
      for (boolean isFirst : new boolean[] {true, false}) {
        assertSameLight(scene(up, single, down, single, isFirst), alone, rays);
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Kind.class)
  void invisibleDecalsLeaveTheirWallsAsTheyAre(Kind kind) {
    Random random = new Random(2);
    for (Transform place : places()) {
      for (Kind ofWall : Kind.values()) {
        Shape wall = ofWall.of(place, 1, true);
        List<Ray> rays = raysDown(place, random);
        List<List<Rgb>> alone = light(lit().add(wall, matte(.8)).build(), rays);
        for (double size : new double[] {.8, 1, 1.5, 100}) {
          Shape decal = kind.of(place, size, true);
          for (boolean isFirst : new boolean[] {true, false}) {
            assertSameLight(scene(wall, matte(.8), decal, veil(0), isFirst), alone, rays);
          }
        }
      }
    }
  }

  /** Closed shapes: their transparent twins are met on both sides. */
  @Test
  void invisibleTwinsOfClosedShapesLeaveThemAsTheyAre() {
    Random random = new Random(3);
    for (Transform place : places()) {
      for (Shape shape : List.of(new Sphere(place, .5), new Box(place, 1, .25, 1))) {
        Scene alone = lit().add(shape, matte(.8)).build();
        for (boolean isFirst : new boolean[] {true, false}) {
          Scene twins = scene(shape, matte(.8), shape, veil(0), isFirst);
          List<Ray> rays =
              raysDown(place, random).stream()
                  .filter(ray -> alone.intersect(ray, new NearestHit()))
                  .toList();
          assertSameLight(twins, light(alone, rays), rays);
        }
      }
    }
  }

  /** A decal and its wall mix; neither shades the other, whatever its size and kind. */
  @ParameterizedTest
  @ValueSource(doubles = {.8, 1, 1.5, 100, 1e4})
  void halfTransparentDecalsMixWithTheirWalls(double size) {
    Random random = new Random(4);
    int decals = 0;
    for (Transform place : places()) {
      for (Kind ofWall : Kind.values()) {
        Shape wall = ofWall.of(place, 1, true);
        List<Ray> rays = raysDown(place, random);
        Scene alone = underSky(place).add(wall, matte(.8)).build();
        List<Rgb> ofPaths = light(new PathTracer(alone, 1), rays);
        List<Rgb> ofRays = light(new RayTracer(alone, 2, 2), rays);
        for (Kind kind : Kind.values()) {
          Shape decal = kind.of(place, size, true);
          Scene both = underSky(place).add(decal, veil(.5)).add(wall, matte(.8)).build();
          decals += decals(new PathTracer(both, 1), ofPaths, rays);
          decals += decals(new RayTracer(both, 2, 2), ofRays, rays);
        }
      }
    }
    // Where rounding puts the wall in front, it hides the decal.
    int rays = 2 * places().size() * Kind.values().length * Kind.values().length * RAYS;
    assertThat(decals).isBetween(rays / 8, rays * 11 / 20);
  }

  private static SceneBuilder underSky(Transform place) {
    return empty()
        .add(EnvironmentLight.uniform(new Rgb(.5, .6, .7)))
        .add(point(place.point(new Vec3(1, 3, 2)), 20));
  }

  /**
   * Checks that each ray finds the wall's light, or the black decal; returns how many find that.
   */
  private static int decals(Integrator both, List<Rgb> alone, List<Ray> rays) {
    int decals = 0;
    for (int sample = 0; sample < rays.size(); sample++) {
      Rgb found = radiance(both, rays.get(sample), sample);
      assertThat(found).isIn(Rgb.BLACK, alone.get(sample));
      decals += found.equals(Rgb.BLACK) ? 1 : 0;
    }
    return decals;
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void shadowCatchersWithTwinsCatchTheSameShadows(boolean isFirst) {
    Material catcher = new ShadowCatcher(Texture.constant(Rgb.WHITE));
    Material hidden = plastic(.5).singleSided().build();
    Shape below = new Rectangle(turned(180, 0, 0), 1e4, 1e4, true);
    Shape blocker = new Rectangle(at(0, 1, 0), 1, 1, true);
    Scene alone =
        empty()
            .add(floor(), catcher)
            .add(blocker, matte(.5))
            .add(point(Vec3.Y.times(2), 3))
            .build();
    SceneBuilder builder = empty();
    if (isFirst) {
      builder.add(below, hidden);
    }
    builder.add(floor(), catcher).add(blocker, matte(.5)).add(point(Vec3.Y.times(2), 3));
    if (!isFirst) {
      builder.add(below, hidden);
    }
    Scene twins = builder.build();
    int dark = 0;
    for (int i = 0; i < RAYS; i++) {
      Ray ray = TestScenes.lookingDownAt(.02 * i, .5);
      assertThat(opacity(twins, ray, i)).isEqualTo(opacity(alone, ray, i));
      dark += opacity(alone, ray, i) ? 1 : 0;
    }
    assertThat(dark).isBetween(RAYS / 10, RAYS * 9 / 10);
  }

  private static boolean opacity(Scene scene, Ray ray, int sample) {
    SobolSampler sampler = new SobolSampler(3);
    sampler.startSample(1, 2, sample);
    RenderContext context = new RenderContext();
    context.startSample();
    new PathTracer(scene, 3).radiance(ray, sampler, context);
    return context.hitSomething();
  }

  @Test
  void layersShowTheSurfaceBehindItsInvisibleTwin() {
    Transform place = places().get(2);
    Shape wall = Kind.MESH.of(place, 1, true);
    Scene alone = lit().add(wall, matte(.8)).build();
    Set<Layer> layers =
        EnumSet.of(
            Layer.ALBEDO, Layer.NORMAL, Layer.POSITION, Layer.DEPTH, Layer.DIRECT, Layer.LIGHTS);
    for (boolean isFirst : new boolean[] {true, false}) {
      Scene twins = scene(wall, matte(.8), Kind.MESH.of(place, .9, true), veil(0), isFirst);
      SampleLayers expected = new SampleLayers(layers, alone);
      SampleLayers found = new SampleLayers(layers, twins);
      for (Ray ray : raysDown(place, new Random(5))) {
        collect(alone, ray, expected);
        collect(twins, ray, found);
        for (Layer layer : layers) {
          assertThat(found.of(layer)).as(layer.toString()).isEqualTo(expected.of(layer));
        }
        assertThat(found.of(Layer.DEPTH)[0]).isPositive();
      }
    }
  }

  private static void collect(Scene scene, Ray ray, SampleLayers layers) {
    SobolSampler sampler = new SobolSampler(3);
    sampler.startSample(1, 2, 3);
    RenderContext context = RenderContext.collecting(layers);
    context.startSample();
    layers.start(new CameraRay());
    new PathTracer(scene, 5).radiance(ray, sampler, context);
  }
}
