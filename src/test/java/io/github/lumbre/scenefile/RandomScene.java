package io.github.lumbre.scenefile;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_COLOR;
import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.DISPERSION;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.IRIDESCENCE;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.OPACITY;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SHEEN_COLOR;
import static io.github.lumbre.material.MaterialParameter.SHEEN_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SPECULAR_COLOR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;

import io.github.lumbre.camera.Aperture;
import io.github.lumbre.camera.Lens;
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
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.SpotLight;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.MicrofacetDistribution;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.material.Phong;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFile;
import io.github.lumbre.model.Models;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;
import io.github.lumbre.texture.internal.BilinearTexture;
import io.github.lumbre.texture.internal.CloudTexture;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import io.github.lumbre.texture.internal.LinearTexture;
import io.github.lumbre.texture.internal.MarbleTexture;
import io.github.lumbre.texture.internal.RedChannel;
import io.github.lumbre.texture.internal.StudioSky;
import io.github.lumbre.texture.internal.TexelTexture;
import io.github.lumbre.texture.internal.TintedTexture;
import io.github.lumbre.texture.internal.VoronoiTexture;
import io.github.lumbre.texture.internal.WoodTexture;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Random scenes of everything that the scene format has, by seed. */
final class RandomScene {
  private final Random random;
  private final List<Material> materials = new ArrayList<>();
  private final SharedMesh shared;
  private final Pixels pixels;

  private RandomScene(long seed) {
    random = new Random(seed);
    shared = new SharedMesh(mesh());
    pixels = pixels();
  }

  /** Returns a scene: consecutive seeds cycle through cameras, shapes, materials and lights. */
  static SceneBuilder of(int seed) throws Exception {
    return new RandomScene(seed).build(seed);
  }

  private SceneBuilder build(int seed) throws Exception {
    SceneBuilder scene = Scene.builder();
    scene.lookingAt(vec(1).plus(new Vec3(0, 1, -6)), vec(.5), vec(.3).plus(Vec3.Y), lens(seed));
    for (int i = 0; i < 12; i++) {
      materials.add(material(seed + i));
    }
    if (seed % 3 == 0) {
      scene.name(materials.get(0), "näme \"0\"");
    }
    int nodes = 6 + random.nextInt(6);
    for (int i = 0; i < nodes; i++) {
      node(scene, seed + i, 0);
    }
    switch (seed % 4) {
      case 0 -> scene.lightGroup("").addBackground(rgb(1));
      case 1 -> scene.add(EnvironmentLight.uniform(rgb(1)));
      case 2 -> scene.add(sky(seed / 4));
      default -> scene.addAmbient(rgb(.5));
    }
    if (seed % 5 == 0) {
      Backplate seen =
          seed % 2 == 0 ? Backplate.plain(rgb(1)) : new Backplate(rgb(1), rgb(.5));
      Vec3 corner = vec(1);
      scene.backplate(
          seed % 3 == 0
              ? seen.withShadowOf(new Bounds3(corner, corner.plus(new Vec3(1, 2, 3))))
              : seen);
    }
    if (seed % 6 == 0) {
      Path file = Path.of("scenes", "models", "lantern.glb");
      ModelFile model = Models.read(file);
      scene.add(
          seed % 4 == 0 ? "" : "lantern",
          transform(),
          seed % 12 == 0 ? model.movable() : model.withoutLights());
    }
    return scene;
  }

  private void node(SceneBuilder scene, int kind, int depth) {
    if (random.nextInt(4) == 0) {
      scene.lightGroup(random.nextBoolean() ? "" : "group_" + random.nextInt(3));
    }
    int choice = random.nextInt(8);
    if (choice == 0 && depth < 3) {
      scene.group(
          "group " + random.nextInt(),
          transform(),
          group -> {
            for (int i = 0; i < 3; i++) {
              node(group, kind + i, depth + 1);
            }
          });
    } else if (choice == 1) {
      switch (Math.floorMod(kind, 3)) {
        case 0 ->
            scene.add(
                new PointLight(
                    vec(4), rgb(3), random.nextBoolean() ? Falloff.NONE : Falloff.INVERSE_SQUARE));
        case 1 -> scene.add(DirectionalLight.along(vec(1), rgb(1)));
        default ->
            scene.add(
                SpotLight.lookingAt(vec(4), vec(1), rgb(20), 5 + random.nextInt(85))
                    .withPenumbra(random.nextDouble() * 5));
      }
    } else if (choice == 2) {
      scene.addAreaLight("lamp", shape(kind), rgb(4));
    } else if (choice == 3) {
      Texture<Rgb> texture = color(kind);
      scene.add(shape(kind), Unlit.INSTANCE, new Emission(texture, true));
      scene.addAreaLight(shape(kind + 1), new Emission(color(kind + 1), random.nextBoolean()));
    } else {
      scene.add("thing " + random.nextInt(4), shape(kind), materials.get(random.nextInt(12)));
      scene.add(shape(kind + 3), materials.get(random.nextInt(12)));
    }
  }

