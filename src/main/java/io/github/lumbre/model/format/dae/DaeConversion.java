package io.github.lumbre.model.format.dae;

import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.OPACITY;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.format.PhongReflection;
import io.github.lumbre.model.format.dae.DaeEffect.Transparency;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.ModelImage;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.PlainModel;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Converts an effect to a metallic-roughness material, as materials of MTL are: {@code diffuse} is
 * Kd, {@code specular} Ks, {@code shininess} Ns and {@code emission} Ke. A picture replaces its
 * color. {@code constant} shows its emission alone. A picture that is missing is left out with a
 * warning, and a number out of its range is replaced with one.
 */
final class DaeConversion {
  private static final String BUMP = "bump";

  /** The parts that may have a picture. */
  private static final List<String> MAPPED =
      List.of("diffuse", "emission", "specular", "transparent");

  /** The largest difference from a range that is a rounding error. */
  private static final double ROUNDING = 1e-6;

  private final DaeEffect effect;
  private final DaeElement material;
  private final FormatFile file;
  private final Map<String, DaeTexture> textures = new LinkedHashMap<>();

  DaeConversion(DaeEffect effect, DaeElement material, FormatFile file) {
    this.effect = effect;
    this.material = material;
    this.file = file;
    for (String part : MAPPED) {
      effect.texture(part).ifPresent(texture -> textures.put(part, texture));
    }
    effect.bump().ifPresent(texture -> textures.put(BUMP, texture));
  }

  /** Returns the place of the material in the file. */
  String location() {
    return material.location();
  }

  /** Returns the names of the texture coordinates of all pictures. */
  List<String> semantics() {
    return textures.values().stream().map(DaeTexture::semantic).toList();
  }

  /** Returns whether the material is wholly transparent by its numbers. */
  boolean isInvisible() {
    return opacity() <= 0;
  }

  /**
   * Returns the material.
   *
   * @param slots for each of the {@link #semantics}, the number of its set at the surface: 0 or 1
   * @param isOpaque whether its transparency is left out
   * @param isOneSided whether the surface states that its back faces are invisible
   */
  ModelMaterial material(List<Integer> slots, boolean isOpaque, boolean isOneSided)
      throws ModelFormatException, IOException {
    Map<String, ModelTexture> read = read(slots);
    ModelMaterial.Builder out = PlainModel.matte(material.title(), material.location());
    out.doubleSided(!isOneSided && !effect.isOneSided());
    boolean isConstant = effect.is("constant") && !effect.has("diffuse");
    out.set(BASE_COLOR, color("diffuse", isConstant ? 0 : PlainModel.ALBEDO, 1, read));
    boolean glows = !effect.hasTexture("emission") || read.containsKey("emission");
    out.emission(
        glows ? color("emission", 0, Double.MAX_VALUE, read) : MaterialInput.of(Rgb.BLACK));
    MaterialInput specular = color("specular", 0, 1, read);
    if (!specular.factor().isBlack() && !effect.is("lambert") && !effect.is("constant")) {
      PhongReflection.set(out, specular, false, number("shininess", 0, Double.MAX_VALUE));
    }
    setNormalMap(out, read);
    if (!isOpaque) {
      setOpacity(out, read);
    }
    if (effect.hasReflection()) {
      file.warnings()
          .add(
              "reflections of colors",
              effect.location(),
              "left out <reflective>: surfaces reflect what is around them");
    }
    return out.build();
  }

  /** Returns the pictures that can be read, by their parts; warns of the others. */
  private Map<String, ModelTexture> read(List<Integer> slots)
      throws ModelFormatException, IOException {
    Map<String, ModelTexture> read = new LinkedHashMap<>();
    List<String> parts = new ArrayList<>(textures.keySet());
    for (int i = 0; i < parts.size(); i++) {
      DaeTexture texture = textures.get(parts.get(i));
      if (file.pictures().isReadable(texture.map(), file.warnings())) {
        ModelImage image = file.pictures().image(texture.map());
        read.put(
            parts.get(i),
            new ModelTexture(
                image,
                slots.get(i),
                texture.wrapU(),
                texture.wrapV(),
                texture.nearest(),
                texture.transform()));
      }
    }
    return read;
  }

