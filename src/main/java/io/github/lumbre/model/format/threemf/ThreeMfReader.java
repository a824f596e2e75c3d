package io.github.lumbre.model.format.threemf;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.model.format.XmlReader;
import io.github.lumbre.model.format.ZipInput;
import io.github.lumbre.model.format.ZipParts;
import io.github.lumbre.model.format.threemf.ThreeMfObject.Component;
import io.github.lumbre.model.internal.LengthUnit;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Reads 3MF files (3MF core specification 1.3) with the materials and properties extension and the
 * production extension. The file states its unit, which becomes meters as in glTF, and z points up,
 * unless the options correct them. Triangles are flat. Stateless.
 */
public final class ThreeMfReader {
  private static final String RELATIONS = "_rels/.rels";
  private static final String RELATION_TYPE =
      "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
  private static final String USUAL_ROOT = "3D/3dmodel.model";

  /** The part of an archive's end that is searched for the name of a model part. */
  private static final int DIRECTORY_BYTES = 1 << 16;

  private ThreeMfReader() {}

  /** Returns whether a file begins like a 3MF file, or its directory names a model. */
  public static boolean startsIn(byte[] start, long size) {
    String found = FileContent.describe(start).orElse("");
    return found.startsWith("3MF")
        || found.equals("a ZIP archive") && start.length == size && endNamesModel(start);
  }

  private static boolean endNamesModel(byte... file) {
    int from = Math.max(0, file.length - DIRECTORY_BYTES);
    String end = new String(file, from, file.length - from, StandardCharsets.ISO_8859_1);
    return end.contains(".model");
  }

  /** Returns the content of a 3MF file. */
  public static Model read(byte[] bytes, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    ThreeMfFile file = new ThreeMfFile(ZipParts.of(bytes, options.limits()), options);
    ModelDocument root = ModelDocument.read(file, root(file.parts()), "", true);
    double unit = root.unit().meters();
    Transform toWorld = options.toWorld(Up.Z, unit);
    long count = 0;
    for (Component item : root.items()) {
      count += item.object().parts();
      ModelLimits.require("", "parts", ModelLimits.MAX_PARTS, count);
    }
    List<ModelPart> parts = new ArrayList<>();
    for (Component item : root.items()) {
      item.object().addTo(parts, toWorld.times(item.toParent()), Optional.empty());
    }
    file.tally().addTo(file.warnings());
    return PlainModel.of(parts, file.warnings().all())
        .from(toWorld, LengthUnit.nameOf(options.find(ModelOption.UNIT).orElse(unit)));
  }

  /** Returns the name of the part with the model, by the relations of the archive. */
  private static String root(ZipParts parts) throws ModelFormatException {
    if (parts.has(RELATIONS)) {
      try (ZipInput in = parts.open(RELATIONS, "")) {
        XmlReader xml = new XmlReader(in);
        while (xml.nextWithin(xml.depth() == 0 ? 0 : 1)) {
          if (xml.text("Type").filter(RELATION_TYPE::equals).isPresent()) {
            return xml.text("Target").orElse("");
          }
        }
      }
    }
    if (parts.has(USUAL_ROOT)) {
      return USUAL_ROOT;
    }
    throw Kind.MALFORMED.at("", "expected an archive with a 3D model, found one without");
  }
}
