package io.github.lumbre.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Transform;
import io.github.lumbre.texture.Texture;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class PrimitiveTest {
  private static final Shape SHAPE = new Sphere(Transform.IDENTITY, 1);
  private static final Emission EMISSION = new Emission(Texture.constant(Rgb.WHITE), false);

  @Test
  void everyPartIsNamedIfItIsMissing() {
    assertThatNullPointerException()
        .isThrownBy(() -> new Primitive(null, Matte.GRAY, Optional.empty()))
        .withMessage("shape");
    assertThatNullPointerException()
        .isThrownBy(() -> new Primitive(SHAPE, null, Optional.empty()))
        .withMessage("material");
    assertThatNullPointerException()
        .isThrownBy(() -> new Primitive(SHAPE, Matte.GRAY, null))
        .withMessage("emission");
  }

  @Test
  void simplifiedOnesScatterAndShineAlike() {
    Primitive primitive = new Primitive(SHAPE, Matte.GRAY, Optional.of(EMISSION));
    Primitive simplified = primitive.simplified();
    assertThat(simplified.shape()).isSameAs(SHAPE);
    assertThat(simplified.emission()).contains(EMISSION);
    assertThat(simplified.material().at(.2, .3)).isEqualTo(Matte.GRAY.at(.2, .3));
    assertThat(simplified.material().at(0, 0)).isSameAs(simplified.material().at(.2, .3));
  }
}
