package io.github.lumbre.parser;

import com.google.gson.JsonObject;
import io.github.lumbre.camera.internal.BokehCache;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;
import io.github.lumbre.texture.internal.BilinearTexture;
import io.github.lumbre.texture.internal.CloudTexture;
import io.github.lumbre.texture.internal.Constant;
import io.github.lumbre.texture.internal.ConstantScalar;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import io.github.lumbre.texture.internal.LinearTexture;
import io.github.lumbre.texture.internal.MappedTexture;
import io.github.lumbre.texture.internal.MarbleTexture;
import io.github.lumbre.texture.internal.RedChannel;
import io.github.lumbre.texture.internal.StudioSky;
import io.github.lumbre.texture.internal.TexelTexture;
import io.github.lumbre.texture.internal.TintedTexture;
import io.github.lumbre.texture.internal.VoronoiTexture;
import io.github.lumbre.texture.internal.WoodTexture;

/** Writes textures, and the channels of materials that use them. */
record WrittenTextures(WrittenAssets assets) {
  /**
   * A texture as the format has it: a constant times a picture, read at mapped coordinates.
   *
   * @param picture without tint and mapping; a {@link Constant} if there is no picture
   */
  private record Parts(Rgb tint, UvMapping mapping, Texture<Rgb> picture) {
    private Parts mapped(UvMapping outer) {
      if (!mapping.equals(UvMapping.IDENTITY)) {
        throw new Unwritable("a texture with one mapping", "a mapping of a mapping");
      }
      return new Parts(tint, outer, picture);
    }
  }

  private static Parts parts(Texture<Rgb> texture) {
    if (texture instanceof Constant<Rgb> constant) {
      return new Parts(constant.value(), UvMapping.IDENTITY, texture);
    }
    if (texture instanceof MappedTexture<Rgb> mapped) {
      return parts(mapped.texture()).mapped(mapped.mapping());
    }
    if (texture instanceof TintedTexture tinted) {
      Parts inner = parts(tinted.texture());
      if (!inner.tint().equals(Rgb.WHITE)) {
        throw new Unwritable("a texture with one tint", "a tint of a tint");
      }
      return new Parts(tinted.tint(), inner.mapping(), inner.picture());
    }
    Rgb tint = texture instanceof ImageTexture image ? image.tint() : Rgb.WHITE;
    return new Parts(tint, UvMapping.IDENTITY, texture);
  }

  void color(JsonObject to, String channel, Texture<Rgb> texture) {
    Parts parts = parts(texture);
    to.add(channel, Written.color(parts.tint()));
    picture(to, channel, parts, Role.COLOR);
  }

  /**
   * Writes a scalar channel.
   *
   * @param range of constants
   * @param low the lower limit that readers give to a product with a texture
   * @param high the upper limit
   */
  void scalar(
      JsonObject to, String channel, ScalarTexture texture, Range range, double low, double high) {
    if (texture instanceof ConstantScalar constant) {
      if (!range.contains(constant.value())) {
        throw new Unwritable(channel + ": a number that scenes may state", "" + constant.value());
      }
      to.addProperty(channel, constant.value());
      return;
    }
    if (!(texture instanceof RedChannel red) || red.min() != low || red.max() != high) {
      throw new Unwritable(
          channel + ": a constant, or a RedChannel from " + low + " to " + high,
          Written.name(texture));
    }
    Parts parts = parts(red.texture());
    if (!parts.tint().equals(Rgb.WHITE) || parts.picture() instanceof Constant) {
      throw new Unwritable(channel + ": the red of a picture without tint", "another texture");
    }
    to.addProperty(channel, red.factor());
    picture(to, channel, parts, Role.DATA);
  }

  void normalMap(JsonObject to, String channel, NormalMap map) {
    Parts parts = parts(map.normals());
    to.addProperty(channel + "Strength", map.strength());
    picture(to, channel, new Parts(Rgb.WHITE, map.mapping(), parts.picture()), Role.NORMAL);
  }

  private void picture(JsonObject to, String channel, Parts parts, Role role) {
    if (parts.picture() instanceof Constant) {
      return;
    }
    to.addProperty(channel + "TextureId", id(parts.picture(), role));
    UvMapping mapping = parts.mapping();
    if (!mapping.equals(UvMapping.IDENTITY)) {
      to.add(channel + "Offset", Written.point(mapping.offsetX(), mapping.offsetY()));
      to.add(channel + "Scale", Written.point(mapping.scaleX(), mapping.scaleY()));
    }
  }

