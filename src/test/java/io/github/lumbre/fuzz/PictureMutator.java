package io.github.lumbre.fuzz;

import io.github.lumbre.image.format.dds.DdsFixture;
import io.github.lumbre.image.format.imageio.LegacyFixture;
import io.github.lumbre.image.format.jpeg.ProgressiveJpeg;
import io.github.lumbre.image.format.png.PngFixture;
import io.github.lumbre.image.format.tga.TgaFixture;
import io.github.lumbre.testing.Pictures;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Changes PNG files chunk by chunk, with valid checksums, and other files byte by byte. */
final class PictureMutator {
  private static final int SIGNATURE_BYTES = 8;
  private static final int[] TYPES = {
    BufferedImage.TYPE_INT_RGB,
    BufferedImage.TYPE_INT_ARGB,
    BufferedImage.TYPE_BYTE_GRAY,
    BufferedImage.TYPE_USHORT_GRAY,
    BufferedImage.TYPE_BYTE_BINARY,
    BufferedImage.TYPE_BYTE_INDEXED
  };
  private static final int[] SIDES = {
    0, 1, 2, 4, 5, 255, 4096, 12000, 16384, 18375, 65535, 65536, Integer.MAX_VALUE, -1
  };
  private static final String[] CHUNKS = {
    "IHDR",
    "PLTE",
    "IDAT",
    "IEND",
    "tRNS",
    "gAMA",
    "iCCP",
    "zTXt",
    "iTXt",
    "acTL",
    "fdAT",
    "sPLT",
    "abcd",
    "\u0000\u0000\u0000\u0000"
  };
  private static final List<byte[]> PNGS = files("png", TYPES);
  private static final List<byte[]> JPEGS =
      files("jpg", BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_BYTE_GRAY);

  private static final List<byte[]> OTHERS =
      Stream.of(
              TgaFixture.files(),
              DdsFixture.files(),
              LegacyFixture.bmps(),
              LegacyFixture.gifs(),
              LegacyFixture.tiffs())
          .flatMap(files -> files)
          .toList();

  static {
    // The maximum number of scans, and more.
    JPEGS.add(ProgressiveJpeg.gray(2, 100));
    JPEGS.add(ProgressiveJpeg.gray(1, 101));
  }

  private record Chunk(String type, byte[] data) {}

  private final Random random;

  PictureMutator(Random random) {
    this.random = random;
  }

  private static List<byte[]> files(String format, int... types) {
    List<byte[]> files = new ArrayList<>();
    for (int type : types) {
      BufferedImage image = new BufferedImage(4, 3, type);
      for (int i = 0; i < 12; i++) {
        image.setRGB(i % 4, i / 4, 0xff000000 | i * 1234567);
      }
      files.add(Pictures.file(image, format));
    }
    return files;
  }

  /** Returns a valid picture file. */
  static byte[] sound() {
    return PNGS.get(0).clone();
  }

  /** Returns a picture file that differs from a valid one. */
  byte[] next() {
    if (random.nextInt(4) == 0) {
      return changedBytes(JPEGS.get(random.nextInt(JPEGS.size())));
    }
    if (random.nextInt(3) == 0) {
      return changedBytes(OTHERS.get(random.nextInt(OTHERS.size())));
    }
    byte[] png = PNGS.get(random.nextInt(PNGS.size()));
    return random.nextInt(4) == 0 ? changedBytes(png) : changedChunks(png);
  }

  private byte[] changedBytes(byte[] sound) {
    byte[] file = sound.clone();
    for (int changes = 1 + random.nextInt(4); changes > 0; changes--) {
      int at = random.nextInt(file.length);
      file[at] =
          switch (random.nextInt(4)) {
            case 0 -> (byte) (file[at] ^ 1 << random.nextInt(8));
            case 1 -> (byte) 0xff;
            case 2 -> 0;
            default -> (byte) random.nextInt(256);
          };
    }
    return random.nextInt(6) == 0 ? Arrays.copyOf(file, random.nextInt(file.length)) : file;
  }

