package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Channel;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.SurfacePoint;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.SampledTexture;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Makes the materials of a model; each picture is decoded once. */
final class ModelMaterials {
  private final double unit;
  private final Limits limits;
  private long texels;
  private final Warnings warnings;

  /** Empty for pictures that cannot be decoded. */
  private final Map<ModelImage, Optional<Pixels>> pictures;

  private final DecodedPictures decoded;

  private final Map<ModelMaterial, Map<Boolean, Material>> made = new IdentityHashMap<>();

  /**
   * @param toWorld from the model's world space to the scene's
   * @param limits of all pictures
   * @param decoded the pictures of other poses of the model
   */
  ModelMaterials(Transform toWorld, Limits limits, DecodedPictures decoded) {
    this(
        toWorld,
        limits,
        Collections.synchronizedMap(new IdentityHashMap<>()),
        decoded,
        new Warnings());
  }

  private ModelMaterials(
      Transform toWorld,
      Limits limits,
      Map<ModelImage, Optional<Pixels>> pictures,
      DecodedPictures decoded,
      Warnings warnings) {
    unit = toWorld.vector(Vec3.X).length();
    this.limits = limits;
    this.pictures = pictures;
    this.decoded = decoded;
    this.warnings = warnings;
  }

  /** Returns the materials of the model at another place, with the same textures. */
  ModelMaterials at(Transform toWorld) {
    return new ModelMaterials(toWorld, limits, pictures, decoded, warnings);
  }

  /**
   * Returns the scattering of a material.
   *
   * @param isClosed whether its surface is closed, so that rays from outside meet no back face
   * @throws ModelFormatException if a texture is too large
   */
  Material of(ModelMaterial material, boolean isClosed) throws ModelFormatException {
    Map<Boolean, Material> both = made.computeIfAbsent(material, m -> new HashMap<>());
    Material known = both.get(isClosed);
    if (known == null) {
      known = material(material, isClosed);
      both.put(isClosed, known);
    }
    return known;
  }

  /** Returns the number of texels of the pictures decoded so far. */
  long texels() {
    return texels;
  }

  /** Returns the number of pictures decoded so far. */
  int pictures() {
    return (int) pictures.values().stream().filter(Optional::isPresent).count();
  }

  /** Adds a warning about a surface. */
  void warn(String location, String message) {
    warnings.add(location, message);
  }

  /** Returns the warnings; materials are made without the pictures that cannot be decoded. */
  List<String> warnings() {
    return warnings.all();
  }

  private Material material(ModelMaterial m, boolean isClosed) throws ModelFormatException {
    MetallicRoughness.Builder builder = MetallicRoughness.builder();
    if (m.unlit()) {
      builder.set(MaterialParameter.BASE_COLOR, Rgb.BLACK);
      builder.set(MaterialParameter.SPECULAR, 0).set(MaterialParameter.METALLIC, 0);
    } else {
      addLobes(m, builder);
    }
    switch (m.alphaMode()) {
      case OPAQUE -> {}
      case MASK -> builder.set(MaterialParameter.OPACITY, mask(opacity(m), m.alphaCutoff()));
      case BLEND -> builder.set(MaterialParameter.OPACITY, opacity(m));
    }
    if (!m.doubleSided() && !isClosed) {
      builder.singleSided();
    }
    Material material = builder.build();
    Optional<NormalChannel> normals =
        m.normalMap().isPresent() && !m.unlit() ? normals(m.normalMap().get()) : Optional.empty();
    return normals.isPresent()
        ? new NormalMapped(material, normals.get().map(), normals.get().uvSet())
        : material;
  }

