package io.github.lumbre.image.format.svg;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.image.internal.VectorPicture;
import io.github.lumbre.image.internal.VectorPicture.Group;
import io.github.lumbre.image.internal.VectorPicture.Layer;
import io.github.lumbre.image.internal.VectorPicture.Page;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * Writes drawings as SVG 1.1: groups of paths, with titles. Files have no scripts, links, styles
 * and entities. Numbers are decimals of ASCII digits with at most three digits after the point.
 */
public final class SvgWriter {
  /** Numbers are multiples of this part. */
  private static final int PARTS = 1000;

  /** Larger numbers, which no viewer draws right, are limited to this. */
  private static final double MOST = 1e12;

  private static final int FLUSH_CHARACTERS = 1 << 16;

  private final OutputStream out;
  private final Page page;
  private final StringBuilder text = new StringBuilder();

  private SvgWriter(OutputStream out, Page page) {
    this.out = out;
    this.page = page;
  }

  /**
   * Writes a drawing.
   *
   * @throws IOException if the stream cannot be written
   */
  public static void write(VectorPicture picture, OutputStream out) throws IOException {
    SvgWriter writer = new SvgWriter(out, picture.page());
    writer.begin(picture);
    for (Group group : picture.groups()) {
      writer.add(group);
    }
    writer.text.append("</svg>\n");
    writer.flush();
  }

  private void begin(VectorPicture picture) {
    String width = number(page.width());
    String height = number(page.height());
    text.append("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"");
    text.append(width).append(page.unit()).append("\" height=\"");
    text.append(height).append(page.unit());
    text.append("\" viewBox=\"0 0 ").append(width).append(' ').append(height);
    text.append("\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    picture
        .background()
        .ifPresent(
            color ->
                text.append("<rect width=\"%s\" height=\"%s\"".formatted(width, height))
                    .append(" fill=\"%s\"/>\n".formatted(hexadecimal(color))));
  }

  private void add(Group group) throws IOException {
    text.append("<g id=\"").append(group.id()).append("\">\n");
    if (!group.title().isEmpty()) {
      text.append("<title>").append(escaped(group.title())).append("</title>\n");
    }
    for (Layer layer : group.layers()) {
      if (layer.width() > 0) {
        addLines(layer);
      } else {
        addArea(layer);
      }
    }
    text.append("</g>\n");
  }

  private void addLines(Layer layer) throws IOException {
    text.append("<g class=\"").append(layer.kind());
    text.append("\" stroke=\"").append(hexadecimal(layer.color()));
    text.append("\" stroke-width=\"").append(number(layer.width() * page.pixel()));
    if (layer.dash() > 0) {
      text.append("\" stroke-dasharray=\"").append(number(layer.dash() * page.pixel()));
      text.append(' ').append(number(layer.gap() * page.pixel()));
    }
    text.append("\">\n");
    for (double[] path : layer.paths()) {
      text.append("<path d=\"");
      addPath(path);
      text.append("\"/>\n");
      flushIfLong();
    }
    text.append("</g>\n");
  }

  private void addArea(Layer layer) throws IOException {
    text.append("<path class=\"").append(layer.kind());
    text.append("\" fill=\"").append(hexadecimal(layer.color()));
    text.append("\" fill-rule=\"evenodd\" d=\"");
    for (double[] path : layer.paths()) {
      addPath(path);
      flushIfLong();
    }
    text.append("\"/>\n");
  }

  private void addPath(double... path) {
    int last = path.length - 2;
    boolean isClosed =
        last >= 4 && path[0] == path[last] && path[1] == path[last + 1];
    for (int i = 0; i < (isClosed ? last : path.length); i += 2) {
      text.append(i == 0 ? 'M' : i == 2 ? 'L' : ' ');
      text.append(number(page.left() + path[i] * page.pixel())).append(' ');
      text.append(number(page.top() + path[i + 1] * page.pixel()));
    }
    text.append(isClosed ? "Z" : "");
  }

  private void flushIfLong() throws IOException {
    if (text.length() > FLUSH_CHARACTERS) {
      flush();
    }
  }

  private void flush() throws IOException {
    out.write(text.toString().getBytes(StandardCharsets.UTF_8));
    text.setLength(0);
  }

  /** Returns a number with at most three digits after the point, without needless zeros. */
  static String number(double value) {
    long parts = Math.round(Math.max(-MOST, Math.min(value, MOST)) * PARTS);
    String digits = Long.toString(Math.abs(parts) / PARTS);
    long rest = Math.abs(parts) % PARTS;
    String sign = parts < 0 ? "-" : "";
    if (rest == 0) {
      return sign + digits;
    }
    String after = Long.toString(PARTS + rest);
    int end = after.length();
    while (after.charAt(end - 1) == '0') {
      end--;
    }
    return sign + digits + "." + after.substring(1, end);
  }

  private static String hexadecimal(Rgb color) {
    StringBuilder digits = new StringBuilder("#");
    for (double component : List.of(color.r(), color.g(), color.b())) {
      digits.append(Integer.toHexString(0x100 | Srgb.toByte(component)).substring(1));
    }
    return digits.toString();
  }

  /** Returns a text in XML 1.0; characters that it cannot hold become U+FFFD. */
  static String escaped(String text) {
    StringBuilder escaped = new StringBuilder();
    text.codePoints()
        .forEach(
            c -> {
              switch (c) {
                case '&' -> escaped.append("&amp;");
                case '<' -> escaped.append("&lt;");
                case '>' -> escaped.append("&gt;");
                case '"' -> escaped.append("&quot;");
                case '\'' -> escaped.append("&#39;");
                default -> escaped.appendCodePoint(isInXml(c) ? c : 0xfffd);
              }
            });
    return escaped.toString();
  }

  private static boolean isInXml(int c) {
    boolean isPlain = c >= ' ' && c < 0x7f || c >= 0xa0 && c < 0xd800;
    return isPlain || c >= 0xe000 && c < 0xfffe || c >= 0x10000;
  }
}
