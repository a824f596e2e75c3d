package io.github.lumbre.scenefile;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.math.Frame;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.internal.ClearSky;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.StudioSky;
import io.github.lumbre.texture.internal.SunDisk;
import io.github.lumbre.texture.internal.TintedTexture;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;

/**
 * Overrides for all textures of a scene.
 *
 * @param forced filter that replaces each texture's own; empty to keep them
 * @param lookUps counter of texture lookups; empty to count none
 */
record TextureChange(Optional<Filter> forced, Optional<LongAdder> lookUps) {
  /** Leaves textures unchanged. */
  static final TextureChange NONE = new TextureChange(Optional.empty(), Optional.empty());

  TextureChange filtering(Filter filter) {
    return new TextureChange(Optional.of(filter), lookUps);
  }

  TextureChange counting(LongAdder adder) {
    return new TextureChange(forced, Optional.of(adder));
  }

  /** Returns the filter to use for a texture with the given filter in the file. */
  Filter filter(Filter own) {
    return forced.orElse(own);
  }

  /** Returns the light of a studio, multiplied by a color. */
  EnvironmentLight studio(Frame axes, Rgb radiance, StudioSky studio) {
    return EnvironmentLight.image(
        axes,
        TintedTexture.of(radiance, watched(studio)),
        studio.columns(),
        studio.columns() / 2);
  }

  /** Returns the light of a clear sky without the sun, multiplied by a color. */
  EnvironmentLight clear(Frame axes, Rgb radiance, ClearSky sky) {
    double sun = sky.sun().times(radiance).max() / (4 * Math.PI);
    return EnvironmentLight.image(
            axes, TintedTexture.of(radiance, watched(sky)), ClearSky.COLUMNS, ClearSky.ROWS)
        .besideSun(sun);
  }

  /** Returns the light of the sun in a clear sky, multiplied by a color. */
  EnvironmentLight sun(Frame axes, Rgb radiance, ClearSky sky) {
    Frame around = Frame.around(sky.toSun(axes));
    // The image has the sun at its top.
    Frame below = new Frame(around.tangent(), around.normal(), around.bitangent());
    Texture<Rgb> disk = watched(SunDisk.of(sky.sun()));
    return EnvironmentLight.image(below, TintedTexture.of(radiance, disk), 1, SunDisk.ROWS);
  }

  /** Returns the light of a latitude-longitude picture, multiplied by a color. */
  EnvironmentLight dome(Frame axes, Rgb radiance, Picture picture) {
    return EnvironmentLight.image(
        axes,
        TintedTexture.of(radiance, watched(picture.asLight())),
        picture.domeColumns(),
        picture.domeRows());
  }

  /** Returns the same texture, with lookups counted if there is a counter. */
  <T> Texture<T> watched(Texture<T> texture) {
    if (lookUps.isEmpty()) {
      return texture;
    }
    LongAdder adder = lookUps.get();
    return (u, v) -> {
      adder.increment();
      return texture.at(u, v);
    };
  }
}