  private Lens lens(int kind) {
    return switch (kind % 7) {
      case 0 -> Lens.pinhole(30 + 60 * random.nextDouble());
      case 1 -> Lens.thinLens(50, 6 * random.nextDouble() + .1, random.nextDouble());
      case 2 ->
          Lens.thinLens(50, 5, .5)
              .shaped(Aperture.mask(new boolean[][] {{true, false, true}, {false, true, false}}));
      case 3 -> Lens.orthographic(3 + random.nextDouble());
      case 4 -> Lens.cylindrical(random.nextDouble() + .5);
      case 5 -> Lens.spherical();
      default -> Lens.fishEye(100 + 200 * random.nextDouble());
    };
  }

  private Shape shape(int kind) {
    return switch (Math.floorMod(kind, 8)) {
      case 0 -> Sphere.of(vec(2), .2 + random.nextDouble());
      case 1 -> new Sphere(transform(), .5);
      case 2 -> new Box(transform(), .5 + random.nextDouble(), .7, .9);
      case 3 -> new Rectangle(transform(), 1.5, 2 * random.nextDouble() + .1, random.nextBoolean());
      case 4 -> Rectangle.facing(vec(2), vec(1), 2, 1);
      case 5 -> new Plane(transform(), random.nextBoolean());
      case 6 -> new MeshInstance(shared, transform());
      default -> Mesh.of(mesh(), transform());
    };
  }

  private TriangleMesh mesh() {
    int vertices = 20;
    int[] indices = random.ints(60, 0, vertices).toArray();
    double[] positions = random.doubles(3L * vertices, -1, 1).toArray();
    double[] normals = random.doubles(3L * vertices, -1, 1).toArray();
    double[] uvs = random.doubles(2L * vertices, -3, 3).toArray();
    double[] none = {};
    return TriangleMesh.of(
        positions,
        random.nextBoolean() ? normals : none,
        random.nextBoolean() ? uvs : none,
        indices);
  }

  private Transform transform() {
    double mirror = random.nextInt(4) == 0 ? -1 : 1;
    Vec3 turn = vec(180);
    Vec3 scale = vec(.4).plus(new Vec3(mirror, 1, 1));
    return switch (random.nextInt(4)) {
      case 0 -> Transform.translation(vec(2));
      case 1 -> Transform.rotationDegrees(turn);
      case 2 ->
          Transform.translation(vec(2))
              .times(Transform.rotationDegrees(turn))
              .times(Transform.scale(scale))
              .times(Transform.rotationDegrees(vec(30)));
      default -> Transform.ofAxes(vec(.3).plus(Vec3.X), vec(.3).plus(Vec3.Y), Vec3.Z, vec(2));
    };
  }

  private Material material(int kind) {
    Material flat = flat(kind);
    boolean bumpy = random.nextInt(3) == 0 && !(flat instanceof ShadowCatcher);
    return bumpy ? new NormalMapped(flat, normalMap()) : flat;
  }

  private NormalMap normalMap() {
    return random.nextBoolean()
        ? NormalMap.of(pixels)
        : new NormalMap(
            new ImageTexture(pixels, Role.NORMAL, Filter.NEAREST),
            mapping(),
            random.nextDouble() * 2);
  }

  private Material flat(int kind) {
    return switch (Math.floorMod(kind, 9)) {
      case 0 -> Matte.of(rgb(1));
      case 1 -> Matte.of(color(kind / 9));
      case 2 -> Mirror.of(rgb(1));
      case 3 -> rough(Glass.of(.5 + random.nextDouble(), rgb(1)));
      case 4 ->
          new Glass(
              color(kind / 9), Texture.constant(Rgb.WHITE), scalar(1, 1e6, 2.5), scalar(0, 1, .5));
      case 5 -> new Phong(color(kind / 9), Texture.constant(rgb(.5)), phongExponent());
      case 6 ->
          new CookTorrance(
              Texture.constant(rgb(.5)),
              color(kind / 9),
              scalar(0, 1, .7),
              ScalarTexture.constant(1.5),
              MicrofacetDistribution.BECKMANN);
      case 7 -> random.nextBoolean() ? ShadowCatcher.of(rgb(1)) : glossy();
      default -> layered(kind / 9);
    };
  }

  private Glass rough(Glass glass) {
    Glass rough = glass.withRoughness(random.nextDouble());
    return random.nextBoolean() ? rough.withMultipleScattering() : rough;
  }

  private CookTorrance glossy() {
    CookTorrance ggx = CookTorrance.of(rgb(.5), rgb(.5), .3);
    return random.nextBoolean() ? ggx.withMultipleScattering() : ggx;
  }

