package io.github.lumbre.light.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightBounds;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import java.util.Optional;

/**
 * A point light whose intensity depends on the direction, as a lamp's profile states it.
 *
 * @param source the point light that is multiplied by the candelas of the profile
 * @param axes the lamp's axes in world space
 */
public record ProfileLight(PointLight source, Frame axes, LightProfile profile) implements Light {
  @Override
  public void sample(double x, double y, double z, double u, double v, LightSample result) {
    source.sample(x, y, z, u, v, result);
    double intensity = profile.intensity(axes.toLocal(result.wi().negated()));
    result.dim(Rgb.gray(intensity));
    if (intensity == 0) {
      result.clear();
    }
  }

  @Override
  public Light transformed(Transform outer) {
    return profile.light(
        source.transformed(outer), outer.times(Transform.ofFrame(axes, source.position())));
  }

  @Override
  public double power(double sceneRadius) {
    return source.intensity().max() * profile.flux();
  }

  @Override
  public Optional<LightBounds> bounds() {
    double reach = Math.toRadians(profile.reach());
    return source
        .bounds()
        .map(
            all ->
                LightBounds.towards(
                    all.box(), axes.normal(), reach, 0, all.intensity() * profile.largest()));
  }

  @Override
  public boolean isBlack() {
    return source.isBlack() || profile.flux() == 0;
  }
}
