package io.github.lumbre.model.gltf;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLight;
import io.github.lumbre.text.PrintableText;
import java.util.List;
import java.util.Optional;

/** The lights of a glTF file (KHR_lights_punctual). */
final class GltfLights {
  private static final String LIGHTS = "KHR_lights_punctual";

  private final List<GltfJson> lights;

  GltfLights(GltfDocument document) throws ModelFormatException {
    Optional<GltfJson> extension = document.root().extension(LIGHTS);
    lights = extension.isPresent() ? extension.get().objects("lights") : List.of();
  }

  /** Returns the number of lights that nodes can place. */
  int size() {
    return lights.size();
  }

  ModelLight light(GltfNode node, Transform toWorld) throws ModelFormatException {
    GltfJson json = lights.get(node.light().getAsInt());
    double[] color = json.numbers("color", 1, 1, 1);
    double intensity = json.number("intensity", 1);
    for (double component : color) {
      requireAtLeastZero(json, "color", component);
    }
    requireAtLeastZero(json, "intensity", intensity);
    Optional<GltfJson> spot = json.object("spot");
    double outer =
        spot.isPresent() ? spot.get().number("outerConeAngle", Math.PI / 4) : Math.PI / 4;
    double inner = spot.isPresent() ? spot.get().number("innerConeAngle", 0) : 0;
    if (spot.isPresent() && !(inner >= 0 && inner < outer && outer <= Math.PI / 2)) {
      throw spot.get()
          .malformed(
              "outerConeAngle",
              "expected 0 <= innerConeAngle < outerConeAngle <= pi/2, found %s and %s"
                  .formatted(PrintableText.number(inner), PrintableText.number(outer)));
    }
    return new ModelLight(
        node.name().isEmpty() ? json.text("name", "") : node.name(),
        node.location() + ".extensions." + LIGHTS,
        kind(json),
        new Rgb(color[0], color[1], color[2]).times(intensity),
        json.has("range") ? json.requirePositive("range") : Double.POSITIVE_INFINITY,
        inner,
        outer,
        toWorld);
  }

  private static ModelLight.Kind kind(GltfJson json) throws ModelFormatException {
    return switch (json.choice("type", "", List.of("directional", "point", "spot"))) {
      case "directional" -> ModelLight.Kind.DIRECTIONAL;
      case "point" -> ModelLight.Kind.POINT;
      default -> ModelLight.Kind.SPOT;
    };
  }

  private static void requireAtLeastZero(GltfJson json, String member, double value)
      throws ModelFormatException {
    if (!(value >= 0)) {
      throw json.malformed(member, "expected at least 0, found " + PrintableText.number(value));
    }
  }
}