  private void addLobes(ModelMaterial m, MetallicRoughness.Builder builder)
      throws ModelFormatException {
    for (MaterialParameter parameter : MaterialParameter.all()) {
      if (m.uses(parameter) && parameter != MaterialParameter.OPACITY) {
        MaterialInput input = m.input(parameter);
        Optional<? extends Channel> value =
            switch (parameter.kind()) {
              case COLOR -> Optional.of(color(input));
              case NUMBER -> Optional.of(scalar(input));
              case NORMALS -> normals(input);
            };
        value.ifPresent(channel -> builder.set(parameter, channel));
      }
    }
    ColorChannel plain =
        m.hatch().isPresent()
            ? ColorChannel.of(m.hatch().get(), 0)
            : color(m.input(MaterialParameter.BASE_COLOR));
    ColorChannel baseColor = timesVertexColor(plain);
    if (m.glossy()) {
      ColorChannel specular = color(m.input(MaterialParameter.SPECULAR_COLOR));
      ScalarChannel glossiness = scalar(m.input(MaterialParameter.ROUGHNESS));
      builder.set(MaterialParameter.BASE_COLOR, below(specular, baseColor));
      builder.set(MaterialParameter.ROUGHNESS, complement(glossiness));
    } else {
      builder.set(MaterialParameter.BASE_COLOR, baseColor);
    }
    if (m.uses(MaterialParameter.ATTENUATION_DISTANCE)) {
      double distance = m.input(MaterialParameter.ATTENUATION_DISTANCE).number();
      builder.set(MaterialParameter.ATTENUATION_DISTANCE, distance * unit);
    }
  }

  private static ColorChannel timesVertexColor(ColorChannel color) {
    return point -> color.at(point).times(point.vertexColor());
  }

  /** Returns a diffuse color times the part of light that a reflection leaves head-on. */
  private static ColorChannel below(ColorChannel specular, ColorChannel diffuse) {
    return point -> diffuse.at(point).times(Math.max(0, 1 - specular.at(point).max()));
  }

  private static ScalarChannel complement(ScalarChannel number) {
    return point -> 1 - number.at(point);
  }

  private ScalarChannel opacity(ModelMaterial m) throws ModelFormatException {
    ScalarChannel opacity = scalar(m.input(MaterialParameter.OPACITY));
    return point -> opacity.at(point) * point.vertexAlpha();
  }

  private static ScalarChannel mask(ScalarChannel opacity, double cutoff) {
    return point -> opacity.at(point) >= cutoff ? 1 : 0;
  }

  /** Returns a normal map, unless its picture cannot be decoded. */
  private Optional<NormalChannel> normals(MaterialInput input) throws ModelFormatException {
    Optional<ModelTexture> usable = usable(input.texture());
    if (usable.isEmpty()) {
      return Optional.empty();
    }
    Texture<Rgb> texture = texture(usable.get(), ImageTexture.Role.NORMAL);
    return Optional.of(
        new NormalChannel(new NormalMap(texture, input.number()), usable.get().uvSet()));
  }

  /**
   * Returns the emission of a material; empty if it emits nothing.
   *
   * @param isColored whether the vertices of the surface have colors
   * @throws ModelFormatException if a texture is too large
   */
  Optional<Emission> emission(ModelMaterial m, boolean isColored) throws ModelFormatException {
    MaterialInput input = m.unlit() ? m.input(MaterialParameter.BASE_COLOR) : m.emission();
    if (input.factor().isBlack()) {
      return Optional.empty();
    }
    if (input.texture().isPresent() && usable(input.texture()).isEmpty() && !m.unlit()) {
      // Without its texture, a surface would glow all over.
      return Optional.empty();
    }
    boolean isTinted = m.unlit() && isColored;
    ColorChannel color = isTinted ? timesVertexColor(color(input)) : color(input);
    return Optional.of(new Emission(radiance(seen(color, m)), m.doubleSided()));
  }

  private static Texture<Rgb> radiance(ColorChannel color) {
    return color instanceof ColorChannel.Textured textured && textured.uvSet() == 0
        ? textured.texture()
        : new Radiance(color);
  }

  /** A texture that depends on more than the first texture coordinates. */
  private record Radiance(ColorChannel color) implements Texture<Rgb> {
    @Override
    public Rgb at(double u, double v) {
      return at(new TexturePoint(u, v));
    }

