package io.github.lumbre.model.format.obj;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.MtlMap;
import io.github.lumbre.model.format.ObjTextures;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFiles;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.Warnings;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * Reads Wavefront OBJ with its material libraries. Each material of each object is a part; if no
 * {@code o} statement precedes a face, its group is its object. In a file of nothing but vertices,
 * these are points. Not reusable.
 */
public final class ObjModelReader {
  private static final int MAX_LIBRARIES = 100;
  private static final Pattern VERTEX = Pattern.compile("(?m)^\\s*v\\s+[-+.\\d]");

  /** Statements that the beginning of a file may have. */
  private static final Set<String> STATEMENTS =
      Set.of("v", "vt", "vn", "vp", "f", "l", "p", "o", "g", "s", "usemtl", "mtllib");

  /** Statements that have no effect on polygons. */
  private static final Set<String> IGNORED =
      Set.of(
          "vp",
          "lod",
          "bevel",
          "c_interp",
          "d_interp",
          "shadow_obj",
          "trace_obj",
          "mg",
          "usemap",
          "maplib",
          "end",
          "sp",
          "ctech",
          "stech",
          "deg",
          "bmat",
          "step",
          "cstype",
          "parm",
          "trim",
          "hole",
          "scrv",
          "con");

  /** The key of a part; names are empty if there are none. */
  private record Key(String object, String material, boolean isOfPoints) {}

  /** A part with its place in the file, and the place of its material's name. */
  private record Part(String location, String materialLocation, ObjSurface surface) {}

  private final TextScanner scanner;
  private final ObjFaces faces;
  private final ModelFiles folder;
  private final ModelOptions options;
  private final Warnings warnings;
  private final Map<Key, Part> parts = new LinkedHashMap<>();
  private final Map<String, ModelNode> nodes = new HashMap<>();
  private final Map<String, String> libraries = new LinkedHashMap<>();
  private final ObjSurface none = new ObjSurface(0);
  private String object = "";
  private boolean hasObjects;
  private boolean hasLines;
  private String material = "";
  private String materialLocation = "";
  private ObjSurface surface = none;

  /** The points of the current object and material. */
  private ObjSurface points = none;

  private ObjModelReader(byte[] text, ModelFolder folder, ModelOptions options, Warnings warnings)
      throws ModelFormatException {
    this.warnings = warnings;
    scanner = new TextScanner(text);
    faces = new ObjFaces(scanner, ObjCensus.of(text, options.limits()), true);
    this.folder = new ModelFiles(folder, options.limits(), warnings);
    this.options = options;
  }

  /**
   * Returns whether the whole lines at the beginning of a file are statements, and one states a
   * vertex.
   */
  public static boolean startsIn(byte[] start, long size) {
    String text = FileContent.text(start);
    String whole = text.substring(0, Math.max(0, text.lastIndexOf('\n')));
    return VERTEX.matcher(whole).find()
        && whole
            .lines()
            .map(String::strip)
            .filter(line -> !line.isEmpty() && line.charAt(0) != '#')
            .allMatch(line -> STATEMENTS.contains(line.split("\\s", 2)[0]));
  }

  /** Returns the content of an OBJ file. */
  public static Model read(byte[] text, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    Warnings warnings = new Warnings();
    byte[] utf8 = Utf16.decoded(text, "", options.limits(), warnings);
    return new ObjModelReader(utf8, folder, options, warnings).read();
  }

  private Model read() throws ModelFormatException, IOException {
    while (scanner.hasMore()) {
      if (scanner.nextWord()) {
        readLine();
      }
      scanner.endLine();
    }
    if (parts.isEmpty() && !hasLines) {
      faces.addAllTo(currentSurface(true));
    }
    faces.finish(warnings);
    List<ModelPart> result = new ArrayList<>();
    Map<String, ModelMaterial> materials = readMaterials();
    for (Map.Entry<Key, Part> entry : parts.entrySet()) {
      addPart(entry.getKey(), entry.getValue(), materials, result);
    }
    return PlainModel.of(result, warnings.all());
  }

  private void readLine() throws ModelFormatException {
    if (scanner.wordIs("f") && surface == none) {
      surface = currentSurface(false);
    } else if (scanner.wordIs("p") && points == none) {
      points = currentSurface(true);
    }
    if (scanner.wordIs("p")) {
      faces.readPoints(points);
    } else if (!faces.read(surface)) {
      readState();
    }
  }

  private void readState() throws ModelFormatException {
    String location = scanner.location();
    switch (scanner.word()) {
      case "o" -> {
        hasObjects = true;
        use(scanner.remainingWords(), material);
      }
      case "g" -> {
        String group = scanner.remainingWords();
        use(hasObjects ? object : group, material);
      }
      case "usemtl" -> {
        materialLocation = location;
        use(object, scanner.remainingWords());
      }
      case "mtllib" -> addLibraries(location);
      case "s" -> faces.smooth(smoothingGroup());
      case "l", "curv", "curv2", "surf" -> {
        hasLines = true;
        warnings.once(
            scanner.word(),
            location,
            "ignored statements \""
                + scanner.word()
                + "\": only polygons and points are supported");
      }
      default -> {
        String word = scanner.word();
        if (!IGNORED.contains(word)) {
          warnings.once(
              word, location, "ignored the unknown statement " + PrintableText.quoted(word));
        }
      }
    }
  }

  private void use(String newObject, String newMaterial) {
    object = newObject;
    material = newMaterial;
    surface = none;
    points = none;
  }

