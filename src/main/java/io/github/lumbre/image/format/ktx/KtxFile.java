package io.github.lumbre.image.format.ktx;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.internal.PictureLimits;
import java.nio.ByteBuffer;

/**
 * A KTX 2 file whose header has been read (KTX File Format 2.0, section 3). It has one picture and
 * its smaller levels; arrays, cube maps, volumes and videos are refused.
 */
public final class KtxFile {
  private static final long SIGNATURE = 0xab4b5458203230bbL;
  private static final long SIGNATURE_VERSION_1 = 0xab4b5458203131bbL;
  private static final int VK_FORMAT = 12;
  private static final int WIDTH = 20;
  private static final int HEIGHT = 24;
  private static final int DEPTH = 28;
  private static final int LAYERS = 32;
  private static final int FACES = 36;
  private static final int LEVELS = 40;
  private static final int SCHEME = 44;
  private static final int DESCRIPTOR = 48;
  private static final int METADATA = 56;
  private static final int GLOBAL_DATA = 64;
  private static final int LEVEL_INDEX = 80;
  private static final int LEVEL_BYTES = 24;

  private final KtxInput level;
  private final KtxInput global;
  private final int width;
  private final int height;
  private final int levels;
  private final KtxCoding coding;
  private final KtxCompression compression;
  private final KtxMetadata metadata;

  private KtxFile(KtxInput in) throws ImageFormatException {
    width = in.number(WIDTH, Integer.BYTES);
    height = in.number(HEIGHT, Integer.BYTES);
    levels = Math.max(1, in.number(LEVELS, Integer.BYTES));
    requireOnePicture(in);
    PictureLimits.checkSize(width, height);
    KtxInput descriptor = part(in, DESCRIPTOR, "a data format descriptor");
    coding = KtxCoding.of(in.number(VK_FORMAT, Integer.BYTES), descriptor);
    compression = KtxCompression.of(in.number(SCHEME, Integer.BYTES), coding);
    metadata = KtxMetadata.of(part(in, METADATA, "key/value data"));
    global =
        in.part(in.longWord(GLOBAL_DATA), in.longWord(GLOBAL_DATA + Long.BYTES), "global data");
    level = in.part(in.longWord(LEVEL_INDEX), in.longWord(LEVEL_INDEX + Long.BYTES), "level 0");
    compression.requireEnough(level, bytes());
  }

  private static KtxInput part(KtxInput in, int at, String title) throws ImageFormatException {
    return in.part(in.word(at), in.word(at + Integer.BYTES), title);
  }

  /** Returns whether a file is a KTX file of version 1 or 2. */
  public static boolean startsIn(byte[] file) {
    long start = file.length < LEVEL_INDEX ? 0 : ByteBuffer.wrap(file).getLong();
    return start == SIGNATURE || start == SIGNATURE_VERSION_1;
  }

  /**
   * Reads the header of a file that {@link #startsIn} recognizes.
   *
   * @throws ImageFormatException if the picture is not of a supported kind, exceeds the limits or
   *     is larger than its data can hold
   */
  public static EncodedPicture open(byte[] file) throws ImageFormatException {
    if (ByteBuffer.wrap(file).getLong() != SIGNATURE) {
      throw malformed("KTX has version 1, expected version 2");
    }
    KtxFile ktx = new KtxFile(new KtxInput(file, 0, file.length, "the header"));
    return new EncodedPicture(ktx.width, ktx.height, ktx.bytesPerPixel(), ktx::decode);
  }

  private void requireOnePicture(KtxInput in) throws ImageFormatException {
    long layers = in.word(LAYERS);
    String found =
        in.word(FACES) != 1
            ? "a cube map"
            : in.word(DEPTH) > 0
                ? "a volume"
                : layers > 1
                    ? "an array or a video of " + layers + " pictures"
                    : height == 0 ? "a picture of one dimension" : "";
    if (!found.isEmpty()) {
      throw malformed("KTX has " + found + ", expected one picture of two dimensions");
    }
    if (levels > Integer.SIZE) {
      throw malformed("KTX has " + levels + " levels, expected at most 32");
    }
  }

  private int bytesPerPixel() {
    int decompressed = compression.hasOwnBytes() ? Math.max(1, coding.stored()) : 0;
    return coding.channels() + decompressed;
  }

  /** Returns the number of bytes of the level before compression. */
  private int bytes() {
    return coding.isBlocks()
        ? TexelBlocks.count(width) * TexelBlocks.count(height) * UastcBlock.BYTES
        : Math.multiplyExact(coding.stored(), width * height);
  }

  private Pixels decode() throws ImageFormatException {
    TexelBlocks target = new TexelBlocks(width, height, coding.channels(), metadata);
    switch (coding) {
      case ETC1S, ETC1S_ALPHA -> Etc1sPicture.decode(level, global, levels, target);
      case UASTC, UASTC_ALPHA -> target.fillFromBlocks(compression.decoded(level, bytes()));
      default -> target.fill(compression.decoded(level, bytes()), coding.stored());
    }
    return target.pixels();
  }

  /** Decodes pictures of ETC1S blocks (KTX File Format 2.0, BasisLZ global data). Stateless. */
  private static final class Etc1sPicture {
    private static final int HEADER_BYTES = 20;
    private static final int IMAGE_BYTES = 20;
    private static final int NEEDS_LAST_FRAME = 2;

    private Etc1sPicture() {}

    /**
     * Fills a picture.
     *
     * @param levels in the file; the global data describe one picture for each
     */
    static void decode(KtxInput level, KtxInput global, int levels, TexelBlocks target)
        throws ImageFormatException {
      KtxInput image = global.part(HEADER_BYTES, IMAGE_BYTES, "an image description");
      if ((image.number(0, Integer.BYTES) & NEEDS_LAST_FRAME) != 0) {
        throw malformed("KTX has a frame of a video, expected one picture");
      }
      long at = HEADER_BYTES + (long) levels * IMAGE_BYTES;
      KtxInput endpoints = global.part(at, global.word(4), "the code book of colors");
      at += endpoints.size();
      KtxInput selectors = global.part(at, global.word(8), "the code book of selectors");
      at += selectors.size();
      Etc1sCodeBooks books =
          Etc1sCodeBooks.read(
              new BasisBits(endpoints),
              global.number(0, Short.BYTES),
              new BasisBits(selectors),
              global.number(2, Short.BYTES));
      KtxInput codes = global.part(at, global.word(12), "the list of codes");
      Etc1sTables tables = Etc1sTables.read(new BasisBits(codes));
      KtxInput colors = level.part(image.word(4), image.word(8), "the slice of colors");
      new Etc1sSlice(colors, books, tables, target, false).decode();
      if (target.hasAlpha()) {
        KtxInput alpha = level.part(image.word(12), image.word(16), "the slice of alpha");
        new Etc1sSlice(alpha, books, tables, target, true).decode();
      }
    }
  }
}
