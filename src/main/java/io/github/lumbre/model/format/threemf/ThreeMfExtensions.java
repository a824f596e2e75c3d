package io.github.lumbre.model.format.threemf;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.format.XmlReader;
import io.github.lumbre.model.internal.Warnings;
import java.util.Map;
import java.util.Set;

/** The namespaces of the core specification of 3MF and of its extensions. */
final class ThreeMfExtensions {
  static final String CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
  static final String MATERIALS = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02";
  static final String PRODUCTION =
      "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";

  private static final Set<String> READ =
      Set.of(
          CORE,
          MATERIALS,
          PRODUCTION,
          // Sets of triangles for selections, and other parts to choose: without an effect.
          "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
          "http://schemas.3mf.io/3dmanufacturing/productionalternatives/2021/04");

  /** Extensions whose files are shown without what they add. */
  private static final Map<String, String> LEFT_OUT =
      Map.of(
          "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07", "slices",
          "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02", "beam lattices",
          "http://schemas.microsoft.com/3dmanufacturing/beamlattice/balls/2020/07",
              "balls of beam lattices");

  private ThreeMfExtensions() {}

  /**
   * Checks the extensions that a model requires.
   *
   * @param xml at the model
   * @throws ModelFormatException if one is not known
   */
  static void check(XmlReader xml) throws ModelFormatException {
    for (String prefix : xml.text("requiredextensions").orElse("").trim().split("\\s+")) {
      String namespace = xml.namespace(prefix);
      boolean isKnown = READ.contains(namespace) || LEFT_OUT.containsKey(namespace);
      if (!prefix.isEmpty() && !isKnown) {
        throw Kind.UNSUPPORTED.at(
            xml.location(),
            "the extension "
                + (namespace.isEmpty()
                    ? PrintableText.quoted(prefix)
                    : PrintableText.path(namespace))
                + " is required; export the model without it, or to GLB");
      }
    }
  }

  /** Warns of an element that is not read, once for each extension. */
  static void warnOf(XmlReader xml, Warnings warnings) {
    String namespace = xml.namespace();
    if (!READ.contains(namespace)) {
      String what =
          LEFT_OUT.getOrDefault(
              namespace, "elements of the extension " + PrintableText.path(namespace));
      warnings.once(namespace, xml.location(), what + " are left out");
    }
  }
}
