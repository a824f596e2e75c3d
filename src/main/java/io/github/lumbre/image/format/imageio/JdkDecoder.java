package io.github.lumbre.image.format.imageio;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.format.jpeg.JpegFile;
import java.io.EOFException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.CancellationException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.event.IIOReadProgressListener;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/**
 * Decodes pictures with Java's decoders, and turns whatever these throw into {@link
 * ImageFormatException}. Plugins on the class path are not used, so that pictures have the same
 * values everywhere.
 */
public final class JdkDecoder {
  private JdkDecoder() {}

  /** A function that decodes the pixels with a reader whose input is set. */
  @FunctionalInterface
  interface Decoding {
    Pixels from(ImageReader reader) throws IOException;
  }

  public static Pixels decode(JpegFile jpeg) throws ImageFormatException {
    return decode(
        "JPEG",
        jpeg.content(),
        reader ->
            jpeg.components() == 4
                ? jpeg.inks(reader.readRaster(0, null))
                : RasterPixels.of(reader.read(0)));
  }

  static Pixels decode(String format, byte[] content, Decoding decoding)
      throws ImageFormatException {
    ImageReader reader = reader(format);
    List<String> complaints = new ArrayList<>();
    reader.addIIOReadWarningListener((source, warning) -> complaints.add(warning));
    reader.addIIOReadProgressListener(new InterruptListener());
    try (ImageInputStream in =
        new MemoryCacheImageInputStream(Interrupts.over(content, 0, content.length))) {
      reader.setInput(in, true, true);
      Pixels pixels = decoding.from(reader);
      for (String complaint : complaints) {
        if (!isHarmless(complaint)) {
          throw malformed(format + " is damaged" + reason(complaint));
        }
      }
      return pixels;
    } catch (ImageFormatException | CancellationException e) {
      throw e;
    } catch (IOException | RuntimeException | OutOfMemoryError e) {
      // For damaged files, decoders throw exceptions of any kind.
      throw failure(format, e);
    } finally {
      reader.dispose();
    }
  }

  static ImageReader reader(String format) {
    Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName(format);
    while (readers.hasNext()) {
      ImageReader reader = readers.next();
      if (reader.getClass().getModule().equals(ImageIO.class.getModule())) {
        return reader;
      }
    }
    throw new IllegalStateException("Java has no reader of " + format);
  }

  /**
   * Returns whether a warning is about padding between segments, which some cameras write and which
   * is harmless.
   */
  private static boolean isHarmless(String warning) {
    return warning.contains("extraneous bytes before marker");
  }

  /** Returns a decoder's words for a message; empty if they are about Java's classes. */
  private static String reason(String words) {
    return words == null || words.contains("Exception") ? "" : ": " + words;
  }

  private static ImageFormatException failure(String format, Throwable thrown) {
    Throwable cause = thrown;
    while (cause.getCause() != null) {
      cause = cause.getCause();
    }
    if (cause instanceof OutOfMemoryError) {
      // The pixels are a single allocation. If it fails, nothing else is affected.
      return new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE, "the picture does not fit into memory", thrown);
    }
    // The messages of other exceptions are about Java's classes.
    String reason = cause instanceof IOException ? reason(cause.getMessage()) : "";
    String damage = cause instanceof EOFException ? " ends too early" : " is damaged" + reason;
    return new ImageFormatException(ImageFormatException.Kind.MALFORMED, format + damage, thrown);
  }

  /** Ends the decoding of a picture, at the next row or tile, when its thread is interrupted. */
  private static final class InterruptListener implements IIOReadProgressListener {
    @Override
    public void imageProgress(ImageReader source, float percentage) {
      Interrupts.check();
    }

    @Override
    public void sequenceStarted(ImageReader source, int minIndex) {}

    @Override
    public void sequenceComplete(ImageReader source) {}

    @Override
    public void imageStarted(ImageReader source, int index) {}

    @Override
    public void imageComplete(ImageReader source) {}

    @Override
    public void thumbnailStarted(ImageReader source, int index, int thumbnail) {}

    @Override
    public void thumbnailProgress(ImageReader source, float percentage) {}

    @Override
    public void thumbnailComplete(ImageReader source) {}

    @Override
    public void readAborted(ImageReader source) {}
  }
}
