package io.github.lumbre.fuzz;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;

/**
 * Changes OpenEXR files by attributes and blocks, and portable float maps by words, so that
 * unchanged parts stay consistent. Confined to one thread.
 */
final class LinearPictureMutator {
  private static final int MAGIC_BYTES = 8;
  private static final int[] INTS = {
    0, 1, -1, 2, 3, 15, 16, 17, 18, 255, 65535, 65536, 1 << 28, Integer.MAX_VALUE, Integer.MIN_VALUE
  };
  private static final float[] FLOATS = {
    0,
    -0f,
    1e-45f,
    -1,
    1e30f,
    Float.MAX_VALUE,
    -Float.MAX_VALUE,
    Float.NaN,
    Float.POSITIVE_INFINITY,
    Float.NEGATIVE_INFINITY
  };
  private static final String[] WORDS = {
    "",
    "0",
    "-0",
    "1",
    "-1",
    "+2",
    "5",
    "7",
    "8",
    "65535",
    "65536",
    "268435457",
    "2147483647",
    "2147483648",
    "4294967301",
    "1e9",
    "NaN",
    "Infinity",
    "-1e-400",
    "1e400",
    "0x5",
    "a",
    "\u0000"
  };
  private static final String[] NAMES = {
    "R",
    "G",
    "B",
    "A",
    "Y",
    "",
    "RG",
    "dataWindow",
    "displayWindow",
    "channels",
    "compression",
    "lineOrder",
    "tiles",
    "a name that is longer than any of thirty-one"
  };

  private final List<byte[]> exrs;
  private final List<byte[]> pfms;
  private final Random random;

  /** A header attribute. */
  private record Attribute(String name, String type, byte[] value) {}

  /** A block of pixel lines that starts at the given line. */
  private record Block(int line, int length, byte[] data) {}

  private LinearPictureMutator(List<byte[]> exrs, List<byte[]> pfms, Random random) {
    this.exrs = exrs;
    this.pfms = pfms;
    this.random = random;
  }

  /** Returns a mutator of valid files, which it writes below a folder and does not delete. */
  static LinearPictureMutator in(Path folder) {
    List<byte[]> exrs = new ArrayList<>();
    List<byte[]> pfms = new ArrayList<>();
    for (int height : new int[] {3, 18}) {
      for (boolean noisy : new boolean[] {true, false}) {
        for (boolean hasAlpha : new boolean[] {true, false}) {
          Image image = sound(height, noisy, hasAlpha);
          exrs.add(file(image, folder.resolve("sound.exr")));
          pfms.add(file(image, folder.resolve("sound.pfm")));
        }
      }
    }
    return new LinearPictureMutator(exrs, pfms, new Random());
  }

  /** Returns the same mutator with another source of random numbers. */
  LinearPictureMutator drawingFrom(Random source) {
    return new LinearPictureMutator(exrs, pfms, source);
  }

