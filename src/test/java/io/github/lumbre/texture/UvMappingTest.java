package io.github.lumbre.texture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class UvMappingTest {
  @Test
  void scaleComesBeforeOffset() {
    UvMapping mapping = new UvMapping(.25, .5, 2, -1);
    assertThat(mapping.apply(new TexturePoint(.5, .125))).isEqualTo(new TexturePoint(1.25, .375));
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
  }
}
