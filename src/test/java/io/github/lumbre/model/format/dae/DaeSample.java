package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.internal.ModelFixture;

/** Builds COLLADA files. */
public final class DaeSample {
  /** A square in the plane z = 0, of side 1. */
  static final String SQUARE = source("p", "X Y Z", "0 0 0 1 0 0 1 1 0 0 1 0");

  static final String VERTICES =
      "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>";

  static final String VERTEX = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";

  static final String TRIANGLES =
      "<triangles count=\"2\" material=\"m\">" + VERTEX + "<p>0 1 2 0 2 3</p></triangles>";

  private DaeSample() {}

  /**
   * Returns a source of float numbers.
   *
   * @param names of its components, such as {@code X Y Z}
   */
  static String source(String id, String names, String numbers) {
    StringBuilder params = new StringBuilder();
    for (String name : names.split(" ")) {
      params.append("<param name=\"").append(name).append("\" type=\"float\"/>");
    }
    int count = numbers.isBlank() ? 0 : numbers.strip().split("\\s+").length;
    int stride = names.split(" ").length;
    return """
    <source id="%1$s"><float_array id="%1$s-a" count="%2$d">%3$s</float_array>
    <technique_common><accessor source="#%1$s-a" count="%4$d" stride="%5$d">%6$s</accessor>
    </technique_common></source>
    """
        .formatted(id, count, numbers, count / stride, stride, params);
  }

  /** Returns a library with the geometry g of the content of a mesh. */
  static String geometry(String mesh) {
    return geometry("g", mesh);
  }

  static String geometry(String id, String mesh) {
    return "<library_geometries><geometry id=\"%s\" name=\"shape\"><mesh>%s</mesh></geometry>"
        .formatted(id, mesh)
        + "</library_geometries>";
  }

  /** Returns a library with the square g. */
  static String square() {
    return geometry(SQUARE + VERTICES + TRIANGLES);
  }

  /** Returns libraries with a material a, whose shader has some content. */
  static String material(String shader, String content) {
    return material("a", shader, content);
  }

  static String material(String id, String shader, String content) {
    return """
    <library_effects><effect id="%1$s-fx"><profile_COMMON><technique sid="common"><%2$s>%3$s
    </%2$s></technique></profile_COMMON></effect></library_effects>
    <library_materials><material id="%1$s" name="paint %1$s"><instance_effect url="#%1$s-fx"/>
    </material></library_materials>
    """
        .formatted(id, shader, content);
  }

  /** Returns an instance of the geometry g whose symbol m is the material a. */
  static String instance() {
    return instance("<instance_material symbol=\"m\" target=\"#a\"/>");
  }

  static String instance(String bound) {
    return """
    <instance_geometry url="#g"><bind_material><technique_common>%s</technique_common>
    </bind_material></instance_geometry>
    """
        .formatted(bound);
  }

  /** Returns a file with one node. */
  static String file(String libraries, String node) {
    return file("<unit name=\"meter\" meter=\"1\"/><up_axis>Y_UP</up_axis>", libraries, node);
  }

  static String file(String asset, String libraries, String node) {
    return ofNodes(asset, libraries, "<node id=\"n\" name=\"part\">" + node + "</node>");
  }

  static String ofNodes(String asset, String libraries, String nodes) {
    return """
    <?xml version="1.0" encoding="utf-8"?>
    <COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
    <asset>%s</asset>
    %s
    <library_visual_scenes><visual_scene id="s">%s</visual_scene></library_visual_scenes>
    <scene><instance_visual_scene url="#s"/></scene>
    </COLLADA>
    """
        .formatted(asset, libraries, nodes);
  }

  /** Returns a square of side 1, with z up in half meters, and a camera that looks away from it. */
  public static String squareWithCamera() {
    String camera =
        """
        <library_cameras><camera id="k"><optics><technique_common><perspective><yfov>30</yfov>
        </perspective></technique_common></optics></camera></library_cameras>
        """;
    String nodes =
        """
        <node name="away"><lookat>0 0 5 0 0 9 0 1 0</lookat><instance_camera url="#k"/></node>
        <node><instance_geometry url="#g"/></node>
        """;
    return ofNodes("<unit meter=\"0.5\"/><up_axis>Z_UP</up_axis>", square() + camera, nodes)
        .replace(" material=\"m\"", "");
  }

  static ModelFixture fixture(String text) {
    return new ModelFixture("a.dae", text);
  }

  /** Returns a file whose geometry has some content of a mesh, without a material. */
  static ModelFixture mesh(String mesh) {
    return fixture(file(geometry(mesh), "<instance_geometry url=\"#g\"/>"));
  }
}
