package io.github.lumbre.image.internal;

import static io.github.lumbre.image.ImageFormatException.malformed;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.stream.JsonReader;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Mattes of named items, such as objects, in an OpenEXR file: the items of each pixel with the
 * share of the pixel that each covers. The format is Cryptomatte 1.2 (Friedman and Jones 2015,
 * "Fully Automatic ID Mattes with Support for Motion Blur and Transparency").
 *
 * @param type the name of the kind of items, such as CryptoObject
 * @param layers the layers of the file, each with two items of each pixel in decreasing share:
 *     ranks 0 and 1 in the first layer
 * @param ids the id of each item by its name
 */
public record Cryptomatte(String type, List<ImageLayer> layers, Map<String, Integer> ids) {
  /** The number of layers that are written; each holds two items of each pixel. */
  private static final int LAYERS = 3;

  private static final String PREFIX = "cryptomatte/";
  private static final Gson GSON = new GsonBuilder().disableHtmlEscaping().create();

  public Cryptomatte {
    layers = List.copyOf(layers);
    ids = Collections.unmodifiableMap(new TreeMap<>(ids));
  }

  /** The items of each pixel. */
  @FunctionalInterface
  public interface Shares {
    /**
     * Returns the share of a pixel that each item covers, by the item's name; shares are in [0,1].
     *
     * @param pixel index of the pixel, row by row from the top left
     */
    Map<String, Float> of(int pixel);
  }

  private record Item(int id, float share) {}

  /**
   * Returns the mattes of a picture. The six items with the largest shares of each pixel are kept.
   *
   * @param type the name of the kind of items
   */
  public static Cryptomatte of(String type, int width, int height, Shares shares) {
    List<float[]> rasters = new ArrayList<>();
    for (int i = 0; i < LAYERS; i++) {
      rasters.add(new float[Math.multiplyExact(4, width * height)]);
    }
    Map<String, Integer> ids = new HashMap<>();
    for (int pixel = 0; pixel < width * height; pixel++) {
      List<Item> items = new ArrayList<>();
      shares
          .of(pixel)
          .forEach(
              (name, share) -> items.add(new Item(ids.computeIfAbsent(name, n -> id(n)), share)));
      items.sort(Comparator.comparing(Item::share).reversed().thenComparing(Item::id));
      for (int rank = 0; rank < Math.min(items.size(), 2 * LAYERS); rank++) {
        float[] raster = rasters.get(rank / 2);
        raster[4 * pixel + rank % 2 * 2] = Float.intBitsToFloat(items.get(rank).id);
        raster[4 * pixel + rank % 2 * 2 + 1] = items.get(rank).share;
      }
    }
    List<ImageLayer> layers = new ArrayList<>();
    for (int i = 0; i < LAYERS; i++) {
      layers.add(
          new ImageLayer(
              "%s%02d".formatted(type, i),
              List.of("R", "G", "B", "A"),
              ImageLayer.Precision.FLOAT,
              width,
              height,
              rasters.get(i)));
    }
    return new Cryptomatte(type, layers, ids);
  }

  /** Returns the attributes of the file that describe the mattes, by name. */
  public Map<String, String> metadata() {
    String key = PREFIX + "%08x".formatted(hash(type)).substring(0, 7) + "/";
    Map<String, String> manifest = new LinkedHashMap<>();
    ids.forEach((name, id) -> manifest.put(name, "%08x".formatted(id)));
    Map<String, String> metadata = new LinkedHashMap<>();
    metadata.put(key + "name", type);
    metadata.put(key + "hash", "MurmurHash3_32");
    metadata.put(key + "conversion", "uint32_to_float32");
    metadata.put(key + "manifest", GSON.toJson(manifest));
    return metadata;
  }

  /**
   * Returns the mattes in a file, in the order of their attributes.
   *
   * @throws ImageFormatException if a manifest is not a JSON object of names and ids
   */
  public static List<Cryptomatte> in(LayeredImage file) throws ImageFormatException {
    List<Cryptomatte> all = new ArrayList<>();
    for (Map.Entry<String, String> text : file.texts().entrySet()) {
      String name = text.getKey();
      if (name.startsWith(PREFIX) && name.endsWith("/name")) {
        String key = name.substring(0, name.length() - "name".length());
        String manifest = file.texts().getOrDefault(key + "manifest", "{}");
        List<ImageLayer> ranks =
            file.layers().stream()
                .filter(layer -> isRank(layer.name(), text.getValue()))
                .filter(layer -> layer.channels().size() == 4)
                .toList();
        all.add(new Cryptomatte(text.getValue(), ranks, parsed(manifest)));
      }
    }
    return all;
  }

  private static boolean isRank(String layer, String type) {
    return layer.startsWith(type) && layer.substring(type.length()).matches("\\d+");
  }

  private static Map<String, Integer> parsed(String manifest) throws ImageFormatException {
    Map<String, Integer> ids = new HashMap<>();
    try (JsonReader reader = new JsonReader(new StringReader(manifest))) {
      reader.beginObject();
      while (reader.hasNext()) {
        ids.put(reader.nextName(), Integer.parseUnsignedInt(reader.nextString(), 16));
      }
      reader.endObject();
      return ids;
    } catch (IOException | IllegalStateException | NumberFormatException e) {
      throw malformed("Cryptomatte: expected a manifest of names and hexadecimal ids");
    }
  }

  /** Returns the share of each pixel that an item covers, row by row; 0 for an unknown item. */
  public float[] mask(String name) {
    int pixels = layers.isEmpty() ? 0 : layers.get(0).width() * layers.get(0).height();
    float[] mask = new float[pixels];
    Integer id = ids.get(name);
    for (ImageLayer layer : id == null ? List.<ImageLayer>of() : layers) {
      float[] values = layer.values();
      for (int i = 0; i < values.length; i += 2) {
        if (Float.floatToRawIntBits(values[i]) == id && values[i + 1] > 0) {
          mask[i / 4] += values[i + 1];
        }
      }
    }
    return mask;
  }

  /** Returns the id of a name: its hash, changed so that its bits form a normal float. */
  public static int id(String name) {
    int hash = hash(name);
    int exponent = hash >>> 23 & 0xff;
    return exponent == 0 || exponent == 0xff ? hash ^ 1 << 23 : hash;
  }

  /** Returns MurmurHash3_x86_32 of the UTF-8 bytes of a text, with seed 0 (Appleby 2011). */
  public static int hash(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    int hash = 0;
    for (int i = 0; i < bytes.length; i += 4) {
      int block = 0;
      for (int b = 0; b < Math.min(4, bytes.length - i); b++) {
        block |= (bytes[i + b] & 0xff) << 8 * b;
      }
      hash ^= Integer.rotateLeft(block * 0xcc9e2d51, 15) * 0x1b873593;
      if (bytes.length - i >= 4) {
        hash = Integer.rotateLeft(hash, 13) * 5 + 0xe6546b64;
      }
    }
    hash ^= bytes.length;
    hash = (hash ^ hash >>> 16) * 0x85ebca6b;
    hash = (hash ^ hash >>> 13) * 0xc2b2ae35;
    return hash ^ hash >>> 16;
  }
}
