package io.github.lumbre.texture.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;
import java.util.Objects;

/** The product of a constant and a texture, per component. */
public record TintedTexture(Rgb tint, Texture<Rgb> texture) implements Texture<Rgb> {
  public TintedTexture {
    Objects.requireNonNull(tint, "tint");
    Objects.requireNonNull(texture, "texture");
  }

  /**
   * Returns the product in its fastest form: a white tint returns the texture itself, and an {@link
   * ImageTexture} applies the tint internally. Apply a mapping after the tint: {@code
   * mapping.over(TintedTexture.of(tint, image))}.
   */
  public static Texture<Rgb> of(Rgb tint, Texture<Rgb> texture) {
    if (tint.equals(Rgb.WHITE)) {
      return Objects.requireNonNull(texture, "texture");
    }
    return texture instanceof ImageTexture image
        ? image.tinted(tint)
        : new TintedTexture(tint, texture);
  }

  @Override
  public Rgb at(double u, double v) {
    return texture.at(u, v).times(tint);
  }
}
