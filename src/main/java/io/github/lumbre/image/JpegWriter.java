package io.github.lumbre.image;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Map;
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
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;

/**
 * Writes baseline JPEG files: exposure and tone curve, 8 bits, full color resolution (4:4:4),
 * metadata as comments. JPEG has no alpha: the picture is written over black. A whole quantized
 * picture is in memory meanwhile, 3 bytes a pixel.
 */
final class JpegWriter {
  private static final String METADATA = "javax_imageio_jpeg_image_1.0";
  private static final int MAX_COMMENT = 65000;

  private JpegWriter() {}

  static void write(Image image, ImageWriter.Options options, OutputStream out) throws IOException {
    BufferedImage picture = PngWriter.quantised(image, options, 8, false);
    javax.imageio.ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
      writer.setOutput(stream);
      ImageWriteParam param = writer.getDefaultWriteParam();
      param.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
      param.setCompressionQuality(options.jpegQuality() / 100f);
      IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(picture), param);
      metadata.setFromTree(METADATA, changed(metadata.getAsTree(METADATA), options.metadata()));
      writer.write(null, new IIOImage(picture, null, metadata), param);
    } catch (IIOException e) {
      // Its own message says nothing; the cause's is "No space left on device".
      throw e.getCause() instanceof IOException cause ? cause : e;
    } finally {
      writer.dispose();
    }
  }

  private static Node changed(Node root, Map<String, String> metadata) {
    NodeList components = ((Element) root).getElementsByTagName("componentSpec");
    for (int i = 0; i < components.getLength(); i++) {
      Element component = (Element) components.item(i);
      component.setAttribute("HsamplingFactor", "1");
      component.setAttribute("VsamplingFactor", "1");
    }
    if (!metadata.isEmpty()) {
      Node markers = ((Element) root).getElementsByTagName("markerSequence").item(0);
      IIOMetadataNode comment = new IIOMetadataNode("com");
      comment.setAttribute("comment", text(metadata));
      markers.insertBefore(comment, markers.getFirstChild());
    }
    return root;
  }

  /** Returns a line for each keyword, in Latin-1, which is all that the encoder writes. */
  private static String text(Map<String, String> metadata) {
    String lines =
        metadata.entrySet().stream()
            .map(e -> e.getKey() + ": " + e.getValue())
            .collect(Collectors.joining("\n"));
    String latin = lines.replaceAll("[^\\x0a\\x20-\\x7e\\xa1-\\xff]", "?");
    return latin.length() <= MAX_COMMENT ? latin : latin.substring(0, MAX_COMMENT);
  }
}
