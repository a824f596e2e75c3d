package io.github.lumbre.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

/** Tests the mapping of texture coordinates. */
class UvMappingTest {
  @Test
  void scaleComesBeforeOffset() {
    UvMapping mapping = new UvMapping(.25, .5, 2, -1);
    assertThat(mapping.apply(new TexturePoint(.5, .125))).isEqualTo(new TexturePoint(1.25, .375));
  }

  @Test
  void scaleMultipliesDistances() {
    for (double scale : new double[] {.25, -3, 8}) {
      UvMapping mapping = new UvMapping(.5, .75, scale, scale);
      TexturePoint from = mapping.apply(new TexturePoint(.125, .25));
      TexturePoint to = mapping.apply(new TexturePoint(.625, .75));
      assertThat(to.u() - from.u()).isEqualTo(.5 * scale);
      assertThat(to.v() - from.v()).isEqualTo(.5 * scale);
    }
  }

  @Test
  void aTextureIsReadAtTheMappedPoint() {
    Texture<TexturePoint> where = TexturePoint::new;
    UvMapping mapping = new UvMapping(1, 2, 3, 4);
    TexturePoint p = new TexturePoint(.5, .25);
    assertThat(mapping.over(where).at(p)).isEqualTo(mapping.apply(p));
  }

  @Test
  void theIdentityAddsNothing() {
    Texture<TexturePoint> where = TexturePoint::new;
    assertThat(new UvMapping(0, 0, 1, 1).over(where)).isSameAs(where);
  }

  @Test
  void numbersMustBeFinite() {
    assertThatThrownBy(() -> new UvMapping(0, 0, 1, Double.NaN))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("scaleY: expected a finite number, found NaN");
    assertThatThrownBy(() -> new UvMapping(0, 0, Double.POSITIVE_INFINITY, 1))
        .hasMessage("scaleX: expected a finite number, found Infinity");
    assertThatThrownBy(() -> new UvMapping(0, Double.NEGATIVE_INFINITY, 1, 1))
        .hasMessage("offsetY: expected a finite number, found -Infinity");
    assertThatThrownBy(() -> new UvMapping(Double.NaN, 0, 1, 1))
        .hasMessage("offsetX: expected a finite number, found NaN");
  }
}
