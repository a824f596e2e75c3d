package io.github.lumbre.render;

import static io.github.lumbre.testing.Draws.inCube;
import static io.github.lumbre.testing.TestScenes.at;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.ThinLensCamera;
import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SharedMesh;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Moments;
import io.github.lumbre.testing.Statistics;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.internal.ImageTexture;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests pictures of scenes and cameras with extreme parameters. */
class ExtremePicturesTest {
  private static final Rgb RED = new Rgb(1, 0, 0);
  private static final Rgb GREEN = new Rgb(0, 1, 0);

  private final SplittableRandom random = new SplittableRandom(Effort.seed(41));

  private static RenderSettings.Builder settings(int width, int height, int samples) {
    return new RenderSettings.Builder().size(width, height).samples(samples).threads(2);
  }

  private static Emission glow(Rgb radiance) {
    return new Emission(Texture.constant(radiance), true);
  }

  private static List<Camera> cameras(Vec3 position, double aspect) {
    Frame axes = Frame.WORLD;
    List<Camera> cameras = new ArrayList<>();
    for (double fov : new double[] {1e-12, 1e-6, 60, 179, 179.999999}) {
      cameras.add(Lens.pinhole(fov).camera(position, axes, aspect));
      for (double aperture : new double[] {0, 1e-12, .2, 1e6}) {
        cameras.add(new ThinLensCamera(position, axes, aspect, fov, 5, aperture, Aperture.DISK));
      }
    }
    cameras.add(Lens.spherical().camera(position, axes, aspect));
    cameras.add(Lens.cylindrical(0).camera(position, axes, aspect));
    cameras.add(Lens.cylindrical(1e150).camera(position, axes, aspect));
    cameras.add(Lens.fishEye(360).camera(position, axes, aspect));
    return cameras;
  }

  /** In a uniform white environment, a pixel that is not white has lost its ray. */
  @ParameterizedTest
  @CsvSource({"1, 1", "1, 16384", "16384, 1", "3, 2"})
  void everyCameraHasARayForEveryPixelOfEverySize(int width, int height)
      throws InterruptedException {
    for (Camera camera : cameras(new Vec3(0, 0, -3), (double) width / height)) {
      Scene scene =
          Scene.builder()
              .seenBy(camera)
              .add(new Sphere(Transform.IDENTITY, 1), Unlit.INSTANCE, glow(Rgb.WHITE))
              .addBackground(Rgb.WHITE)
              .build();
      Image image = new PictureRenderer(settings(width, height, 1).build()).render(scene);
      for (int i = 0; i < width * height; i++) {
        Rgb pixel = image.pixel(i % width, i / width);
        if (!pixel.equals(Rgb.WHITE)) {
          assertThat(pixel).as("%s", camera).isEqualTo(Rgb.BLACK);
          assertThat(camera.leavesBlanks()).as("%s", camera).isTrue();
        }
      }
    }
  }

