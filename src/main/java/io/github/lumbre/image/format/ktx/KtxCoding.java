package io.github.lumbre.image.format.ktx;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;

/** How a file stores texels. */
enum KtxCoding {
  ETC1S(3, 0),
  ETC1S_ALPHA(4, 0),
  UASTC(3, 0),
  UASTC_ALPHA(4, 0),
  R8(1, 1),
  RG8(3, 2),
  RGB8(3, 3),
  RGBA8(4, 4);

  private static final int BASIC_BLOCK = 4;
  private static final int COLOR_MODEL = BASIC_BLOCK + 8;
  private static final int FLAGS = BASIC_BLOCK + 11;
  private static final int SAMPLES = BASIC_BLOCK + 24;
  private static final int SAMPLE_BYTES = 16;
  private static final int CHANNEL = 3;
  private static final int PREMULTIPLIED = 1;

  private static final int ETC1S_MODEL = 163;
  private static final int UASTC_MODEL = 166;

  private static final int RGB = 0;
  private static final int RED = 3;
  private static final int ETC1S_GREEN = 4;
  private static final int ETC1S_OPACITY = 15;
  private static final int UASTC_RGBA = 3;
  private static final int UASTC_RED = 4;

  private final int channels;
  private final int stored;

  KtxCoding(int channels, int stored) {
    this.channels = channels;
    this.stored = stored;
  }

  /** Returns the number of channels of the decoded picture, as {@link TexelBlocks} needs it. */
  int channels() {
    return channels;
  }

  /** Returns the number of bytes of a texel in the file; 0 if it has blocks. */
  int stored() {
    return stored;
  }

  boolean isBlocks() {
    return stored == 0;
  }

  boolean isEtc1s() {
    return this == ETC1S || this == ETC1S_ALPHA;
  }

  /**
   * Returns the coding that a file states.
   *
   * @param vkFormat the number of a Vulkan format, or 0 for those of Basis Universal
   */
  static KtxCoding of(int vkFormat, KtxInput descriptor) throws ImageFormatException {
    if (descriptor.number(FLAGS, Byte.BYTES) % 2 == PREMULTIPLIED) {
      throw malformed("KTX has colors that are multiplied by alpha, expected straight ones");
    }
    return switch (vkFormat) {
      case 0 -> basis(descriptor);
      case 9, 15 -> R8;
      case 16, 22 -> RG8;
      case 23, 29 -> RGB8;
      case 37, 43 -> RGBA8;
      default ->
          throw malformed(
              "KTX has the Vulkan format %s, expected ETC1S, UASTC or 1 to 4 channels of 8 bits"
                  .formatted(Integer.toUnsignedString(vkFormat)));
    };
  }

  private static KtxCoding basis(KtxInput descriptor) throws ImageFormatException {
    int model = descriptor.number(COLOR_MODEL, Byte.BYTES);
    if (model != ETC1S_MODEL && model != UASTC_MODEL) {
      throw malformed("KTX has the color model " + model + ", expected 163 (ETC1S) or 166 (UASTC)");
    }
    boolean isEtc1s = model == ETC1S_MODEL;
    int first = channel(descriptor, 0);
    boolean hasSecond = descriptor.size() >= SAMPLES + 2 * SAMPLE_BYTES;
    int second = isEtc1s && hasSecond ? channel(descriptor, 1) : ETC1S_OPACITY;
    boolean isColor = first == RGB || first == (isEtc1s ? RED : UASTC_RED);
    if (isEtc1s && isColor && second == ETC1S_OPACITY) {
      return hasSecond ? ETC1S_ALPHA : ETC1S;
    }
    if (!isEtc1s && (isColor || first == UASTC_RGBA)) {
      return first == UASTC_RGBA ? UASTC_ALPHA : UASTC;
    }
    boolean isPair = isEtc1s ? second == ETC1S_GREEN : first == 5 || first == 6;
    throw malformed(
        isPair
            ? "KTX has two channels of data, expected colors, with or without alpha"
            : "KTX has the channels %d and %d, expected colors".formatted(first, second));
  }

  private static int channel(KtxInput descriptor, int sample) throws ImageFormatException {
    return descriptor.number(SAMPLES + sample * SAMPLE_BYTES + CHANNEL, Byte.BYTES) & 0xf;
  }
}