    @Override
    public Rgb at(SurfacePoint point) {
      return color.at(point);
    }
  }

  /** Returns the part of a color that the opacity leaves. */
  private ColorChannel seen(ColorChannel color, ModelMaterial m) throws ModelFormatException {
    if (m.alphaMode() == ModelMaterial.AlphaMode.OPAQUE) {
      return color;
    }
    ScalarChannel opacity = opacity(m);
    boolean isMask = m.alphaMode() == ModelMaterial.AlphaMode.MASK;
    ScalarChannel used = isMask ? mask(opacity, m.alphaCutoff()) : opacity;
    return point -> color.at(point).times(used.at(point));
  }

  private ColorChannel color(MaterialInput input) throws ModelFormatException {
    Optional<ModelTexture> usable = usable(input.texture());
    if (usable.isEmpty()) {
      return ColorChannel.of(input.factor());
    }
    ModelTexture source = usable.get();
    Texture<Rgb> texture = texture(source, ImageTexture.Role.COLOR);
    Rgb factor = input.factor();
    return ColorChannel.of((u, v) -> texture.at(u, v).times(factor), source.uvSet());
  }

  private ScalarChannel scalar(MaterialInput input) throws ModelFormatException {
    Optional<ModelTexture> usable = usable(input.texture());
    if (usable.isEmpty()) {
      return ScalarChannel.of(input.number());
    }
    ModelTexture source = usable.get();
    SampledTexture texture = sampled(source, ImageTexture.Role.DATA);
    UvTransform map = source.uvTransform();
    double factor = input.number();
    int channel = input.channel();
    return ScalarChannel.of(
        (u, v) -> factor * texture.channel(map.u(u, v), map.v(u, v), channel), source.uvSet());
  }

  private Texture<Rgb> texture(ModelTexture source, ImageTexture.Role role)
      throws ModelFormatException {
    SampledTexture texture = sampled(source, role);
    UvTransform map = source.uvTransform();
    return map.isIdentity()
        ? texture
        : (u, v) -> texture.at(map.u(u, v), map.v(u, v));
  }

  /** Returns a texture, unless its picture cannot be decoded. */
  private Optional<ModelTexture> usable(Optional<ModelTexture> texture)
      throws ModelFormatException {
    return texture.isPresent() && pixels(texture.get().image()).isPresent()
        ? texture
        : Optional.empty();
  }

  private SampledTexture sampled(ModelTexture source, ImageTexture.Role role)
      throws ModelFormatException {
    return new SampledTexture(
        pixels(source.image()).orElseThrow(),
        role,
        source.nearest() ? ImageTexture.Filter.NEAREST : ImageTexture.Filter.BILINEAR,
        wrap(source.wrapU()),
        wrap(source.wrapV()));
  }

  private Optional<Pixels> pixels(ModelImage image) throws ModelFormatException {
    Optional<Pixels> known = pictures.get(image);
    if (known == null) {
      known = decoded(image);
      pictures.put(image, known);
    }
    return known;
  }

  private Optional<Pixels> decoded(ModelImage image) throws ModelFormatException {
    try {
      Pixels pixels = decoded.of(image.encoded(), limits.withTexels(limits.texels() - texels));
      texels += (long) pixels.width() * pixels.height();
      return Optional.of(pixels);
    } catch (ImageFormatException e) {
      if (e.kind() == ImageFormatException.Kind.TOO_LARGE) {
        throw ModelFormatException.Kind.TOO_LARGE.at(image.location(), e.getMessage());
      }
      warnings.add(
          "a picture is left out", image.location(), e.getMessage() + "; the picture is left out");
      return Optional.empty();
    }
  }

  private static SampledTexture.Wrap wrap(ModelTexture.Wrap wrap) {
    return SampledTexture.Wrap.valueOf(wrap.name());
  }
}
