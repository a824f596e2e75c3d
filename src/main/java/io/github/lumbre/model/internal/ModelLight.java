package io.github.lumbre.model.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Transform;
import java.util.Objects;

/**
 * A punctual light of a model. Directional and spot lights shine along their local -z
 * (KHR_lights_punctual).
 *
 * @param name empty if it has none
 * @param location in the file, such as {@code nodes[3].extensions.KHR_lights_punctual}
 * @param intensity color times intensity: cd for point and spot lights, lx for directional ones; a
 *     radiance of 1 is 1 cd/m²
 * @param range the distance beyond which the light has no effect; infinite if unlimited
 * @param innerCone half angle of the cone of full intensity, in radians; spot lights only
 * @param outerCone half angle of the whole cone, in radians; spot lights only
 * @param toWorld from the light's local space to the model's world space
 */
public record ModelLight(
    String name,
    String location,
    Kind kind,
    Rgb intensity,
    double range,
    double innerCone,
    double outerCone,
    Transform toWorld) {

  public enum Kind {
    DIRECTIONAL,
    POINT,
    SPOT
  }

  public ModelLight {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(location, "location");
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(intensity, "intensity");
    Objects.requireNonNull(toWorld, "toWorld");
  }
}
