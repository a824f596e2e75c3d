package io.github.lumbre.cli.view;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.internal.Cryptomatte;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.checkpoint.internal.FilmPicture;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scenefile.SceneFile;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.stream.Stream;

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

  /** Returns the layers that a render records. */
  static Set<Layer> kinds(SceneFile file) {
    return FilmLayers.of(file.settings(), file.scene()).kinds();
  }

  /** Returns the names of the layers that a render records, with one for each light group. */
  static List<String> recorded(SceneFile file) {
    return kinds(file).stream()
        .flatMap(
            layer ->
                layer == Layer.LIGHTS
                    ? FilmPicture.lightNames(SceneInside.of(file.scene()).lightGroups().names())
                        .stream()
                    : Stream.of(layer.text()))
        .toList();
  }

  /** Returns whether a picture's layer holds ids of objects or materials. */
  static boolean isMatte(String name) {
    return belongsTo(name, Layer.OBJECT) || belongsTo(name, Layer.MATERIAL);
  }

  /**
   * Passes the items of a matte to a visitor: the id in hexadecimal, and the name.
   *
   * @param layer the name of a layer of the frame, or of the film
   */
  static void items(Frame frame, String layer, BiConsumer<String, String> visitor) {
    Optional<Layer> wanted = layerOf(layer);
    LayeredImage file =
        new LayeredImage(
            frame.image().width(), frame.image().height(), frame.layers(), frame.metadata());
    try {
      for (Cryptomatte matte : Cryptomatte.in(file)) {
        if (layerOf(matte.type()).equals(wanted)) {
          matte.ids().forEach((name, id) -> visitor.accept("%08x".formatted(id), name));
        }
      }
    } catch (ImageFormatException e) {
      throw new IllegalArgumentException("the picture's list of names is damaged", e);
    }
  }

  /** Returns the layer of the film that a picture's layer is a part of. */
  static Optional<Layer> layerOf(String name) {
    return Arrays.stream(Layer.values())
        .filter(layer -> belongsTo(name, layer))
        .findFirst()
        .or(() -> Layer.named(name));
  }
}
