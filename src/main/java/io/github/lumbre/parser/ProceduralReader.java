package io.github.lumbre.parser;

import io.github.lumbre.math.internal.Range;
import io.github.lumbre.sampling.internal.Hash;
import io.github.lumbre.texture.internal.CloudTexture;
import io.github.lumbre.texture.internal.MarbleTexture;
import io.github.lumbre.texture.internal.TexelTexture;
import io.github.lumbre.texture.internal.VoronoiTexture;
import io.github.lumbre.texture.internal.WoodTexture;

/**
 * Reads procedural textures.
 *
 * @param seed of the scene; with the textures' ids, it determines their random numbers
 */
record ProceduralReader(long seed) {
  private static final int DEFAULT_SIDE = 1000;

  TexelTexture wood(JsonNode texture) {
    double rings = texture.number("rings", 10, WoodTexture.RINGS);
    return new WoodTexture(seedOf(texture), width(texture), height(texture), rings);
  }

  TexelTexture marble(JsonNode texture) {
    return new MarbleTexture(seedOf(texture), width(texture), height(texture));
  }

  TexelTexture cloud(JsonNode texture) {
    double density = texture.number("density", 128, Range.FROM_ONE);
    return new CloudTexture(seedOf(texture), width(texture), height(texture), density);
  }

  TexelTexture voronoi(JsonNode texture) {
    return new VoronoiTexture(
        seedOf(texture),
        width(texture),
        height(texture),
        texture.integer("samples", 10, 1, VoronoiTexture.MAX_SAMPLES),
        texture.flag("blackAndWhite", false));
  }

  private static int width(JsonNode texture) {
    return texture.integer("width", DEFAULT_SIDE, 1, TexelTexture.MAX_SIDE);
  }

  private static int height(JsonNode texture) {
    return texture.integer("height", DEFAULT_SIDE, 1, TexelTexture.MAX_SIDE);
  }

  /** Returns the texture's own seed; without one, it depends on the scene's and on the id. */
  private long seedOf(JsonNode texture) {
    long derived = Hash.of(Hash.mix(seed), texture.id("id").orElseThrow());
    return texture.integer("seed", derived, Long.MIN_VALUE, Long.MAX_VALUE);
  }
}
