package io.github.lumbre.cli;

import io.github.lumbre.base.Release;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.Base64;
import java.util.HexFormat;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.zip.InflaterInputStream;

/**
 * What of a text or file is the same in each run, on each JDK and in each folder: compressed data
 * are unpacked, and times, rates, memory, paths and the version are replaced.
 *
 * @param folder whose path is replaced by T
 */
record SteadyBytes(Path folder) {
  private static final Charset BYTES = StandardCharsets.ISO_8859_1;
  private static final int CHECKSUM_BYTES = 4;

  private static final Pattern MEASURED =
      Pattern.compile("(\"[a-z_]*(?:seconds|heap_bytes|per_second)\": ?)[-+.0-9eE]+");

  private static final Pattern TIMES =
      Pattern.compile("[0-9.]+(?: [MG])?( m?s\\b| samples/s| rays/s)");

  private static final Pattern STATISTICS =
      Pattern.compile("(?m)^((?:rays/s|threads|peak heap|heap|scene|needed) +)\\d.*$");

  /** The marker and the length of a comment in a JPEG. */
  private static final Pattern COMMENT = Pattern.compile("(?s)\u00ff\u00fe..(?=Software: )");

  private static final Pattern COMMENTED_TIME = Pattern.compile("Time: [0-9.]+\n");

  private static final Pattern PICTURE = Pattern.compile("iVBORw0KGgo[-A-Za-z0-9+/]*=*");

  /** Returns 16 hexadecimal digits of a hash. */
  static String hash(byte[] bytes) {
    try {
      byte[] hash = MessageDigest.getInstance("SHA-256").digest(bytes);
      return HexFormat.of().formatHex(hash, 0, 8);
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError(e);
    }
  }

  /** Returns a printed text without what was measured. */
  String text(String text) {
    String steady = named(text);
    steady = MEASURED.matcher(steady).replaceAll("$10");
    steady = TIMES.matcher(steady).replaceAll("0$1");
    steady = STATISTICS.matcher(steady).replaceAll("$10");
    return PICTURE.matcher(steady).replaceAll(found -> hash(pictureOf(found.group())));
  }

  private byte[] pictureOf(String base64) {
    return png(Base64.getDecoder().decode(base64));
  }

  private String named(String text) {
    return text.replace(folder.toString(), "T").replace(Release.number(), "VERSION");
  }

  /** Returns the content of a file. */
  byte[] file(String name, byte[] bytes) {
    return switch (name.replaceFirst(".*\\.", "")) {
      case "png", "apng" -> png(bytes);
      case "exr" -> exr(bytes);
      case "jpg" -> jpeg(bytes);
      case "film", "bak" ->
          named(new String(bytes, 0, bytes.length - CHECKSUM_BYTES, BYTES)).getBytes(BYTES);
      case "json", "html" ->
          text(new String(bytes, StandardCharsets.UTF_8)).getBytes(StandardCharsets.UTF_8);
      default -> named(new String(bytes, BYTES)).getBytes(BYTES);
    };
  }

  private byte[] jpeg(byte[] file) {
    String steady = COMMENT.matcher(named(new String(file, BYTES))).replaceFirst("");
    return COMMENTED_TIME.matcher(steady).replaceFirst("").getBytes(BYTES);
  }

  /** Returns the chunks of a PNG or APNG, without checksums, with unpacked pixels. */
  private byte[] png(byte[] file) {
    ByteBuffer chunks = ByteBuffer.wrap(file);
    chunks.position(8);
    ByteArrayOutputStream steady = new ByteArrayOutputStream();
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    while (chunks.hasRemaining()) {
      byte[] data = new byte[chunks.getInt() + 4];
      chunks.get(data).getInt();
      String type = new String(data, 0, 4, BYTES);
      if (type.equals("IDAT") || type.equals("fdAT")) {
        int from = type.equals("IDAT") ? 4 : 8;
        packed.write(data, from, data.length - from);
      } else {
        steady.writeBytes(unpacked(packed.toByteArray()));
        packed.reset();
        steady.writeBytes(chunk(type, data));
      }
    }
    return steady.toByteArray();
  }

  /** Returns a chunk without its number, or its text without what differs. */
  private byte[] chunk(String type, byte[] data) {
    String content = new String(data, BYTES);
    return switch (type) {
      case "fcTL" -> Arrays.copyOfRange(data, 8, data.length);
      case "tEXt", "iTXt" ->
          content.startsWith("Time\0", 4) ? new byte[0] : named(content).getBytes(BYTES);
      default -> data;
    };
  }

  private static byte[] unpacked(byte[] packed) {
    if (packed.length == 0) {
      return packed;
    }
    try (InflaterInputStream in = new InflaterInputStream(new ByteArrayInputStream(packed))) {
      return in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private byte[] exr(byte[] file) {
    try {
      LayeredImage image = LayeredImage.of(file);
      TreeMap<String, String> texts = new TreeMap<>(image.texts());
      texts.remove("Time");
      StringBuilder names = new StringBuilder(named(texts.toString()));
      ByteArrayOutputStream steady = new ByteArrayOutputStream();
      for (ImageLayer layer : image.layers()) {
        names.append(layer.name()).append(layer.channels()).append(layer.precision());
        ByteBuffer values = ByteBuffer.allocate(4 * layer.values().length);
        values.asFloatBuffer().put(layer.values());
        steady.writeBytes(values.array());
      }
      steady.writeBytes(names.toString().getBytes(StandardCharsets.UTF_8));
      return steady.toByteArray();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