  private byte[] changedChunks(byte[] sound) {
    List<Chunk> chunks = chunks(sound);
    int at = random.nextInt(chunks.size());
    Chunk chunk = chunks.get(at);
    switch (random.nextInt(8)) {
      case 0 -> chunks.remove(at);
      case 1 -> chunks.add(random.nextInt(chunks.size()), chunk);
      case 2 -> chunks.set(at, new Chunk(CHUNKS[random.nextInt(CHUNKS.length)], chunk.data));
      case 3 -> chunks.set(at, new Chunk(chunk.type, cut(chunk.data)));
      case 4 -> chunks.set(0, new Chunk("IHDR", header(chunks.get(0).data)));
      case 5 -> chunks.add(1, new Chunk("PLTE", new byte[random.nextInt(800)]));
      case 6 -> addTransparency(chunks);
      default -> changePixels(chunks);
    }
    return file(sound, chunks);
  }

  /** Adds alpha of colors before the pixels, mostly as long as one of the color types needs. */
  private void addTransparency(List<Chunk> chunks) {
    int[] lengths = {2, 6, random.nextInt(300)};
    byte[] data = new byte[lengths[random.nextInt(lengths.length)]];
    if (random.nextBoolean()) {
      random.nextBytes(data);
    }
    int pixels = chunks.stream().map(Chunk::type).toList().indexOf("IDAT");
    chunks.add(pixels, new Chunk("tRNS", data));
  }

  private static List<Chunk> chunks(byte[] file) {
    List<Chunk> chunks = new ArrayList<>();
    ByteBuffer in = ByteBuffer.wrap(file).position(SIGNATURE_BYTES);
    while (in.hasRemaining()) {
      byte[] data = new byte[in.getInt()];
      byte[] type = new byte[4];
      in.get(type).get(data).getInt();
      chunks.add(new Chunk(new String(type, StandardCharsets.ISO_8859_1), data));
    }
    return chunks;
  }

  private byte[] cut(byte[] data) {
    return Arrays.copyOf(data, random.nextInt(2 * data.length + 1));
  }

  private byte[] header(byte[] sound) {
    byte[] header = Arrays.copyOf(sound, 13);
    int field = random.nextInt(7);
    if (field < 2) {
      ByteBuffer.wrap(header).putInt(4 * field, SIDES[random.nextInt(SIDES.length)]);
    } else {
      int[] values = {0, 1, 2, 3, 4, 6, 8, 16, 255};
      header[field + 6] = (byte) values[random.nextInt(values.length)];
    }
    return header;
  }

  /** Changes the pixels' bytes before compression, so that the compressed stream stays valid. */
  private void changePixels(List<Chunk> chunks) {
    for (int i = 0; i < chunks.size(); i++) {
      if (chunks.get(i).type.equals("IDAT")) {
        byte[] pixels = inflated(chunks.get(i).data);
        byte[] changed =
            random.nextBoolean() || pixels.length == 0 ? cut(pixels) : changedBytes(pixels);
        chunks.set(i, new Chunk("IDAT", PngFixture.deflated(changed)));
      }
    }
  }

  private static byte[] inflated(byte[] data) {
    Inflater inflater = new Inflater();
    inflater.setInput(data);
    byte[] out = new byte[1000];
    try {
      return Arrays.copyOf(out, inflater.inflate(out));
    } catch (DataFormatException e) {
      return data;
    } finally {
      inflater.end();
    }
  }

  private static byte[] file(byte[] sound, List<Chunk> chunks) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(sound, 0, SIGNATURE_BYTES);
    for (Chunk chunk : chunks) {
      byte[] type = chunk.type.getBytes(StandardCharsets.ISO_8859_1);
      CRC32 crc = new CRC32();
      crc.update(type);
      crc.update(chunk.data);
      ByteBuffer whole = ByteBuffer.allocate(12 + chunk.data.length);
      whole.putInt(chunk.data.length).put(type).put(chunk.data).putInt((int) crc.getValue());
      out.writeBytes(whole.array());
    }
    return out.toByteArray();
  }
}
