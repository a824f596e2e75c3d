package io.github.lumbre.image.format.jpeg;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.DisplayPicture;
import io.github.lumbre.image.internal.DisplayRows;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.imageio.IIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Writes baseline JPEG files with exposure and tone curve applied: 8 bits, no chroma subsampling
 * (4:4:4), metadata as a comment. JPEG has no alpha, so the picture is written over black. A
 * quantized copy takes 3 bytes of memory per pixel during writing.
 */
public final class JpegWriter {
  private static final String METADATA = "javax_imageio_jpeg_image_1.0";
  private static final int MAX_COMMENT = 65000;

  private JpegWriter() {}

  public static void write(Image image, ImageWriter.Options options, OutputStream out)
      throws IOException {
    ImageWriter.Options rounded = options.withDither(Optional.empty());
    BufferedImage picture = DisplayPicture.of(DisplayRows.of(image, rounded, 8, false));
    javax.imageio.ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      ImageWriteParam param = writer.getDefaultWriteParam();
      param.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
      param.setCompressionQuality(options.jpegQuality() / 100f);
      IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(picture), param);
      metadata.mergeTree(METADATA, markers(image, options.metadata()));
      writer.write(null, new IIOImage(picture, null, metadata), param);
    } catch (IIOException e) {
      // The exception's own message is empty; the message of its cause is "No space left on
      // device".
      throw e.getCause() instanceof IOException cause ? cause : e;
    } finally {
      writer.dispose();
    }
  }

  /** Returns the metadata that the encoder's defaults lack: sampling factors and a comment. */
  private static IIOMetadataNode markers(Image image, Map<String, String> metadata) {
    IIOMetadataNode frame = node("sof", "process", 0, "samplePrecision", 8);
    frame.setAttribute("numLines", "" + image.height());
    frame.setAttribute("samplesPerLine", "" + image.width());
    frame.setAttribute("numFrameComponents", "3");
    for (int component = 1; component <= 3; component++) {
      IIOMetadataNode spec = node("componentSpec", "HsamplingFactor", 1, "VsamplingFactor", 1);
      spec.setAttribute("componentId", "" + component);
      spec.setAttribute("QtableSelector", component == 1 ? "0" : "1");
      frame.appendChild(spec);
    }
    IIOMetadataNode sequence = new IIOMetadataNode("markerSequence");
    sequence.appendChild(frame);
    if (!metadata.isEmpty()) {
      IIOMetadataNode comment = new IIOMetadataNode("com");
      comment.setUserObject(comment(metadata));
      sequence.appendChild(comment);
    }
    IIOMetadataNode root = new IIOMetadataNode(METADATA);
    root.appendChild(new IIOMetadataNode("JPEGvariety"));
    root.appendChild(sequence);
    return root;
  }

  private static IIOMetadataNode node(String name, String key, int value, String key2, int value2) {
    IIOMetadataNode node = new IIOMetadataNode(name);
    node.setAttribute(key, "" + value);
    node.setAttribute(key2, "" + value2);
    return node;
  }

  /**
   * Returns one line per keyword, as UTF-8 bytes. If it were passed as text, the encoder would use
   * the default character set.
   */
  private static byte[] comment(Map<String, String> metadata) {
    String lines =
        metadata.entrySet().stream()
            .map(e -> e.getKey() + ": " + e.getValue())
            .collect(Collectors.joining("\n"));
    byte[] bytes = lines.getBytes(StandardCharsets.UTF_8);
    return Arrays.copyOf(bytes, Math.min(bytes.length, MAX_COMMENT));
  }
}
