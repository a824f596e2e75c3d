package io.github.lumbre.image.format.exr;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.format.exr.ExrDwaRules.Choice;
import io.github.lumbre.image.format.exr.ExrDwaRules.Scheme;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.DataFormatException;

/**
 * Unpacks DWAA and DWAB compression. By rules of names and types, channels are deflated, run-length
 * encoded, or given as coefficients of cosines, alone or as luminance and chroma of three channels
 * ("DWA" in "Technical Introduction to OpenEXR", openexr.com; the layout is that of OpenEXRCore).
 * Not reusable.
 */
final class ExrDwa {
  private static final int NEWEST = 2;
  private static final int FIRST_WITH_RULES = 2;
  private static final int HUFFMAN = 0;
  private static final int DEFLATE = 1;

  private final ByteBuffer in;
  private final ExrBlock block;
  private final byte[] out;
  private final int lineBytes;
  private final List<Choice> choices;

  /** For each channel, the place of its first byte in a line. */
  private final int[] starts;

  private final Sizes sizes;

  /** The numbers at the start of a block, in their order; "packed" ones are numbers of bytes. */
  private record Sizes(
      int deflated,
      int packedDeflated,
      int packedHigher,
      int packedLowest,
      int packedRuns,
      int runs,
      int repeated,
      int higher,
      int lowest,
      int higherCompression) {
    static Sizes read(ByteBuffer in) {
      return new Sizes(
          next(in), next(in), next(in), next(in), next(in), next(in), next(in), next(in), next(in),
          next(in));
    }

    static int next(ByteBuffer in) {
      return Math.toIntExact(in.getLong());
    }
  }

  ExrDwa(byte[] packed, ExrBlock block) throws ImageFormatException {
    in = ExrBytes.little(packed);
    this.block = block;
    out = new byte[block.bytes()];
    lineBytes = block.lineBytes();
    int version = Sizes.next(in);
    if (version < 0 || version > NEWEST) {
      throw malformed("OpenEXR: expected DWA compression of version 0 to 2, found " + version);
    }
    sizes = Sizes.read(in);
    ExrDwaRules rules = version < FIRST_WITH_RULES ? ExrDwaRules.old() : ExrDwaRules.read(in);
    choices = block.channels().stream().map(rules::choice).toList();
    starts = new int[choices.size()];
    for (int i = 1; i < starts.length; i++) {
      starts[i] = starts[i - 1] + block.width() * block.channels().get(i - 1).type().bytes();
    }
  }

  /** Returns the bytes of the block: for each line, the bytes of one channel after the other. */
  byte[] unpacked() throws ImageFormatException, DataFormatException {
    readDeflated();
    ExrDwaCosines cosines = cosines();
    readRuns();
    for (int[] group : groups()) {
      cosines.read(group, starts);
    }
    return out;
  }

  private void readDeflated() throws ImageFormatException, DataFormatException {
    checkSize(sizes.deflated, bytes(Scheme.DEFLATED));
    byte[] planes = inflated(sizes.packedDeflated, sizes.deflated);
    int at = 0;
    for (int channel = 0; channel < starts.length; channel++) {
      if (choices.get(channel).scheme() == Scheme.DEFLATED) {
        int bytes = block.width() * block.channels().get(channel).type().bytes();
        for (int y = 0; y < block.height(); y++, at += bytes) {
          System.arraycopy(planes, at, out, starts[channel] + y * lineBytes, bytes);
        }
      }
    }
  }

  /** Reads channels whose pixels were split into planes, one for each of their bytes. */
  private void readRuns() throws ImageFormatException, DataFormatException {
    checkSize(sizes.repeated, bytes(Scheme.RUNS));
    if (sizes.runs < 0 || sizes.runs > 2L * sizes.repeated) {
      throw ExrBytes.wrongSize();
    }
    byte[] planes = ExrBytes.repeated(inflated(sizes.packedRuns, sizes.runs), sizes.repeated);
    int at = 0;
    for (int channel = 0; channel < starts.length; channel++) {
      if (choices.get(channel).scheme() == Scheme.RUNS) {
        int bytes = block.channels().get(channel).type().bytes();
        for (int part = 0; part < bytes; part++) {
          for (int y = 0; y < block.height(); y++) {
            int to = starts[channel] + y * lineBytes + part;
            for (int x = 0; x < block.width(); x++) {
              out[to + x * bytes] = planes[at++];
            }
          }
        }
      }
    }
  }