  private ScalarTexture phongExponent() {
    return random.nextBoolean()
        ? ScalarTexture.constant(40)
        : new RedChannel(mapping().over(data()), 100, 0, Double.MAX_VALUE);
  }

  private Material layered(int kind) {
    MetallicRoughness.Builder builder =
        MetallicRoughness.builder()
            .set(BASE_COLOR, ColorChannel.of(color(kind), 0))
            .set(METALLIC, random.nextDouble())
            .set(ROUGHNESS, ScalarChannel.of(scalar(0, 1, .8), 0))
            .set(SPECULAR_COLOR, ColorChannel.of(rgb(1)))
            .set(SHEEN_COLOR, ColorChannel.of(rgb(.3)))
            .set(CLEARCOAT, random.nextDouble())
            .set(IOR, random.nextInt(4) == 0 ? 0 : 1 + random.nextDouble());
    switch (random.nextInt(4)) {
      case 0 ->
          builder
              .set(TRANSMISSION, .9)
              .set(ATTENUATION_COLOR, rgb(1))
              .set(ATTENUATION_DISTANCE, 2)
              .set(DISPERSION, 1);
      case 1 -> builder.set(OPACITY, random.nextDouble());
      case 2 -> builder.set(TRANSMISSION, .5).singleSided();
      default -> builder.set(SHEEN_ROUGHNESS, ScalarChannel.of(.4)).set(IRIDESCENCE, .5);
    }
    return builder.build();
  }

  private Texture<Rgb> color(int kind) {
    Texture<Rgb> picture =
        switch (Math.floorMod(kind, 8)) {
          case 0 -> Texture.constant(rgb(1));
          case 1 -> new ImageTexture(pixels, Role.COLOR, Filter.NEAREST);
          case 2 -> new ImageTexture(pixels(), Role.COLOR, Filter.BILINEAR);
          case 3 -> new LinearTexture(linear());
          case 4 -> new WoodTexture(random.nextLong(), 40, 30, 3.5);
          case 5 -> new BilinearTexture(texels());
          case 6 -> new CloudTexture(random.nextLong(), 30, 40, 8);
          default -> new VoronoiTexture(random.nextLong(), 30, 40, 7, random.nextBoolean());
        };
    boolean isConstant = picture.isConstant();
    Texture<Rgb> tinted =
        isConstant || random.nextBoolean() ? picture : TintedTexture.of(rgb(1), picture);
    return isConstant ? tinted : mapping().over(tinted);
  }

  private TexelTexture texels() {
    return new MarbleTexture(random.nextLong(), 30, 20);
  }

  private Texture<Rgb> data() {
    return random.nextBoolean()
        ? new ImageTexture(pixels, Role.DATA, Filter.BILINEAR)
        : new BilinearTexture(texels());
  }

  private ScalarTexture scalar(double low, double high, double factor) {
    return random.nextBoolean()
        ? ScalarTexture.constant(Math.max(low, factor))
        : new RedChannel(mapping().over(data()), factor, low, high);
  }

  private UvMapping mapping() {
    return random.nextInt(3) == 0
        ? UvMapping.IDENTITY
        : new UvMapping(random.nextDouble(), random.nextDouble(), 2, -1 - random.nextDouble());
  }

  private EnvironmentLight sky(int kind) {
    Vec3 turn = vec(180);
    Transform rotation = Transform.rotationDegrees(turn);
    Frame axes =
        new Frame(rotation.vector(Vec3.X), rotation.vector(Vec3.Y), rotation.vector(Vec3.Z));
    if (kind % 2 == 0) {
      return EnvironmentLight.image(
          axes, TintedTexture.of(rgb(1), StudioSky.SOFT), 256, 128);
    }
    Image image = linear();
    return EnvironmentLight.image(
        axes, TintedTexture.of(rgb(1), new LinearTexture(image)), image.width(), image.height());
  }

  private Pixels pixels() {
    int channels = 1 + random.nextInt(4);
    int width = 3 + random.nextInt(4);
    if (random.nextBoolean()) {
      byte[] values = new byte[width * 5 * channels];
      random.nextBytes(values);
      return Pixels.of(width, 5, channels, values);
    }
    short[] values = new short[width * 5 * channels];
    for (int i = 0; i < values.length; i++) {
      values[i] = (short) random.nextInt();
    }
    return Pixels.of(width, 5, channels, values);
  }

  private Image linear() {
    float[] values = new float[3 * 8 * 4];
    for (int i = 0; i < values.length; i++) {
      values[i] = random.nextFloat() * 2;
    }
    return new Image(8, 4, values, new float[0]);
  }

  private Vec3 vec(double size) {
    return new Vec3(signed(size), signed(size), signed(size));
  }

  private double signed(double size) {
    return size * (2 * random.nextDouble() - 1);
  }

  private Rgb rgb(double size) {
    return new Rgb(
        size * random.nextDouble(), size * random.nextDouble(), size * random.nextDouble());
  }
}
