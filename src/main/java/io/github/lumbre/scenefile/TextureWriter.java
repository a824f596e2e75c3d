package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.camera.internal.BokehCache;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;
import io.github.lumbre.texture.internal.BilinearTexture;
import io.github.lumbre.texture.internal.Constant;
import io.github.lumbre.texture.internal.ConstantScalar;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import io.github.lumbre.texture.internal.LinearTexture;
import io.github.lumbre.texture.internal.MappedTexture;
import io.github.lumbre.texture.internal.RedChannel;
import io.github.lumbre.texture.internal.StudioSky;
import io.github.lumbre.texture.internal.TexelTexture;
import io.github.lumbre.texture.internal.TintedTexture;
import java.util.function.Consumer;

/** Writes textures, and the channels of materials that use them. */
record TextureWriter(AssetWriter assets) {
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

  void color(JsonObject to, Key<Rgb> key, Texture<Rgb> texture) {
    Parts parts = parts(texture);
    key.put(to, parts.tint());
    picture(to, key, parts, Role.COLOR);
  }

  void number(JsonObject to, Key<Double> key, ScalarTexture texture) {
    if (texture instanceof ConstantScalar constant) {
      key.put(to, constant.value());
      return;
    }
    double low = key.variation().orElseThrow().low();
    double high = key.variation().orElseThrow().high();
    if (!(texture instanceof RedChannel red) || red.min() != low || red.max() != high) {
      throw new Unwritable(
          key.stem() + ": a constant, or a RedChannel from " + low + " to " + high,
          Unwritable.name(texture));
    }
    Parts parts = parts(red.texture());
    if (!parts.tint().equals(Rgb.WHITE) || parts.picture() instanceof Constant) {
      throw new Unwritable(
          key.stem() + ": the red of a picture without tint", "another texture");
    }
    key.put(to, red.factor());
    picture(to, key, parts, Role.DATA);
  }

  void normalMap(JsonObject to, Key<Double> key, NormalMap map) {
    Parts parts = parts(map.normals());
    key.put(to, map.strength());
    picture(to, key, new Parts(Rgb.WHITE, map.mapping(), parts.picture()), Role.NORMAL);
  }

  private void picture(JsonObject to, Key<?> key, Parts parts, Role role) {
    if (parts.picture() instanceof Constant) {
      return;
    }
    key.texture().put(to, id(parts.picture(), role));
    UvMapping mapping = parts.mapping();
    if (!mapping.equals(UvMapping.IDENTITY)) {
      key.offset().put(to, new Point2(mapping.offsetX(), mapping.offsetY()));
      key.scale().put(to, new Point2(mapping.scaleX(), mapping.scaleY()));
    }
  }

  /** Writes the texture of an environment light, and returns its tint. */
  Rgb sky(JsonObject to, Texture<Rgb> texture) {
    Parts parts = parts(texture);
    if (!parts.mapping().equals(UvMapping.IDENTITY)) {
      throw new Unwritable("an environment without a mapping", "one with a mapping");
    }
    if (parts.picture() instanceof StudioSky studio) {
      boolean isSoft = studio == StudioSky.SOFT;
      LightKinds.SKY.put(to, isSoft ? LightKinds.Sky.STUDIO : LightKinds.Sky.RELIEF);
    } else if (!(parts.picture() instanceof Constant)) {
      LightKinds.TEXTURE.put(to, id(parts.picture(), Role.COLOR));
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
    return asset(mask, "", to -> image(to, pixels, Filter.NEAREST));
  }

  private int asset(Object source, String variant, Consumer<JsonObject> keys) {
    return assets.id(source, variant, AssetTable.Type.TEXTURE, keys);
  }

  private int id(Texture<Rgb> picture, Role role) {
    if (picture instanceof ImageTexture image) {
      if (image.role() != role) {
        throw new Unwritable(
            "a picture of role " + role + " in this channel", "one of role " + image.role());
      }
      Filter filter = image.filter();
      return asset(image.pixels(), filter.name(), to -> image(to, image.pixels(), filter));
    }
    if (picture instanceof LinearTexture linear) {
      return asset(linear.image(), "", to -> linear(to, linear.image()));
    }
    if (role == Role.NORMAL) {
      throw new Unwritable("a normal map that is a picture", Unwritable.name(picture));
    }
    if (picture instanceof BilinearTexture smooth) {
      return asset(
          smooth.texels(), "smooth", to -> texels(to, smooth.texels(), Filter.BILINEAR));
    }
    if (picture instanceof TexelTexture texels) {
      return asset(texels, "", to -> texels(to, texels, Filter.NEAREST));
    }
    throw new Unwritable(
        "a constant, a picture or a texture of the format", Unwritable.name(picture));
  }

  private void image(JsonObject to, Pixels pixels, Filter filter) {
    ObjectKeys.FILE.put(to, assets.file("texture", pixels.toPng(), "png"));
    TextureKinds.FILTER.put(to, filter);
  }

  private void linear(JsonObject to, Image image) {
    for (float value : image.rgb()) {
      if (!(value >= 0 && value < Float.POSITIVE_INFINITY)) {
        throw new Unwritable("finite colors >= 0 in a picture of linear light", "" + value);
      }
    }
    ObjectKeys.FILE.put(to, assets.file("texture", image.toPfm(), "pfm"));
  }

  private void texels(JsonObject to, TexelTexture texels, Filter filter) {
    TextureKinds.FAMILY.write(texels, to, this);
    TextureKinds.FILTER.put(to, filter);
  }

  /**
   * Writes a mesh and returns its id.
   *
   * @param source the object that has the mesh, by identity
   * @param variant distinguishes assets of one object
   */
  int mesh(Object source, String variant, TriangleMesh mesh) {
    return assets.id(
        source,
        variant,
        AssetTable.Type.MESH,
        to -> ObjectKeys.FILE.put(to, assets.file("mesh", ObjText.of(mesh), "obj")));
  }

  /** Returns a variant that no asset has. */
  String unique() {
    return "" + assets.assets().size();
  }
}
