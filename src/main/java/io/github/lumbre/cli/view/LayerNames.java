package io.github.lumbre.cli.view;

import io.github.lumbre.scene.Layer;
import java.util.Arrays;
import java.util.Optional;

/** The names of layers in pictures: a layer may be there in several parts. */
final class LayerNames {
  private LayerNames() {}

  /** Returns whether a picture's layer is a part of a layer of the film. */
  static boolean belongsTo(String name, Layer layer) {
    return switch (layer) {
      case LIGHTS -> name.startsWith("lights.");
      case OBJECT -> name.startsWith("CryptoObject");
      case MATERIAL -> name.startsWith("CryptoMaterial");
      default -> name.equals(layer.text());
    };
  }

  /** Returns the layer of the film that a picture's layer is a part of. */
  static Optional<Layer> layerOf(String name) {
    return Arrays.stream(Layer.values()).filter(layer -> belongsTo(name, layer)).findFirst();
  }
}
