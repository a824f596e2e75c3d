package io.github.lumbre.model.format.threemf;

import io.github.lumbre.model.internal.ModelFixture;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/** Builds 3MF files. Mutable. */
public final class ThreeMfSample {
  static final String MESH =
      """
      <mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
      <vertex x="1" y="1" z="0"/><vertex x="0" y="1" z="0"/></vertices>
      <triangles><triangle v1="0" v2="1" v3="2"%s/><triangle v1="0" v2="2" v3="3"%s/></triangles>
      </mesh>
      """;

  private static final String RELATIONS =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
      <Relationship Target="/Metadata/thumbnail.png" Id="r0" Type="thumbnail"/>
      <Relationship Target="/3D/root.model" Id="r1"
        Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
      </Relationships>
      """;

  private final Map<String, byte[]> parts = new LinkedHashMap<>();

  /** Creates a file with a root part. */
  ThreeMfSample(String root) {
    with("[Content_Types].xml", "<Types/>");
    with("_rels/.rels", RELATIONS);
    with("3D/root.model", root);
  }

  /** Returns a file with one item that shows the object 1. */
  static ThreeMfSample of(String resources) {
    return of(resources, "<item objectid=\"1\"/>");
  }

  static ThreeMfSample of(String resources, String items) {
    return new ThreeMfSample(model(resources, items));
  }

  /** Returns a file with an object of two triangles. */
  public static byte[] square() {
    return of("<object id=\"1\">" + MESH.formatted("", "") + "</object>").bytes();
  }

  /** Returns a file with items only. */
  public static byte[] ofItems(String resources, String items) {
    return of(resources, items).bytes();
  }

  static String model(String resources, String items) {
    return """
    <?xml version="1.0" encoding="UTF-8"?>
    <model unit="millimeter" xml:lang="en-US"
     xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
     xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02"
     xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
     xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"
     xmlns:x="http://example.com/x"><metadata name="Title">A &amp; B</metadata>
    <resources>%s</resources>
    <build>%s</build></model>
    """
        .formatted(resources, items);
  }

  ThreeMfSample with(String name, byte[] bytes) {
    parts.put(name, bytes);
    return this;
  }

  ThreeMfSample with(String name, String text) {
    return with(name, text.getBytes(StandardCharsets.UTF_8));
  }

  ThreeMfSample without(String name) {
    parts.remove(name);
    return this;
  }

  byte[] bytes() {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(out)) {
      for (Map.Entry<String, byte[]> part : parts.entrySet()) {
        zip.putNextEntry(new ZipEntry(part.getKey()));
        zip.write(part.getValue());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toByteArray();
  }

  ModelFixture fixture() {
    return new ModelFixture("a.3mf", bytes());
  }
}