  private static Image sound(int height, boolean noisy, boolean hasAlpha) {
    Random random = new Random(height);
    int pixels = 5 * height;
    float[] rgb = new float[3 * pixels];
    float[] alpha = new float[hasAlpha ? pixels : 0];
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = noisy ? random.nextFloat() : .5f;
    }
    Arrays.fill(alpha, .5f);
    return new Image(5, height, rgb, alpha);
  }

  private static byte[] file(Image image, Path file) {
    try {
      ImageWriter.write(
          image, file, new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, Map.of("a", "b")));
      return Files.readAllBytes(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns a file that differs from a valid one. */
  byte[] next() {
    byte[] file = random.nextBoolean() ? changedMap() : changedExr();
    return random.nextInt(8) == 0 ? Arrays.copyOf(file, random.nextInt(file.length + 1)) : file;
  }

  private byte[] changedMap() {
    byte[] file = pick(pfms).clone();
    String text = new String(file, StandardCharsets.ISO_8859_1);
    String[] words = text.split("\\s", 5);
    if (random.nextInt(3) == 0) {
      changeFloat(ByteBuffer.wrap(file), text.length() - words[4].length());
      return file;
    }
    for (int changes = 1 + random.nextInt(2); changes > 0; changes--) {
      int at = random.nextInt(5);
      words[at] = at == 0 ? List.of("PF", "Pf", "P6").get(random.nextInt(3)) : word(words[at]);
    }
    return String.join(random.nextInt(4) == 0 ? "\r\n" : "\n", words)
        .getBytes(StandardCharsets.ISO_8859_1);
  }

  private String word(String old) {
    return random.nextInt(6) == 0 ? old + old : WORDS[random.nextInt(WORDS.length)];
  }

  private byte[] changedExr() {
    ByteBuffer in = ByteBuffer.wrap(pick(exrs)).order(ByteOrder.LITTLE_ENDIAN);
    byte[] start = new byte[MAGIC_BYTES];
    in.get(start);
    List<Attribute> attributes = attributes(in);
    List<Block> blocks = new ArrayList<>();
    int table = (int) in.getLong(in.position()) - in.position();
    in.position(in.position() + table);
    while (in.hasRemaining()) {
      int line = in.getInt();
      byte[] data = new byte[in.getInt()];
      in.get(data);
      blocks.add(new Block(line, data.length, data));
    }
    for (int changes = 1 + random.nextInt(2); changes > 0; changes--) {
      if (random.nextInt(3) == 0) {
        changeBlocks(blocks);
      } else {
        changeAttributes(attributes);
      }
    }
    return file(start, attributes, new byte[table], blocks);
  }

  private static List<Attribute> attributes(ByteBuffer in) {
    List<Attribute> attributes = new ArrayList<>();
    for (String name = text(in); !name.isEmpty(); name = text(in)) {
      String type = text(in);
      byte[] value = new byte[in.getInt()];
      in.get(value);
      attributes.add(new Attribute(name, type, value));
    }
    return attributes;
  }

  private static String text(ByteBuffer in) {
    StringBuilder text = new StringBuilder();
    for (byte b = in.get(); b != 0; b = in.get()) {
      text.append((char) b);
    }
    return text.toString();
  }

  private void changeAttributes(List<Attribute> attributes) {
    int at = random.nextInt(attributes.size());
    Attribute old = attributes.get(at);
    byte[] value = old.value.clone();
    switch (random.nextInt(6)) {
      case 0 -> attributes.remove(at);
      case 1 -> attributes.add(random.nextInt(attributes.size()), old);
      case 2 -> attributes.set(at, new Attribute(pick(NAMES), old.type, value));
      case 3 -> {
        int length = random.nextInt(2 * value.length + 1);
        attributes.set(at, new Attribute(old.name, old.type, Arrays.copyOf(value, length)));
      }
      default -> {
        if (value.length >= Integer.BYTES && random.nextBoolean()) {
          int place = random.nextInt(value.length - Integer.BYTES + 1) & -2;
          ByteBuffer.wrap(value)
              .order(ByteOrder.LITTLE_ENDIAN)
              .putInt(place, INTS[random.nextInt(INTS.length)]);
        } else if (value.length > 0) {
          value[random.nextInt(value.length)] =
              (byte) random.nextInt(random.nextBoolean() ? 8 : 256);
        }
        attributes.set(at, new Attribute(old.name, old.type, value));
      }
    }
    if (attributes.isEmpty()) {
      attributes.add(old);
    }
  }

  private void changeBlocks(List<Block> blocks) {
    if (blocks.isEmpty()) {
      return;
    }
    int at = random.nextInt(blocks.size());
    Block old = blocks.get(at);
    byte[] data = old.data.clone();
    int value = INTS[random.nextInt(INTS.length)];
    switch (random.nextInt(6)) {
      case 0 -> blocks.remove(at);
      case 1 -> blocks.add(old);
      case 2 -> blocks.set(at, new Block(value, old.length, data));
      case 3 -> blocks.set(at, new Block(old.line, value, data));
      case 4 -> {
        data[random.nextInt(data.length)] = (byte) random.nextInt(256);
        blocks.set(at, new Block(old.line, old.length, data));
      }
      default -> {
        // Blocks that did not shrink are stored uncompressed, so this is the value of some pixel.
        changeFloat(ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN), 0);
        blocks.set(at, new Block(old.line, old.length, data));
      }
    }
  }

  private void changeFloat(ByteBuffer bytes, int start) {
    int floats = (bytes.limit() - start) / Float.BYTES;
    if (floats > 0) {
      bytes.order(ByteOrder.LITTLE_ENDIAN);
      int at = start + Float.BYTES * random.nextInt(floats);
      bytes.putFloat(at, FLOATS[random.nextInt(FLOATS.length)]);
    }
  }

  private static byte[] file(
      byte[] start, List<Attribute> attributes, byte[] table, List<Block> blocks) {
    ByteBuffer out = ByteBuffer.allocate(1 << 16).order(ByteOrder.LITTLE_ENDIAN).put(start);
    for (Attribute attribute : attributes) {
      for (String text : List.of(attribute.name, attribute.type)) {
        out.put(text.getBytes(StandardCharsets.ISO_8859_1)).put((byte) 0);
      }
      out.putInt(attribute.value.length).put(attribute.value);
    }
    out.put((byte) 0).put(table);
    for (Block block : blocks) {
      out.putInt(block.line).putInt(block.length).put(block.data);
    }
    return Arrays.copyOf(out.array(), out.position());
  }

  private <T> T pick(List<T> list) {
    return list.get(random.nextInt(list.size()));
  }

  private String pick(String[] list) {
    return list[random.nextInt(list.length)];
  }
}
