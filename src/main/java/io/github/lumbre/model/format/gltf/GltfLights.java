package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.json.JsonValue;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLight;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The lights of a glTF file (KHR_lights_punctual). */
final class GltfLights {
  private static final String LIGHTS = "KHR_lights_punctual";

  private static final double RIGHT_ANGLE = Math.PI / 2;

  private static final Map<String, ModelLight.Kind> KINDS =
      Map.of(
          "directional", ModelLight.Kind.DIRECTIONAL,
          "point", ModelLight.Kind.POINT,
          "spot", ModelLight.Kind.SPOT);

  private final List<GltfJson> lights;
  private final GltfValues values;

  /** The half angles of a spot light's cones, in radians. */
  private record Cone(double inner, double outer) {
    static final Cone DEFAULT = new Cone(0, Math.PI / 4);
  }

  GltfLights(GltfDocument document) throws ModelFormatException {
    Optional<GltfJson> extension = document.root().extension(LIGHTS);
    values = new GltfValues(document.warnings(), "light");
    lights = extension.isPresent() ? extension.get().objects("lights") : List.of();
  }

  /** Returns the number of lights that nodes can place. */
  int size() {
    return lights.size();
  }

  /** Returns the light of a node; empty, with a warning, if its type is not known. */
  Optional<ModelLight> light(GltfNode node, Transform toWorld) {
    GltfJson json = lights.get(node.light().getAsInt());
    Optional<ModelLight.Kind> kind = kind(json);
    if (kind.isEmpty()) {
      return Optional.empty();
    }
    Cone cone = kind.get() == ModelLight.Kind.SPOT ? cone(json) : Cone.DEFAULT;
    return Optional.of(
        new ModelLight(
            node.name().isEmpty() ? values.name(json) : node.name(),
            node.location() + ".extensions." + LIGHTS,
            kind.get(),
            intensity(json),
            values.positive(json, "range", "infinity").orElse(Double.POSITIVE_INFINITY),
            cone.inner,
            cone.outer,
            toWorld));
  }

  private Optional<ModelLight.Kind> kind(GltfJson json) {
    String type = json.find("type").filter(JsonValue::isString).map(JsonValue::text).orElse("");
    if (!KINDS.containsKey(type)) {
      values.leftOut(json, "type", "\"directional\", \"point\" or \"spot\"");
    }
    return Optional.ofNullable(KINDS.get(type));
  }

  private Rgb intensity(GltfJson json) {
    double[] c = values.color(Double.MAX_VALUE, json, "color", 1, 1, 1);
    Rgb color = new Rgb(c[0], c[1], c[2]);
    double intensity = values.upTo(Double.MAX_VALUE, json, "intensity", 1);
    if (color.times(intensity).isFinite()) {
      return color.times(intensity);
    }
    values.replaced(
        json.location("color"), "a finite light", color + " times " + intensity, "white");
    return Rgb.gray(intensity);
  }

  /** Returns the cone of a spot light; its edge is hard if both angles are the same. */
  private Cone cone(GltfJson json) {
    Optional<GltfJson> spot = values.object(json, "spot");
    if (spot.isEmpty()) {
      return Cone.DEFAULT;
    }
    double angle =
        values.positive(spot.get(), "outerConeAngle", "pi/4").orElse(Cone.DEFAULT.outer);
    // Exporters write pi/2 as the nearest 32-bit float, which is a little larger.
    double outer =
        (float) angle == (float) RIGHT_ANGLE
            ? Math.min(angle, RIGHT_ANGLE)
            : values.clamped(
                spot.get().location("outerConeAngle"), angle, 0, RIGHT_ANGLE, "at most pi/2");
    double inner =
        values.clamped(
            spot.get().location("innerConeAngle"),
            values.number(spot.get(), "innerConeAngle", 0),
            0,
            outer,
            "0 to outerConeAngle");
    return new Cone(inner, outer);
  }
}
