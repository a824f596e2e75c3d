package io.github.lumbre.audit;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.Phong;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/** Surfaces that were to reflect more light than they get: by how much they are held back. */
final class ReflectanceCheck implements Check {
  private static final String LAW = "reflectance";

  @Override
  public List<Finding> of(SceneFile file, Pilot pilot) {
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
   * @param keepsHue whether all components are divided by the largest, instead of each cut to 1
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
                  "%.0f %% of the surface would reflect more than it gets, up to %.3g times",
                  100.0 * above[0] / Surfaces.texturePoints(),
                  most[0]),
              String.format(
                  Locale.ROOT,
                  "no surface does: the part above 1 is cut off, %.1f %% of what is written",
                  100 * (1 - sums[1] / sums[0])),
              "lower the colours, so that they and their textures stay at most 1 together"));
    }
  }
}
