package io.github.lumbre.scenefile.internal;

import java.util.List;

/**
 * The places of a scene's objects and assets in its file.
 *
 * @param primitives the object of each of the scene's primitives, in their order
 * @param materials the material asset of each primitive; {@link Origin#NONE} for those without
 * @param emitters the object of each of the scene's lights, in their order
 * @param textures uses of decoded images by materials
 * @param unused assets that the rendered scene does not use
 */
public record SceneOrigins(
    List<Origin> primitives,
    List<Origin> materials,
    List<Origin> emitters,
    List<TextureUse> textures,
    List<Unused> unused) {
  public SceneOrigins {
    primitives = List.copyOf(primitives);
    materials = List.copyOf(materials);
    emitters = List.copyOf(emitters);
    textures = List.copyOf(textures);
    unused = List.copyOf(unused);
  }

  /**
   * A decoded image as the texture of a material's channel.
   *
   * @param channel name of the channel, such as {@code color}
   * @param width width of the image in texels
   * @param height height of the image in texels
   * @param scaleX number of repetitions over the surface's u from 0 to 1
   * @param scaleY number of repetitions over the surface's v from 0 to 1
   */
  public record TextureUse(
      Origin material,
      String channel,
      Origin texture,
      int width,
      int height,
      double scaleX,
      double scaleY) {}

  /**
   * An asset that the rendered scene does not use.
   *
   * @param type {@code material}, {@code texture} or {@code mesh}
   */
  public record Unused(String type, Origin origin) {}
}