  /** Returns the smoothing group; 0 for "off". */
  private int smoothingGroup() throws ModelFormatException {
    return !scanner.nextWord() || scanner.wordIs("off")
        ? 0
        : (int) scanner.integer(0, Integer.MAX_VALUE);
  }

  /**
   * Adds the names of a line; a name has spaces if a later word ends with .mtl, and it does not.
   */
  private void addLibraries(String location) throws ModelFormatException {
    String name = "";
    while (scanner.nextWord()) {
      name = name.isEmpty() ? scanner.name() : name + " " + scanner.name();
      if (name.regionMatches(true, name.length() - 4, ".mtl", 0, 4)) {
        libraries.putIfAbsent(MtlMap.portable(name), location);
        name = "";
      }
    }
    if (!name.isEmpty()) {
      libraries.putIfAbsent(MtlMap.portable(name), location);
    }
    scanner.require("material libraries", MAX_LIBRARIES, libraries.size());
  }

  private ObjSurface currentSurface(boolean isOfPoints) throws ModelFormatException {
    Key key = new Key(object, material, isOfPoints);
    if (!parts.containsKey(key) && parts.size() >= ModelLimits.MAX_PARTS) {
      warnings.once(
          " parts",
          scanner.location(),
          "joined further objects into one, since there are " + ModelLimits.MAX_PARTS + " parts");
      key = new Key("", material, isOfPoints);
      if (!parts.containsKey(key)) {
        int materials = parts.size() + 1 - ModelLimits.MAX_PARTS;
        scanner.require("materials", ModelLimits.MAX_PARTS, materials);
      }
    }
    return parts
        .computeIfAbsent(
            key, k -> new Part(scanner.location(), materialLocation, new ObjSurface(4)))
        .surface();
  }

  private Map<String, ModelMaterial> readMaterials() throws ModelFormatException, IOException {
    Set<String> used = new HashSet<>();
    parts.keySet().forEach(key -> used.add(key.material()));
    Map<String, ModelMaterial> materials = new LinkedHashMap<>();
    ObjTextures textures = new ObjTextures(folder, options.limits());
    for (Map.Entry<String, String> library : libraries.entrySet()) {
      byte[] text;
      try {
        text =
            Utf16.decoded(
                folder.read(library.getKey(), library.getValue()),
                library.getValue(),
                options.limits(),
                warnings);
      } catch (ModelFormatException e) {
        if (e.kind() != Kind.ASSET) {
          throw e;
        }
        warnings.add("a material library is missing", e.location(), e.detail());
        continue;
      }
      for (MtlMaterial read : MtlReader.read(text, library.getKey(), warnings)) {
        if (used.contains(read.name()) && !materials.containsKey(read.name())) {
          materials.put(read.name(), new MtlConversion(read, textures, warnings).material());
        }
      }
    }
    return materials;
  }

  private void addPart(
      Key key, Part part, Map<String, ModelMaterial> materials, List<ModelPart> result) {
    if (key.isOfPoints()) {
      addPoints(key, part, materials, result);
      return;
    }
    ObjMesh mesh = faces.mesh(part.surface());
    int dropped = part.surface().triangles().removeFlat(mesh.positions());
    if (dropped > 0) {
      warnings.add(
          "triangles of zero area", part.location(), "dropped triangles of zero area: " + dropped);
    }
    if (part.surface().triangles().count() == 0) {
      return;
    }
    Optional<ModelMaterial> found = material(key, part, materials);
    float[] colors = colors(part, found);
    double[] empty = {};
    ModelGeometry geometry =
        new ModelGeometry(
            mesh.positions(),
            mesh.normals(),
            empty,
            mesh.uvs(),
            empty,
            colors,
            part.surface().triangles().toArray());
    ModelMaterial shown = found.orElse(PlainModel.material(colors));
    result.add(
        new ModelPart(node(key.object()), part.location(), geometry, shown, options.toWorld()));
  }

  /** Returns the part of an object; without any, the file is not divided. */
  private ModelNode node(String name) {
    return nodes.computeIfAbsent(
        name,
        n ->
            parts.keySet().stream().allMatch(key -> key.object().isEmpty())
                ? ModelNode.undivided(n)
                : ModelNode.of(n, "unnamed", Optional.empty()));
  }

  private Optional<ModelMaterial> material(
      Key key, Part part, Map<String, ModelMaterial> materials) {
    ModelMaterial found = materials.get(key.material());
    if (found == null && !part.materialLocation().isEmpty()) {
      warnings.once(
          " material " + key.material(),
          part.materialLocation(),
          "expected a material of a library, found "
              + PrintableText.quoted(key.material())
              + ", which is replaced by light gray");
    }
    return Optional.ofNullable(found);
  }

  private float[] colors(Part part, Optional<ModelMaterial> found) {
    return faces.colors(part.surface(), found.isEmpty() ? PlainModel.ALBEDO : 1);
  }

  private void addPoints(
      Key key, Part part, Map<String, ModelMaterial> materials, List<ModelPart> result) {
    Optional<ModelMaterial> found = material(key, part, materials);
    float[] colors = colors(part, found);
    double[] none = {};
    double[] positions = faces.positions(part.surface());
    ModelGeometry points = ModelGeometry.ofPoints(positions, none, none, colors).points();
    int broken = positions.length / 3 - points.vertexCount();
    if (broken > 0) {
      warnings.add(part.location(), "left out points that are not finite numbers: " + broken);
    }
    if (points.isVisible()) {
      ModelMaterial shown = found.orElse(PlainModel.material(colors));
      result.add(
          new ModelPart(node(key.object()), part.location(), points, shown, options.toWorld()));
    }
  }
}
