package io.github.lumbre.parser;

import java.util.List;

/**
 * Where in its file everything of a scene stands.
 *
 * @param primitives the object of each of the scene's primitives, in their order
 * @param materials the material asset of each of them; {@link Origin#NONE} for those without
 * @param emitters the object of each of the scene's emitters, in their order
 * @param textures decoded pictures and what materials use them for
 * @param unused assets that nothing uses
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
   * A decoded picture in the role of a material's channel.
   *
   * @param channel as {@code color}
   * @param width of the picture in texels
   * @param height of the full frame, in pixels
   * @param scaleX how often it repeats over the surface's u
   * @param scaleY how often it repeats over the surface's v
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
   * An asset that nothing uses.
   *
   * @param type {@code material}, {@code texture} or {@code mesh}
   */
  public record Unused(String type, Origin origin) {}
}
