package generator;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/** Writes pictures as PNG files of 8 bits a channel. */
final class Png {
  private static final byte[] SIGNATURE = {(byte) 137, 80, 78, 71, 13, 10, 26, 10};

  private Png() {}

  /** Gives each row the filter that suits it, as is best for pictures of many colours. */
  static void write(Path file, Raster raster) throws IOException {
    write(file, raster, true);
  }

  /** Leaves the rows as they are, as is best for pictures of few colours. */
  static void writePlain(Path file, Raster raster) throws IOException {
    write(file, raster, false);
  }

  private static void write(Path file, Raster raster, boolean filters) throws IOException {
    Files.write(file, bytes(raster, filters));
  }

  /** Returns the bytes of a file. */
  static byte[] bytes(Raster raster) throws IOException {
    return bytes(raster, true);
  }

  private static byte[] bytes(Raster raster, boolean filters) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write(SIGNATURE);
    ByteArrayOutputStream header = new ByteArrayOutputStream();
    DataOutputStream fields = new DataOutputStream(header);
    fields.writeInt(raster.width);
    fields.writeInt(raster.height);
    fields.write(new byte[] {8, 2, 0, 0, 0});
    chunk(bytes, "IHDR", header.toByteArray());
    chunk(bytes, "IDAT", compress(raster, filters));
    chunk(bytes, "IEND", new byte[0]);
    return bytes.toByteArray();
  }

  private static byte[] compress(Raster raster, boolean filters) throws IOException {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
    try (DeflaterOutputStream out = new DeflaterOutputStream(packed, deflater)) {
      byte[] above = new byte[3 * raster.width];
      for (int y = 0; y < raster.height; y++) {
        byte[] row = row(raster, y);
        out.write(filtered(row, above, filters ? 3 : 1));
        above = row;
      }
    } finally {
      deflater.end();
    }
    return packed.toByteArray();
  }

  private static byte[] row(Raster raster, int y) {
    byte[] row = new byte[3 * raster.width];
    for (int x = 0; x < raster.width; x++) {
      int rgb = raster.get(x, y);
      row[3 * x] = (byte) (rgb >> 16);
      row[3 * x + 1] = (byte) (rgb >> 8);
      row[3 * x + 2] = (byte) rgb;
    }
    return row;
  }

  /** The row after its filter byte: of the first filters none, sub, up, the one of least sum. */
  private static byte[] filtered(byte[] row, byte[] above, int filters) {
    byte[] best = new byte[0];
    long least = Long.MAX_VALUE;
    for (int filter = 0; filter < filters; filter++) {
      byte[] line = new byte[row.length + 1];
      line[0] = (byte) filter;
      long sum = 0;
      for (int i = 0; i < row.length; i++) {
        int left = i < 3 ? 0 : row[i - 3];
        int predicted = filter == 1 ? left : filter == 2 ? above[i] : 0;
        line[i + 1] = (byte) (row[i] - predicted);
        sum += Math.abs(line[i + 1]);
      }
      if (sum < least) {
        least = sum;
        best = line;
      }
    }
    return best;
  }

  private static void chunk(ByteArrayOutputStream out, String type, byte[] data)
      throws IOException {
    byte[] name = type.getBytes(StandardCharsets.US_ASCII);
    CRC32 crc = new CRC32();
    crc.update(name);
    crc.update(data);
    DataOutputStream fields = new DataOutputStream(out);
    fields.writeInt(data.length);
    fields.write(name);
    fields.write(data);
    fields.writeInt((int) crc.getValue());
  }
}