  private static Matte matte(Rgb albedo) {
    return new Matte(Texture.constant(albedo));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-3, 5, 1e12, Double.POSITIVE_INFINITY})
  void pictureThroughAClosedLensIsThePinholesToTheBit(double focus) throws InterruptedException {
    Vec3 eye = new Vec3(0, 1, -4);
    Camera pinhole = Lens.pinhole(50).camera(eye, Frame.WORLD, 1.5);
    Camera closed = new ThinLensCamera(eye, Frame.WORLD, 1.5, 50, focus, 0, Aperture.DISK);
    RenderSettings settings = settings(30, 20, 4).seed(Effort.seed(1)).build();
    float[] expected = new PictureRenderer(settings).render(stillLife(pinhole).build()).rgb();
    float[] found = new PictureRenderer(settings).render(stillLife(closed).build()).rgb();
    assertThat(found).isEqualTo(expected);
  }

  private static SceneBuilder stillLife(Camera camera) {
    return Scene.builder()
        .seenBy(camera)
        .add(new Plane(Transform.IDENTITY, false), Matte.GRAY)
        .add(new Sphere(at(-.8, .7, 0), .7), matte(new Rgb(.8, .3, .2)))
        .add(
            new Box(at(1, .5, .3).times(Transform.rotationDegrees(new Vec3(0, 30, 0))), 1, 1, 1),
            matte(new Rgb(.2, .5, .8)))
        .addAreaLight(
            new Rectangle(
                at(.5, 3, -1).times(Transform.rotationDegrees(new Vec3(180, 0, 0))), 1, 2, false),
            glow(Rgb.gray(4)));
  }

  /** A sphere fills the same fraction of a frame of 1.5 radii from any distance. */
  @ParameterizedTest
  @ValueSource(doubles = {1e2, 1e4, 1e6, 1e8})
  void distantBallKeepsItsSize(double distance) throws InterruptedException {
    double fov = 2 * Math.toDegrees(StrictMath.atan(1.5 / distance));
    Vec3 eye = new Vec3(.3, -.2, .5).plus(distance, new Vec3(0, 0, -1));
    Scene scene =
        Scene.builder()
            .seenBy(Lens.pinhole(fov).camera(eye, Frame.WORLD, 1))
            .add(new Sphere(at(.3, -.2, .5), 1), Unlit.INSTANCE, glow(Rgb.WHITE))
            .build();
    int replicates = 100;
    Moments share = new Moments();
    for (int seed = 0; seed < replicates; seed++) {
      RenderSettings settings = settings(32, 32, 1).seed(Effort.seed(seed)).build();
      float[] rgb = new PictureRenderer(settings).render(scene).rgb();
      double sum = 0;
      for (int i = 0; i < rgb.length; i += 3) {
        assertThat(rgb[i]).isIn(0f, 1f);
        sum += rgb[i];
      }
      share.add(sum / (32 * 32));
    }
    double apparent = 1 / (1 - 1 / (distance * distance));
    // The test therefore detects an error of 0.003.
    assertThat(Math.sqrt(share.variance() / replicates)).isLessThan(4e-4);
    assertThat(Statistics.deviation(share.z(Math.PI / 9 * apparent)))
        .isLessThan(Statistics.CRITICAL_Z);
  }

  /** Of coplanar surfaces, the first one is visible everywhere, without speckles. */
  @Test
  void coincidingSurfacesShowTheFirst() throws InterruptedException {
    for (int i = 0; i < 20; i++) {
      Transform place =
          at(0, 0, 4)
              .times(Transform.rotationDegrees(inCube(random, 40)))
              .times(Transform.rotationDegrees(new Vec3(-90, 0, 0)));
      for (boolean redFirst : new boolean[] {true, false}) {
        Scene scene =
            Scene.builder()
                .seenBy(Lens.pinhole(20).camera(Vec3.ZERO, Frame.WORLD, 1))
                .add(new Rectangle(place, 9, 9, true), Unlit.INSTANCE, glow(redFirst ? RED : GREEN))
                .add(new Rectangle(place, 8, 7, true), Unlit.INSTANCE, glow(redFirst ? GREEN : RED))
                .add(new Rectangle(place, 9, 9, true), Unlit.INSTANCE, glow(redFirst ? GREEN : RED))
                .build();
        for (int threads = 1; threads < 4; threads++) {
          RenderSettings settings = settings(24, 24, 1).threads(threads).bucketSize(7).build();
          Image image = new PictureRenderer(settings).render(scene);
          for (int pixel = 0; pixel < 24 * 24; pixel++) {
            assertThat(image.pixel(pixel % 24, pixel / 24)).isEqualTo(redFirst ? RED : GREEN);
          }
        }
      }
    }
  }

  /** The gap between two planes is dark at any width. */
  @ParameterizedTest
  @CsvSource({"1e-9, 1", "1e-9, 1e3", "1e-6, 1e3", "1e-3, 10", "1, 10"})
  void noLightComesBetweenTwoPlanes(double gap, double distance) throws InterruptedException {
    double fov = 2 * Math.toDegrees(StrictMath.atan(.4 * gap / distance));
    Transform tilt = Transform.rotationDegrees(inCube(random, 180));
    Frame axes = new Frame(tilt.vector(Vec3.X), tilt.vector(Vec3.Y), tilt.vector(Vec3.Z));
    Vec3 eye = tilt.point(new Vec3(0, .5 * gap, 0));
    Transform above = tilt.times(at(0, gap, 0));
    // Without an end surface, rays would see through the gap where it is narrower than rounding.
    // The end is black, because points within an ulp of a corner may be behind the corner.
    Transform end =
        tilt.times(at(0, 0, distance)).times(Transform.rotationDegrees(Vec3.X.times(90)));
    Scene scene =
        Scene.builder()
            .seenBy(Lens.pinhole(Math.min(fov * 10, 90)).camera(eye, axes, 1))
            .add(new Plane(tilt, true), matte(Rgb.WHITE))
            .add(new Plane(above, true), matte(Rgb.WHITE))
            .add(new Plane(end, true), matte(Rgb.BLACK))
            .add(point(tilt.point(new Vec3(1, 2 + gap, distance))))
            .add(point(tilt.point(new Vec3(1, -2, .5 * distance))))
            .addAreaLight(new Sphere(tilt.times(at(0, 4 + gap, distance)), 1), glow(Rgb.WHITE))
            .addAreaLight(new Sphere(tilt.times(at(0, -3, distance)), 1), glow(Rgb.WHITE))
            .build();
    RenderSettings settings =
        settings(64, 64, Effort.count(4, 64)).maxTraceDepth(4).seed(Effort.seed(1)).build();
    for (float value : new PictureRenderer(settings).render(scene).rgb()) {
      assertThat(value).isZero();
    }
  }

  private static PointLight point(Vec3 position) {
    return new PointLight(position, Rgb.WHITE, Falloff.NONE);
  }

  /** The mean over a textured wall is that of its texels, whose standard deviation is below 0.3. */
  @ParameterizedTest
  @CsvSource({"1, 1", "3, 5", "64, 48", "16384, 2"})
  void texturedWallHasTheMeanOfItsTexels(int width, int height) throws InterruptedException {
    byte[] values = new byte[3 * width * height];
    random.nextBytes(values);
    ImageTexture texture =
        new ImageTexture(
            Pixels.of(width, height, 3, values),
            ImageTexture.Role.DATA,
            ImageTexture.Filter.NEAREST);
    double expected = 0;
    for (int i = 0; i < values.length; i += 3) {
      expected += (values[i] & 255) / 255.0 / (width * height);
    }
    // Facing the camera, and exactly as large as the frame at distance 1.
    Transform place = at(0, 0, 1).times(Transform.rotationDegrees(new Vec3(-90, 0, 0)));
    Scene scene =
        Scene.builder()
            .seenBy(Lens.pinhole(90).camera(Vec3.ZERO, Frame.WORLD, 1))
            .add(
                new Rectangle(place, 2.000001, 2.000001, true),
                Unlit.INSTANCE,
                new Emission(texture, true))
            .build();
    Moments means = new Moments();
    for (int seed = 0; seed < 100; seed++) {
      RenderSettings settings = settings(8, 8, 4).seed(Effort.seed(seed)).build();
      float[] rgb = new PictureRenderer(settings).render(scene).rgb();
      double sum = 0;
      for (int i = 0; i < rgb.length; i += 3) {
        sum += rgb[i] / 64;
      }
      means.add(sum);
    }
    assertThat(means.mean()).isCloseTo(expected, within(.02));
    if (width > 1) {
      assertThat(Statistics.deviation(means.z(expected))).isLessThan(Statistics.CRITICAL_Z);
    } else {
      assertThat(means.mean()).isCloseTo(expected, within(1e-6));
    }
  }

  @Test
  void mirroredScenesGiveMirroredPictures() throws InterruptedException {
    int side = 8;
    int replicates = Effort.count(150, 5000);
    Moments[] plain = moments(side * side);
    Moments[] mirrored = moments(side * side);
    Transform mirror = Transform.scale(new Vec3(-1, 1, 1));
    Scene scene = lopsided(Transform.IDENTITY);
    Scene image = lopsided(mirror);
    for (int i = 0; i < replicates; i++) {
      RenderSettings settings =
          settings(side, side, 2).maxTraceDepth(3).seed(Effort.seed(i)).build();
      Image one = new PictureRenderer(settings).render(scene);
      // Different random numbers, so that the two pictures are independent.
      Image other =
          new PictureRenderer(settings.toBuilder().seed(Effort.seed(i) + 1_000_000).build())
              .render(image);
      for (int pixel = 0; pixel < side * side; pixel++) {
        int x = pixel % side;
        int y = pixel / side;
        plain[pixel].add(one.pixel(x, y).g());
        mirrored[pixel].add(other.pixel(side - 1 - x, y).g());
      }
    }
    for (int pixel = 0; pixel < side * side; pixel++) {
      assertThat(Statistics.deviation(plain[pixel].z(mirrored[pixel])))
          .isLessThan(Statistics.CRITICAL_Z);
    }
  }

  private static Moments[] moments(int count) {
    Moments[] moments = new Moments[count];
    for (int i = 0; i < count; i++) {
      moments[i] = new Moments();
    }
    return moments;
  }

  private static Scene lopsided(Transform all) {
    Camera camera = Lens.pinhole(40).camera(new Vec3(0, 1, -5), Frame.WORLD, 1);
    Transform lamp = at(2, 3, -1).times(Transform.rotationDegrees(new Vec3(180, 0, 20)));
    return Scene.builder()
        .seenBy(camera)
        .add(new Plane(all, false), Matte.GRAY)
        .add(Mesh.baked(tetrahedron(), all.times(at(-.9, .1, 0))), matte(new Rgb(.2, .8, .4)))
        .add(new Sphere(all.times(at(1.1, .6, .4)), .6), Matte.GRAY)
        .addAreaLight(new Rectangle(all.times(lamp), 1, 2, false), glow(Rgb.gray(6)))
        .build();
  }

  private static TriangleMesh tetrahedron() {
    double[] p = {0, 0, 0, 1, 0, 0, 0, 1, .1, .2, .1, 1};
    double[] n = {-1, -1, -1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    return TriangleMesh.of(p, n, new double[0], new int[] {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  }

  /**
   * A thousand instances of one mesh look like a thousand meshes, except for a few border pixels.
   */
  @Test
  void instancesLookLikeCopies() throws InterruptedException {
    TriangleMesh mesh = tetrahedron();
    SharedMesh shared = new SharedMesh(mesh);
    List<Transform> places = new ArrayList<>();
    for (int i = 0; i < 1000; i++) {
      double size = random.nextDouble(.1, .5);
      places.add(
          Transform.translation(inCube(random, 3))
              .times(Transform.rotationDegrees(inCube(random, 180)))
              .times(Transform.scale(new Vec3(size, size * random.nextDouble(.5, 2), size))));
    }
    int height = Effort.count(60, 480);
    RenderSettings settings =
        settings(height * 4 / 3, height, 1).maxTraceDepth(2).seed(Effort.seed(1)).build();
    float[] baked = render(settings, places, place -> Mesh.baked(mesh, place));
    float[] placed = render(settings, places, place -> new MeshInstance(shared, place));
    int different = 0;
    double lit = 0;
    for (int i = 0; i < baked.length; i++) {
      different += Math.abs(placed[i] - baked[i]) <= 1e-6 * baked[i] ? 0 : 1;
      lit += baked[i] > 0 ? 1 : 0;
    }
    assertThat(lit / baked.length).isGreaterThan(.25);
    assertThat(different).isLessThanOrEqualTo(baked.length / 10_000);
  }

  private static float[] render(
      RenderSettings settings, List<Transform> places, Function<Transform, Shape> shape)
      throws InterruptedException {
    SceneBuilder scene =
        Scene.builder()
            .seenBy(Lens.pinhole(40).camera(new Vec3(0, 0, -8), Frame.WORLD, settings.aspect()))
            .addAreaLight(new Sphere(at(3, 6, -6), 1), glow(Rgb.gray(9)))
            .addAreaLight(new Sphere(at(-5, 2, -7), .5), glow(Rgb.gray(9)));
    for (int i = 0; i < places.size(); i++) {
      double shade = (double) i / places.size();
      scene.add(shape.apply(places.get(i)), matte(new Rgb(shade, .5, 1 - shade)));
    }
    return new PictureRenderer(settings).render(scene.build()).rgb();
  }
}
