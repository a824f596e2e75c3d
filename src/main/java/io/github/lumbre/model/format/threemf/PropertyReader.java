package io.github.lumbre.model.format.threemf;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.MtlMap;
import io.github.lumbre.model.format.XmlReader;
import io.github.lumbre.model.format.threemf.PropertyGroup.Kind;
import io.github.lumbre.model.internal.MaterialInput;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.ModelTexture.Wrap;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.UvTransform;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads the resources that are properties: base materials, and of the materials and properties
 * extension colors, textures, composite materials and layers. Mutable.
 */
final class PropertyReader {
  private static final long PROPERTY_BYTES = 150;

  private final XmlReader xml;
  private final ThreeMfFile file;
  private final Map<Integer, PropertyGroup> groups = new HashMap<>();

  /** The materials of textures by the ids of these. */
  private final Map<Integer, ModelMaterial> textures = new HashMap<>();

  PropertyReader(XmlReader xml, ThreeMfFile file) {
    this.xml = xml;
    this.file = file;
  }

  /** Returns the groups of properties by their ids. */
  Map<Integer, PropertyGroup> groups() {
    return groups;
  }

  /**
   * Reads the resource at which the reader is; returns false if it is none of these. Some programs
   * write elements of the extension without its prefix, as elements of the core.
   */
  boolean read() throws ModelFormatException, IOException {
    boolean isCore = xml.namespace().equals(ThreeMfExtensions.CORE);
    if (!isCore && !xml.namespace().equals(ThreeMfExtensions.MATERIALS)) {
      return false;
    }
    switch (xml.name()) {
      case "basematerials" -> readColors(Kind.MATERIAL, "base", "displaycolor");
      case "colorgroup" -> readColors(Kind.COLOR, "color", "color");
      case "texture2d" -> readTexture();
      case "texture2dgroup" -> readCoordinates();
      case "compositematerials" -> readComposites();
      case "multiproperties" -> readLayers();
      default -> {
        if (isCore) {
          return false;
        }
        file.warnings()
            .once(
                xml.name(),
                xml.location(),
                PrintableText.shortened(xml.name()) + " has no effect on the picture");
      }
    }
    return true;
  }

  /** Returns whether an element of a group is a property, with or without its prefix. */
  private boolean isProperty(String name) {
    return xml.is(ThreeMfExtensions.MATERIALS, name) || xml.is(ThreeMfExtensions.CORE, name);
  }

  private PropertyGroup group(Kind kind, ModelMaterial textured) throws ModelFormatException {
    int id = xml.integer("id", Integer.MAX_VALUE);
    String location = xml.part() + " group " + id;
    return put(id, new PropertyGroup(kind, location, textured));
  }

  private PropertyGroup put(int id, PropertyGroup group) throws ModelFormatException {
    if (groups.put(id, group) != null) {
      throw xml.error("expected ids of one resource each, found several with " + id);
    }
    return group;
  }

  private PropertyGroup known(String attribute) throws ModelFormatException {
    int id = xml.integer(attribute, Integer.MAX_VALUE);
    PropertyGroup group = groups.get(id);
    if (group == null) {
      throw xml.error("expected a group that is defined before, found " + attribute + " " + id);
    }
    return group;
  }

  private void readColors(Kind kind, String element, String attribute) throws ModelFormatException {
    PropertyGroup group = group(kind, PlainModel.defaultMaterial());
    int depth = xml.depth();
    while (xml.nextWithin(depth)) {
      if (isProperty(element)) {
        file.take(xml.location(), PROPERTY_BYTES);
        group.add(xml.text("name").orElse(""), color(attribute));
      }
    }
  }

  /** Returns a linear color with alpha; light gray, with a warning, for a wrong one. */
  private double[] color(String attribute) {
    String text = xml.text(attribute).orElse("").trim();
    if (!text.matches("#(\\p{XDigit}{6}|\\p{XDigit}{8})")) {
      file.warnings()
          .add(
              "a color is wrong",
              xml.location(),
              "expected a color such as #FF8000 in %s, found %s; light gray is used"
                  .formatted(attribute, PrintableText.quoted(text)));
      double gray = PlainModel.ALBEDO;
      return new double[] {gray, gray, gray, 1};
    }
    double[] color = {1, 1, 1, 1};
    for (int i = 0; 2 * i + 3 <= text.length(); i++) {
      double encoded = Integer.parseInt(text.substring(2 * i + 1, 2 * i + 3), 16) / 255.;
      color[i] = i == 3 ? encoded : Srgb.decode(encoded);
    }
    return color;
  }

