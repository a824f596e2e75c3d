package io.github.lumbre.model.format.threemf;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.format.XmlReader;
import io.github.lumbre.model.format.ZipInput;
import io.github.lumbre.model.format.threemf.ThreeMfObject.Component;
import io.github.lumbre.model.format.threemf.ThreeMfObject.Surface;
import io.github.lumbre.model.internal.LengthUnit;
import io.github.lumbre.model.internal.TextScanner;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The objects and build items of a model part (3MF core specification 1.3, chapters 3 to 5). The
 * root part may use objects of other parts (production extension 1.1). Mutable.
 */
final class ModelDocument {
  private static final Set<String> SHOWN = Set.of("model", "surface");

  private final XmlReader xml;
  private final ThreeMfFile file;

  /** The objects of other parts, by the names of these; empty in a part that may use none. */
  private final Optional<Map<String, Map<Integer, ThreeMfObject>>> others;

  private final Map<Integer, ThreeMfObject> objects = new HashMap<>();
  private final List<Component> items = new ArrayList<>();
  private final PropertyReader properties;
  private LengthUnit unit = LengthUnit.MILLIMETER;

  private ModelDocument(ZipInput in, ThreeMfFile file, boolean isRoot) {
    xml = new XmlReader(in);
    this.file = file;
    others = isRoot ? Optional.of(new HashMap<>()) : Optional.empty();
    properties = new PropertyReader(xml, file);
  }

  /**
   * Reads the model of a part.
   *
   * @param location of the reference to it, for messages
   * @param isRoot whether it may use other parts
   */
  static ModelDocument read(ThreeMfFile file, String part, String location, boolean isRoot)
      throws ModelFormatException, IOException {
    try (ZipInput in = file.parts().open(part, location)) {
      ModelDocument document = new ModelDocument(in, file, isRoot);
      document.read();
      return document;
    }
  }

  /** Returns what is built, in meters and with z up. */
  List<Component> items() {
    return items;
  }

  LengthUnit unit() {
    return unit;
  }

  private void read() throws ModelFormatException, IOException {
    if (!xml.nextWithin(0) || !xml.is(ThreeMfExtensions.CORE, "model")) {
      throw xml.error("expected a <model> of 3MF, found something else");
    }
    ThreeMfExtensions.check(xml);
    unit = readUnit();
    while (xml.nextWithin(1)) {
      if (xml.is(ThreeMfExtensions.CORE, "resources")) {
        readResources();
      } else if (xml.is(ThreeMfExtensions.CORE, "build")) {
        while (xml.nextWithin(2)) {
          if (xml.is(ThreeMfExtensions.CORE, "item")) {
            addPlaced(items);
          }
        }
      } else {
        ThreeMfExtensions.warnOf(xml, file.warnings());
      }
    }
  }

  private LengthUnit readUnit() throws ModelFormatException {
    String name = xml.text("unit").orElse(LengthUnit.MILLIMETER.title());
    return LengthUnit.named(name)
        .orElseThrow(
            () ->
                xml.error(
                    "expected micron, millimeter, centimeter, inch, foot or meter, found unit "
                        + PrintableText.quoted(name)));
  }

  private void readResources() throws ModelFormatException, IOException {
    while (xml.nextWithin(2)) {
      if (xml.is(ThreeMfExtensions.CORE, "object")) {
        readObject();
      } else if (!properties.read()) {
        ThreeMfExtensions.warnOf(xml, file.warnings());
      }
    }
  }

  private void readObject() throws ModelFormatException, IOException {
    int id = xml.integer("id", Integer.MAX_VALUE);
    if (objects.containsKey(id)) {
      throw xml.error("expected ids of one object each, found several with " + id);
    }
    String name = xml.text("name").or(() -> xml.text("partnumber")).orElse("");
    String type = xml.text("type").orElse("model");
    int group = xml.has("pid") ? xml.integer("pid", Integer.MAX_VALUE) : -1;
    int property = xml.has("pindex") ? xml.integer("pindex", Integer.MAX_VALUE) : 0;
    List<Surface> surfaces = new ArrayList<>();
    List<Component> components = new ArrayList<>();
    while (xml.nextWithin(3)) {
      if (xml.is(ThreeMfExtensions.CORE, "mesh")) {
        surfaces.addAll(new MeshReader(xml, file, properties.groups(), group, property).read());
      } else if (xml.is(ThreeMfExtensions.CORE, "components")) {
        while (xml.nextWithin(4)) {
          if (xml.is(ThreeMfExtensions.CORE, "component")) {
            addPlaced(components);
          }
        }
      } else {
        ThreeMfExtensions.warnOf(xml, file.warnings());
      }
    }
    String location = xml.part() + " object " + id;
    file.take(location, 100);
    objects.put(id, ThreeMfObject.of(name, type, location, surfaces, components));
  }

  /** Adds the object to which a build item or a component refers, unless it is not shown. */
  private void addPlaced(List<Component> placed) throws ModelFormatException, IOException {
    ThreeMfObject object = referred();
    if (!SHOWN.contains(object.type())) {
      file.warnings()
          .add(
              "objects that are not part of the model",
              object.location(),
              "an object of type " + PrintableText.shortened(object.type()) + " is left out");
      return;
    }
    Transform transform = xml.has("transform") ? transform() : Transform.IDENTITY;
    if (!transform.isInvertible()) {
      file.warnings()
          .add(xml.location(), "its transform is not invertible; its content is left out");
      return;
    }
    file.take(xml.location(), 300);
    placed.add(new Component(object, transform));
  }

  private ThreeMfObject referred() throws ModelFormatException, IOException {
    int id = xml.integer("objectid", Integer.MAX_VALUE);
    Optional<String> path = xml.text(ThreeMfExtensions.PRODUCTION, "path");
    ThreeMfObject object = (path.isPresent() ? objectsOf(path.get()) : objects).get(id);
    if (object == null) {
      throw xml.error("expected an object that is defined before, found objectid " + id);
    }
    return object;
  }

  private Map<Integer, ThreeMfObject> objectsOf(String path)
      throws ModelFormatException, IOException {
    if (others.isEmpty()) {
      throw Kind.UNSUPPORTED.at(
          xml.location(),
          "expected a path to another part in the root part only, found "
              + PrintableText.quoted(path));
    }
    Map<Integer, ThreeMfObject> known = others.get().get(path);
    if (known == null) {
      known = read(file, path, xml.location(), false).objects;
      others.get().put(path, known);
    }
    return known;
  }

  /** Returns a transform whose rows are the images of the axes and of the origin. */
  private Transform transform() throws ModelFormatException {
    TextScanner words = xml.words("transform");
    Vec3[] rows = new Vec3[4];
    for (int i = 0; i < rows.length; i++) {
      rows[i] = new Vec3(number(words), number(words), number(words));
    }
    return Transform.ofAxes(rows[0], rows[1], rows[2], rows[3]);
  }

  private double number(TextScanner words) throws ModelFormatException {
    if (!words.nextWord()) {
      throw xml.error("expected 12 numbers in transform, found fewer");
    }
    return words.number();
  }
}