  /** Writes the texture of an environment light, and returns its tint. */
  Rgb sky(JsonObject to, Texture<Rgb> texture) {
    Parts parts = parts(texture);
    if (!parts.mapping().equals(UvMapping.IDENTITY)) {
      throw new Unwritable("an environment without a mapping", "one with a mapping");
    }
    if (parts.picture() == StudioSky.INSTANCE) {
      to.addProperty("sky", "studio");
    } else if (!(parts.picture() instanceof Constant)) {
      to.addProperty("textureId", id(parts.picture(), Role.COLOR));
    }
    return parts.tint();
  }

  /** Writes the mask of a lens and returns its id. */
  int mask(BokehCache mask) {
    boolean[][] white = mask.toMask();
    byte[] gray = new byte[white.length * white[0].length];
    for (int i = 0; i < gray.length; i++) {
      // Pictures have the top row first, masks the bottom row.
      int row = white.length - 1 - i / white[0].length;
      gray[i] = (byte) (white[row][i % white[0].length] ? 255 : 0);
    }
    Pixels pixels = Pixels.of(white[0].length, white.length, 1, gray);
    return assets.id(mask, "", "Texture", to -> image(to, pixels, Filter.NEAREST));
  }

  private int id(Texture<Rgb> picture, Role role) {
    if (picture instanceof ImageTexture image) {
      if (image.role() != role) {
        throw new Unwritable(
            "a picture of role " + role + " in this channel", "one of role " + image.role());
      }
      Filter filter = image.filter();
      return assets.id(
          image.pixels(), filter.name(), "Texture", to -> image(to, image.pixels(), filter));
    }
    if (picture instanceof LinearTexture linear) {
      return assets.id(linear.image(), "", "Texture", to -> linear(to, linear.image()));
    }
    if (role == Role.NORMAL) {
      throw new Unwritable("a normal map that is a picture", Written.name(picture));
    }
    if (picture instanceof BilinearTexture smooth) {
      return assets.id(
          smooth.texels(), "smooth", "Texture", to -> texels(to, smooth.texels(), Filter.BILINEAR));
    }
    if (picture instanceof TexelTexture texels) {
      return assets.id(texels, "", "Texture", to -> texels(to, texels, Filter.NEAREST));
    }
    throw new Unwritable("a constant, a picture or a texture of the format", Written.name(picture));
  }

  private void image(JsonObject to, Pixels pixels, Filter filter) {
    to.addProperty("file", assets.file("texture", pixels.toPng(), "png"));
    filter(to, filter);
  }

  private static void filter(JsonObject to, Filter filter) {
    to.addProperty("filter", filter == Filter.NEAREST ? "nearest" : "bilinear");
  }

  private void linear(JsonObject to, Image image) {
    for (float value : image.rgb()) {
      if (!(value >= 0 && value < Float.POSITIVE_INFINITY)) {
        throw new Unwritable("finite colors >= 0 in a picture of linear light", "" + value);
      }
    }
    to.addProperty("file", assets.file("texture", image.toPfm(), "pfm"));
  }

  private static void texels(JsonObject to, TexelTexture texels, Filter filter) {
    if (texels instanceof WoodTexture wood) {
      to.addProperty("textureType", "Wood");
      to.addProperty("rings", wood.rings());
      to.addProperty("seed", wood.seed());
    } else if (texels instanceof MarbleTexture marble) {
      to.addProperty("textureType", "Marble");
      to.addProperty("seed", marble.seed());
    } else if (texels instanceof CloudTexture cloud) {
      to.addProperty("textureType", "Cloud");
      to.addProperty("density", cloud.density());
      to.addProperty("seed", cloud.seed());
    } else if (texels instanceof VoronoiTexture voronoi) {
      to.addProperty("textureType", "Voronoi");
      to.addProperty("samples", voronoi.samples());
      to.addProperty("blackAndWhite", voronoi.isBlackAndWhite());
      to.addProperty("seed", voronoi.seed());
    } else {
      throw new Unwritable("Wood, Marble, Cloud or Voronoi", Written.name(texels));
    }
    to.addProperty("width", texels.width());
    to.addProperty("height", texels.height());
    filter(to, filter);
  }
}