  /** Returns the color of a part, or white with its picture. */
  private MaterialInput color(
      String part, double otherwise, double most, Map<String, ModelTexture> read) {
    if (read.containsKey(part)) {
      return new MaterialInput(Rgb.WHITE, Optional.of(read.get(part)), 0);
    }
    Optional<double[]> stated = effect.color(part);
    return MaterialInput.of(
        stated
            .map(
                c ->
                    new Rgb(
                        limited(part, c[0], most),
                        limited(part, c[1], most),
                        limited(part, c[2], most)))
            .orElse(Rgb.gray(otherwise)));
  }

  private double number(String part, double otherwise, double most) {
    return limited(part, effect.number(part).orElse(otherwise), most);
  }

  /** Returns a number of the material in a range; adds a warning if it is out of it. */
  private double limited(String part, double stated, double most) {
    double limited = Math.max(0, Math.min(stated, most));
    if (Math.abs(limited - stated) > ROUNDING) {
      file.warnings()
          .add(
              "a number of a material is out of range",
              effect.location(),
              "%s: expected %s, found %s; %s is used"
                  .formatted(
                      part,
                      most == Double.MAX_VALUE ? "at least 0" : "0 to 1",
                      PrintableText.number(stated),
                      PrintableText.number(limited)));
    }
    return limited;
  }

  private void setNormalMap(ModelMaterial.Builder out, Map<String, ModelTexture> read)
      throws ModelFormatException, IOException {
    if (!read.containsKey(BUMP)) {
      return;
    }
    if (file.pictures().isHeightMap(textures.get(BUMP).map())) {
      file.warnings()
          .add(effect.location(), "ignored a height map: only normal maps are supported");
      return;
    }
    out.normalMap(
        Optional.of(new MaterialInput(Rgb.WHITE, Optional.of(read.get(BUMP)), 0)));
  }

  /**
   * Returns the opacity by the numbers alone: of a color, or of a picture whose values are 1 where
   * it is opaque. A material with neither color nor number is opaque.
   */
  private double opacity() {
    if (!effect.has("transparent") && !effect.has("transparency")) {
      return 1;
    }
    double transparency = number("transparency", 1, 1);
    Transparency kind = effect.transparency();
    if (effect.hasTexture("transparent")) {
      boolean isOpacity = kind == Transparency.A_ONE || kind == Transparency.RGB_ONE;
      return isOpacity && transparency > 0 ? transparency : 1;
    }
    double[] color = effect.color("transparent").orElse(new double[] {1, 1, 1, 1});
    return Math.max(0, Math.min(kind.opacity(transparency, color), 1));
  }

  private void setOpacity(ModelMaterial.Builder out, Map<String, ModelTexture> read)
      throws ModelFormatException, IOException {
    double opacity = opacity();
    Optional<ModelTexture> texture = Optional.ofNullable(read.get("transparent"));
    if (opacity == 0) {
      file.warnings()
          .add(
              "invisible materials",
              material.location(),
              "the material is invisible: its opacity is 0");
    }
    Transparency kind = effect.transparency();
    if (texture.isPresent() && kind != Transparency.A_ONE) {
      double transparency = number("transparency", 1, 1);
      texture =
          OpacityPicture.of(texture.get(), kind, transparency > 0 ? transparency : 1, file);
      opacity = 1;
    }
    if (opacity < 1 || texture.isPresent()) {
      out.set(
          OPACITY,
          new MaterialInput(Rgb.gray(opacity), texture, kind == Transparency.A_ONE ? 3 : 0));
      out.alphaMode(AlphaMode.BLEND);
    }
  }
}
