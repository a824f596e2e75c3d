package io.github.lumbre.model.format.dae;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.format.XmlEncoding;
import io.github.lumbre.model.format.XmlReader;
import io.github.lumbre.model.internal.LengthUnit;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelReach;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/**
 * Reads COLLADA files of versions 1.4 and 1.5, standing still, without physics, kinematics and
 * programs for shaders. The file states its unit, which becomes meters as in glTF, and its axis,
 * unless the options correct them. Stateless.
 */
public final class DaeReader {
  private static final double QUARTER_TURN_DEGREES = 90;

  private DaeReader() {}

  /** Returns whether a file begins like a COLLADA file. */
  public static boolean startsIn(byte[] start, long size) {
    return FileContent.describe(start).equals(Optional.of("COLLADA"));
  }

  /** Returns the content of a COLLADA file. */
  public static Model read(byte[] bytes, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    FormatFile file = new FormatFile(folder, options);
    byte[] utf8 = XmlEncoding.utf8(bytes, options.limits());
    DaeDocument document = DaeParser.parsed(utf8, XmlEncoding.start(utf8), file);
    warnOfVersion(document);
    double unit = options.find(ModelOption.UNIT).orElse(unit(document));
    Transform toWorld = toWorld(document, options, unit);
    DaeScene scene = new DaeScene(document, toWorld, unit);
    List<ModelPart> parts = scene.parts();
    file.tally().addTo(file.warnings());
    return new Model(
        toWorld,
        LengthUnit.nameOf(unit),
        TriangleMesh.Front.NORMALS,
        parts,
        1,
        scene.cameras(),
        List.of(),
        List.of(),
        List.of(),
        file.warnings().all(),
        List.of());
  }

  private static void warnOfVersion(DaeDocument document) {
    String version = document.root().attribute("version");
    if (!version.startsWith("1.4") && !version.startsWith("1.5")) {
      document
          .file()
          .warnings()
          .add(
              document.root().location(),
              "expected version 1.4 or 1.5 of COLLADA, found %s; parts may be missing"
                  .formatted(PrintableText.quoted(version)));
    }
  }

  /** Returns the length of the file's unit in meters. */
  private static double unit(DaeDocument document) {
    Optional<DaeElement> unit = document.root().find("asset", "unit");
    String stated = unit.map(e -> e.attribute("meter").strip()).orElse("");
    if (stated.isEmpty()) {
      return 1;
    }
    double meters = XmlReader.parsed(stated);
    if (meters >= ModelReach.SMALLEST && meters <= ModelReach.LARGEST) {
      return meters;
    }
    document
        .file()
        .warnings()
        .add(
            unit.get().location(),
            "expected a length in meters, found %s; 1 is used"
                .formatted(PrintableText.quoted(stated)));
    return 1;
  }

  private static Transform toWorld(DaeDocument document, ModelOptions options, double unit) {
    String axis = document.root().find("asset", "up_axis").map(DaeElement::text).orElse("Y_UP");
    if (axis.equals("X_UP") && options.find(ModelOption.UP).isEmpty()) {
      return Transform.rotationDegrees(new Vec3(0, 0, QUARTER_TURN_DEGREES))
          .times(Transform.scale(new Vec3(unit, unit, unit)));
    }
    if (!List.of("X_UP", "Y_UP", "Z_UP").contains(axis)) {
      document
          .file()
          .warnings()
          .add(
              document.root().location(),
              "expected X_UP, Y_UP or Z_UP, found %s; Y_UP is used"
                  .formatted(PrintableText.quoted(axis)));
    }
    return options.toWorld(axis.equals("Z_UP") ? Up.Z : Up.Y, unit);
  }
}
