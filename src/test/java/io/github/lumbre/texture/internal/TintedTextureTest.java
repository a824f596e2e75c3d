package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests tinted textures. */
class TintedTextureTest {
  private static final Rgb TINT = new Rgb(.5, .25, 2);
  private static final TexturePoint ANYWHERE = new TexturePoint(.3, .8);

  @Test
  void theConstantMultipliesEachComponent() {
    Texture<Rgb> texture = (u, v) -> new Rgb(u, v, 1);
    assertThat(TintedTexture.of(TINT, texture).at(ANYWHERE))
        .isEqualTo(new Rgb(.5 * .3, .25 * .8, 2));
  }

  @ParameterizedTest
  @EnumSource
  void imagesAreTintedAlike(ImageTexture.Filter filter) {
    Pixels pixels = Pixels.of(2, 1, 3, new byte[] {10, 20, 30, 40, 50, 60});
    ImageTexture image = new ImageTexture(pixels, ImageTexture.Role.COLOR, filter);
    Texture<Rgb> once = TintedTexture.of(TINT, image);
    assertThat(once.at(ANYWHERE)).isEqualTo(new TintedTexture(TINT, image).at(ANYWHERE));
    assertThat(TintedTexture.of(TINT, once).at(ANYWHERE))
        .isEqualTo(image.at(ANYWHERE).times(new Rgb(.25, .0625, 4)));
  }

  @Test
  void whiteAddsNothing() {
    Texture<Rgb> texture = (u, v) -> Rgb.BLACK;
    assertThat(TintedTexture.of(new Rgb(1, 1, 1), texture)).isSameAs(texture);
  }
}
