package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import org.junit.jupiter.api.Test;

/** Tests constant textures. */
class ConstantTest {
  private static final Rgb COLOR = new Rgb(.1, .2, .3);

  @Test
  void constantsHaveOneValueEverywhere() {
    for (double place : new double[] {0, .5, -1e300, 1e300}) {
      assertThat(Texture.constant(COLOR).at(place, -place)).isEqualTo(COLOR);
      assertThat(ScalarTexture.constant(.7).at(place, -place)).isEqualTo(.7);
    }
  }

  @Test
  void constantsAreKnownToBeConstant() {
    assertThat(Texture.constant(COLOR).isConstant()).isTrue();
    assertThat(ScalarTexture.constant(.7).isConstant()).isTrue();
  }

  @Test
  void texturesThatVaryAreNotTakenForConstants() {
    Texture<Rgb> coordinates = (u, v) -> new Rgb(u, v, 0);
    assertThat(coordinates.isConstant()).isFalse();
    assertThat(new RedChannel(coordinates, 1, 0, 1).isConstant()).isFalse();
  }
}
