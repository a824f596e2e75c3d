package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.format.XmlReader;
import io.github.lumbre.model.format.XmlSource;
import io.github.lumbre.model.internal.ModelLimits;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Makes a tree of the elements that have an effect on a picture. Arrays of numbers and indices are
 * streamed, and their stated sizes are not trusted. Mutable.
 */
final class DaeParser {
  /** The most elements within each other. */
  static final int MAX_DEPTH = 1000;

  static final Set<String> PRIMITIVES =
      Set.of("triangles", "polylist", "polygons", "tristrips", "trifans");

  private static final Set<String> INDICES = Set.of("p", "ph", "vcount");

  /** The memory of an element without its texts. */
  private static final long ELEMENT_BYTES = 200;

  private static final long ATTRIBUTE_BYTES = 150;

  private static final List<String> ATTRIBUTES =
      List.of(
          "id", "name", "sid", "url", "source", "semantic", "offset", "set", "symbol", "target",
          "material", "count", "stride", "input_semantic", "input_set", "texture", "texcoord",
          "opaque", "ref", "meter", "version", "bumptype", "convex_hull_of");

  /** Elements with all that is in them, which no picture needs. */
  private static final Set<String> SKIPPED =
      Set.of(
          "library_animation_clips",
          "library_lights",
          "library_physics_materials",
          "library_physics_models",
          "library_physics_scenes",
          "library_force_fields",
          "library_kinematics_models",
          "library_kinematics_scenes",
          "library_joints",
          "library_articulated_systems",
          "library_formulas",
          "vertex_weights",
          "evaluate_scene",
          "profile_BRIDGE",
          "profile_CG",
          "profile_GLES",
          "profile_GLES2",
          "profile_GLSL",
          "bool_array",
          "int_array");

  /** Elements whose extra elements are read. */
  private static final Set<String> EXTRAS_OF =
      Set.of(
          "effect", "profile_COMMON", "technique", "texture", "geometry", "mesh", "material",
          "lambert", "phong", "blinn", "constant");

  private final XmlReader xml;
  private final FormatFile file;
  private final int length;
  private final Map<String, DaeElement> byId = new HashMap<>();

  private DaeParser(byte[] utf8, int start, FormatFile file) {
    xml = new XmlReader(XmlSource.of(utf8, start), MAX_DEPTH);
    this.file = file;
    length = utf8.length;
  }

  /**
   * Returns the tree of a text in UTF-8.
   *
   * @param start index of the first byte
   */
  static DaeDocument parsed(byte[] utf8, int start, FormatFile file) throws ModelFormatException {
    DaeParser parser = new DaeParser(utf8, start, file);
    if (!parser.xml.nextWithin(0) || !parser.xml.name().equals("COLLADA")) {
      throw parser.xml.error("expected a <COLLADA> element, found something else");
    }
    DaeElement root = parser.element();
    if (!parser.xml.firstComma().isEmpty()) {
      file.warnings()
          .add(parser.xml.firstComma(), "commas in numbers are taken for decimal points");
    }
    return new DaeDocument(root, key -> Optional.ofNullable(parser.byId.get(key)), file);
  }

  private DaeElement element() throws ModelFormatException {
    int depth = xml.depth();
    DaeElement element = new DaeElement(xml.name(), attributes(), xml.location());
    String id = element.attribute("id");
    if (!id.isEmpty()) {
      byId.putIfAbsent(DaeDocument.key(element.name(), id), element);
    }
    if (element.is("float_array")) {
      element.setNumbers(numbers(element.integer("count", 0)));
    } else {
      String text = xml.text().strip();
      file.take(element.location(), ELEMENT_BYTES + text.length());
      element.setText(text);
    }
    if (PRIMITIVES.contains(element.name())) {
      element.setIndices(new DaeIndices(file));
    }
    while (xml.nextWithin(depth)) {
      addChild(element);
    }
    return element;
  }

  private void addChild(DaeElement parent) throws ModelFormatException {
    String name = xml.name();
    boolean isIndices = parent.indices().isPresent() && INDICES.contains(name);
    if (isIndices) {
      readIndices(name, parent.indices().get());
    } else if (name.equals("library_animations")) {
      warnOfAnimations();
    } else if (!SKIPPED.contains(name)
        && !(name.equals("extra") && !EXTRAS_OF.contains(parent.name()))) {
      parent.add(element());
    }
  }

  private void warnOfAnimations() throws ModelFormatException {
    String location = xml.location();
    if (xml.nextWithin(xml.depth())) {
      file.warnings().once(" animations", location, "animations are left out");
    }
  }

  private void readIndices(String name, DaeIndices indices) throws ModelFormatException {
    int depth = xml.depth();
    if (name.equals("p")) {
      indices.readLoop(xml, false);
    } else if (name.equals("vcount")) {
      indices.readCounts(xml);
    } else {
      while (xml.nextWithin(depth)) {
        if (xml.name().equals("p") || xml.name().equals("h")) {
          indices.readLoop(xml, xml.name().equals("h"));
        }
      }
    }
  }

  private Map<String, String> attributes() throws ModelFormatException {
    Map<String, String> found = Map.of();
    for (String name : ATTRIBUTES) {
      if (xml.has(name)) {
        String value = xml.text(name).orElseThrow();
        found = found.isEmpty() ? new HashMap<>() : found;
        found.put(name, value);
        file.take(xml.location(), ATTRIBUTE_BYTES + value.length());
      }
    }
    return found;
  }

  /**
   * Returns the numbers of the current element; NaN for those that are none.
   *
   * @param expected the stated number of them
   */
  private double[] numbers(int expected) throws ModelFormatException {
    // A number and a space take two bytes.
    double[] numbers = new double[Math.min(expected, length / 2)];
    file.take(xml.location(), (long) Double.BYTES * numbers.length);
    int count = 0;
    while (xml.nextWord()) {
      if (count == numbers.length) {
        ModelLimits.require(xml.location(), "numbers", ModelLimits.MAX_COUNT, count);
        file.take(xml.location(), 2L * Double.BYTES * Math.max(8, count));
        int larger = (int) Math.min(2L * count + 8, 3L * ModelLimits.MAX_COUNT);
        numbers = Arrays.copyOf(numbers, larger);
      }
      numbers[count] = xml.wordNumber();
      if (Double.isNaN(numbers[count])) {
        file.tally().add("expected finite numbers, found other words", xml.wordLocation());
      }
      count++;
    }
    return count == numbers.length ? numbers : Arrays.copyOf(numbers, count);
  }
}