  private void readTexture() throws ModelFormatException, IOException {
    String path = xml.text("path").orElse("");
    boolean isNearest = xml.text("filter").filter("nearest"::equals).isPresent();
    MtlMap map =
        new MtlMap(
            xml.location(),
            path.startsWith("/") ? path.substring(1) : path,
            -1,
            1,
            Wrap.REPEAT,
            UvTransform.IDENTITY);
    ModelMaterial material = PlainModel.defaultMaterial();
    if (file.pictures().isReadable(map, file.warnings())) {
      ModelTexture read = file.pictures().texture(map);
      ModelTexture texture =
          new ModelTexture(
              read.image(),
              0,
              wrap("tilestyleu"),
              wrap("tilestylev"),
              isNearest,
              UvTransform.IDENTITY);
      material =
          PlainModel.matte("", xml.location())
              .set(
                  MaterialParameter.BASE_COLOR,
                  new MaterialInput(Rgb.WHITE, Optional.of(texture), 0))
              .build();
    }
    textures.put(xml.integer("id", Integer.MAX_VALUE), material);
  }

  private Wrap wrap(String attribute) {
    return switch (xml.text(attribute).orElse("wrap")) {
      case "mirror" -> Wrap.MIRROR;
      case "clamp", "none" -> Wrap.CLAMP;
      default -> Wrap.REPEAT;
    };
  }

  private void readCoordinates() throws ModelFormatException {
    int id = xml.integer("texid", Integer.MAX_VALUE);
    if (!textures.containsKey(id)) {
      throw xml.error("expected a texture that is defined before, found texid " + id);
    }
    PropertyGroup group = group(Kind.TEXTURE, textures.get(id));
    int depth = xml.depth();
    while (xml.nextWithin(depth)) {
      if (isProperty("tex2coord")) {
        file.take(xml.location(), PROPERTY_BYTES);
        double u = xml.number("u");
        double v = xml.number("v");
        boolean isFinite = Double.isFinite(u + v);
        group.add("", isFinite ? u : 0, isFinite ? v : 0);
      }
    }
  }

  /** Reads mixtures of base materials as the mixtures of their colors, in linear light. */
  private void readComposites() throws ModelFormatException {
    PropertyGroup base = known("matid");
    List<Integer> mixed = integers("matindices", base.count() - 1L);
    if (base.kind() == Kind.TEXTURE || mixed.isEmpty()) {
      throw xml.error("expected a mixture of materials, found none");
    }
    file.warnings()
        .once("mixtures", xml.location(), "composite materials are shown as mixed colors");
    PropertyGroup group = group(Kind.COLOR, PlainModel.defaultMaterial());
    int depth = xml.depth();
    while (xml.nextWithin(depth)) {
      if (isProperty("composite")) {
        file.take(xml.location(), PROPERTY_BYTES);
        group.add("", mixture(base, mixed));
      }
    }
  }

  private double[] mixture(PropertyGroup base, List<Integer> mixed) throws ModelFormatException {
    TextScanner shares = xml.words("values");
    double[] sum = new double[4];
    double total = 0;
    for (int index : mixed) {
      double share = shares.nextWord() ? share(shares) : 0;
      total += share;
      double[] color = base.numbers(index);
      for (int i = 0; i < sum.length; i++) {
        sum[i] += share * color[i];
      }
    }
    for (int i = 0; total > 0 && i < sum.length; i++) {
      sum[i] = Math.min(sum[i] / total, 1);
    }
    return total > 0 ? sum : base.numbers(mixed.get(0));
  }

  /** Returns the current word as a share from 0 to 1; the nearest one, or 0, for a wrong one. */
  private double share(TextScanner word) {
    double stated = Double.NaN;
    try {
      stated = word.number();
    } catch (ModelFormatException e) {
      // Below, a warning names the word.
    }
    double share = stated > 0 ? Math.min(stated, 1) : 0;
    if (share != stated) {
      file.warnings()
          .add(
              "a share of a mixture is wrong",
              xml.location(),
              "expected shares from 0 to 1 in values, found %s; %s is used"
                  .formatted(
                      PrintableText.quoted(word.name()), PrintableText.number(share)));
    }
    return share;
  }

  /** Reads layers of properties; the top one is shown. */
  private void readLayers() throws ModelFormatException {
    List<Integer> ids = integers("pids", Integer.MAX_VALUE);
    int top = ids.size() - 1;
    while (top >= 0 && !groups.containsKey(ids.get(top))) {
      top--;
    }
    if (top < 0) {
      throw xml.error("expected a group that is defined before in pids, found none");
    }
    file.warnings()
        .once("layers", xml.location(), "of several layers of properties, the top one is shown");
    PropertyGroup shown = groups.get(ids.get(top));
    PropertyGroup group = put(xml.integer("id", Integer.MAX_VALUE), shown.like());
    int depth = xml.depth();
    while (xml.nextWithin(depth)) {
      if (isProperty("multi")) {
        file.take(xml.location(), PROPERTY_BYTES);
        List<Integer> indices = integers("pindices", Integer.MAX_VALUE);
        int index = top < indices.size() ? indices.get(top) : 0;
        if (index >= shown.count()) {
          throw xml.error(
              "expected a property from 0 to " + (shown.count() - 1) + ", found " + index);
        }
        group.addFrom(shown, index);
      }
    }
  }

  private List<Integer> integers(String attribute, long max) throws ModelFormatException {
    TextScanner words = xml.words(attribute);
    List<Integer> all = new ArrayList<>();
    while (words.nextWord()) {
      all.add((int) words.integer(0, max));
    }
    return all;
  }
}
