package io.github.lumbre.cli;

import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.List;
import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilderFactory;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/**
 * A drawing as an XML parser reads it.
 *
 * @param root its outermost element
 * @param lines all paths with lines, in their order
 */
record SvgFile(Element root, List<Line> lines) {
  /**
   * A path.
   *
   * @param part the id of the group around its layer
   * @param title of this group
   * @param kind class of its layer
   * @param points x and y of each point; the first one is not repeated
   */
  record Line(String part, String title, String kind, List<double[]> points, boolean isClosed) {
    double x(int i) {
      return points.get(i)[0];
    }

    double y(int i) {
      return points.get(i)[1];
    }
  }

  static SvgFile of(byte[] file) throws Exception {
    DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
    factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
    factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
    Document document = factory.newDocumentBuilder().parse(new ByteArrayInputStream(file));
    List<Line> lines = new ArrayList<>();
    for (Element path : elements(document.getDocumentElement(), "path")) {
      Element layer = (Element) path.getParentNode();
      if (layer.hasAttribute("class")) {
        lines.add(line(path, layer, (Element) layer.getParentNode()));
      }
    }
    return new SvgFile(document.getDocumentElement(), lines);
  }

  static List<Element> elements(Element root, String name) {
    List<Element> found = new ArrayList<>();
    for (int i = 0; i < root.getElementsByTagName(name).getLength(); i++) {
      found.add((Element) root.getElementsByTagName(name).item(i));
    }
    return found;
  }

  private static Line line(Element path, Element layer, Element group) {
    String data = path.getAttribute("d");
    List<double[]> points = new ArrayList<>();
    String[] numbers = data.replaceAll("[MLZ]", " ").strip().split(" +");
    for (int i = 0; i < numbers.length; i += 2) {
      points.add(
          new double[] {Double.parseDouble(numbers[i]), Double.parseDouble(numbers[i + 1])});
    }
    Node title = group.getElementsByTagName("title").item(0);
    return new Line(
        group.getAttribute("id"),
        title == null ? "" : title.getTextContent(),
        layer.getAttribute("class"),
        points,
        data.endsWith("Z"));
  }

  List<Line> lines(String kind) {
    return lines.stream().filter(line -> line.kind.equals(kind)).toList();
  }
}