  private ExrDwaCosines cosines() throws ImageFormatException, DataFormatException {
    int channels = (int) choices.stream().filter(c -> c.scheme() == Scheme.COSINES).count();
    int squares = ExrDwaCosines.squares(block);
    checkSize(sizes.lowest, (long) channels * squares);
    if (sizes.higher < 0 || sizes.higher > (long) channels * squares * (ExrDct.SIZE - 1)) {
      throw ExrBytes.wrongSize();
    }
    short[] higher = higher();
    byte[] split = inflated(sizes.packedLowest, Short.BYTES * sizes.lowest);
    return new ExrDwaCosines(block, higher, shorts(ExrBytes.merged(split)), out);
  }

  private short[] higher() throws ImageFormatException, DataFormatException {
    if (sizes.higher > 0 && sizes.higherCompression == HUFFMAN) {
      short[] higher = new short[sizes.higher];
      new ExrHuffman(ExrBytes.little(next(sizes.packedHigher))).decode(higher);
      return higher;
    }
    if (sizes.higher > 0 && sizes.higherCompression != DEFLATE) {
      throw malformed("OpenEXR is damaged: a block has an unknown DWA compression");
    }
    return shorts(inflated(sizes.packedHigher, Short.BYTES * sizes.higher));
  }

  /** Returns the channels of cosines: first those with chroma, by layers, then the others. */
  private List<int[]> groups() throws ImageFormatException {
    Map<String, List<Integer>> colors = new LinkedHashMap<>();
    for (int i = 0; i < starts.length; i++) {
      List<Integer> color =
          colors.computeIfAbsent(
              block.channels().get(i).layer(), layer -> new ArrayList<>(List.of(-1, -1, -1)));
      if (choices.get(i).color() >= 0) {
        color.set(choices.get(i).color(), i);
      }
    }
    List<int[]> groups = new ArrayList<>();
    BitSet rest = new BitSet();
    for (int i = 0; i < starts.length; i++) {
      rest.set(i, choices.get(i).scheme() == Scheme.COSINES);
    }
    for (List<Integer> color : colors.values()) {
      if (!color.contains(-1)) {
        color.forEach(rest::clear);
        groups.add(color.stream().mapToInt(i -> i).toArray());
      }
    }
    rest.stream().forEach(i -> groups.add(new int[] {i}));
    for (int i : groups.stream().flatMapToInt(Arrays::stream).toArray()) {
      if (choices.get(i).scheme() != Scheme.COSINES
          || block.channels().get(i).type() == ExrChannel.Type.UINT) {
        throw malformed("OpenEXR is damaged: a rule of DWA compression does not fit its channel");
      }
    }
    return groups;
  }

  /** Returns the number of bytes of the channels of a scheme. */
  private long bytes(Scheme scheme) {
    long bytes = 0;
    for (int i = 0; i < starts.length; i++) {
      bytes += choices.get(i).scheme() == scheme ? block.channels().get(i).type().bytes() : 0;
    }
    return bytes * block.width() * block.height();
  }

  private static void checkSize(int found, long expected) throws ImageFormatException {
    if (found != expected) {
      throw ExrBytes.wrongSize();
    }
  }

  private byte[] inflated(int packed, int size) throws ImageFormatException, DataFormatException {
    return packed == 0 && size == 0 ? new byte[0] : ExrBytes.inflated(next(packed), size);
  }

  private byte[] next(int count) throws ImageFormatException {
    if (count < 0 || count > in.remaining()) {
      throw ExrBytes.wrongSize();
    }
    byte[] bytes = new byte[count];
    in.get(bytes);
    return bytes;
  }

  private static short[] shorts(byte[] bytes) {
    short[] shorts = new short[bytes.length / Short.BYTES];
    ExrBytes.little(bytes).asShortBuffer().get(shorts);
    return shorts;
  }
}
