package io.github.lumbre.scenefile.audit;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.Phong;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/** Reports reflectances above 1, and the energy lost when they are limited to 1. */
final class ReflectanceCheck implements Check {
  private static final String LAW = "reflectance";

  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    List<Finding> findings = new ArrayList<>();
    for (Surfaces.Used used : Surfaces.materials(file)) {
      Material material = Surfaces.flat(used.material());
      if (material instanceof Matte matte) {
        look(used, matte.albedo()::at, false, findings);
      } else if (material instanceof Mirror mirror) {
        look(used, mirror.reflectance()::at, false, findings);
      } else if (material instanceof Glass glass) {
        look(used, glass.reflectance()::at, false, findings);
        look(used, glass.transmittance()::at, false, findings);
      } else if (material instanceof Phong phong) {
        look(used, sum(phong.diffuse(), phong.specular()), true, findings);
      } else if (material instanceof CookTorrance torrance) {
        look(used, sum(torrance.diffuse(), torrance.specular()), true, findings);
      }
    }
    return findings;
  }

  private static Function<TexturePoint, Rgb> sum(Texture<Rgb> one, Texture<Rgb> other) {
    return point -> one.at(point).plus(other.at(point));
  }

  /**
   * Adds a finding if the reflectance exceeds 1 anywhere.
   *
   * @param keepsHue whether all components are divided by the largest, instead of clamping each
   */
  private static void look(
      Surfaces.Used used,
      Function<TexturePoint, Rgb> reflected,
      boolean keepsHue,
      List<Finding> findings) {
    int[] above = new int[1];
    double[] sums = new double[2];
    double[] most = new double[1];
    Surfaces.forTexturePoints(
        point -> {
          Rgb written = reflected.apply(point);
          Rgb taken =
              keepsHue ? written.times(1 / Math.max(1, written.max())) : written.clampedToOne();
          above[0] += written.max() > 1 ? 1 : 0;
          most[0] = Math.max(most[0], written.max());
          sums[0] += written.luminance();
          sums[1] += taken.luminance();
        });
    if (above[0] > 0) {
      findings.add(
          Finding.warning(
              LAW,
              used.origin(),
              String.format(
                  Locale.ROOT,
                  "the reflectance exceeds 1 on %.0f %% of the surface; its maximum is %.3g",
                  100.0 * above[0] / Surfaces.texturePoints(),
                  most[0]),
              String.format(
                  Locale.ROOT,
                  "it is limited to 1, which removes %.1f %% of the stated reflectance",
                  100 * (1 - sums[1] / sums[0])),
              "lower the colors, so that their sum, with textures, is at most 1"));
    }
  }
}
