package io.github.lumbre.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A scene that renders very fast: a lit sphere in a corner of two walls, 16x12 pixels. */
public final class TinyScene {
  /** The scene's text, with each object on its own line for replacement by {@link #with}. */
  public static final String JSON =
      """
{"mainCameraId": 1,
 "renderOptions": {"width": 16, "height": 12, "samples": 2, "antialiasing": 1},
 "assets": [
  {"id": 1, "assetType": "Material", "materialType": "Diffuse", "color": {"r": 0.8, "g": 0.6, "b": 0.4}},
  {"id": 2, "assetType": "Material", "materialType": "Reflective"}
 ],
 "objects": [
  {"id": 1, "type": "Camera", "cameraType": "Pinhole", "localPosition": {"x": 0, "y": 1, "z": -4}},
  {"id": 2, "type": "Shape", "shapeType": "Plane", "materialID": 1},
  {"id": 3, "type": "Shape", "shapeType": "Sphere", "materialID": 2, "radius": 1, "localPosition": {"x": 0, "y": 1, "z": 0}},
  {"id": 4, "type": "Shape", "shapeType": "Cube", "materialID": 1, "localPosition": {"x": 0, "y": 0, "z": 4}},
  {"id": 5, "type": "Light", "lightType": "Point", "intensity": 3, "localPosition": {"x": 2, "y": 4, "z": -3}}
 ]}
""";

  private TinyScene() {}

  /** Returns the scene with the first occurrence of a text replaced by another. */
  public static String with(String old, String replacement) {
    int at = JSON.indexOf(old);
    if (at < 0) {
      throw new IllegalArgumentException("the scene does not contain " + old);
    }
    return JSON.substring(0, at) + replacement + JSON.substring(at + old.length());
  }

  /** Returns the scene with one more asset before the others. */
  static String withAsset(String asset) {
    return with("\"assets\": [", "\"assets\": [\n  " + asset + ",");
  }

  /** Returns the scene with lights so bright that some samples are infinite. */
  static String blinding() {
    // One of 16 lights, divided by its selection probability, overflows.
    String light =
        "{\"type\": \"Light\", \"lightType\": \"Directional\", \"intensity\": 1.7e308,"
            + " \"localRotation\": {\"x\": 60, \"y\": 0, \"z\": 0}}, ";
    return with("{\"id\": 5", light.repeat(16) + "{\"id\": 5");
  }

  /** Writes a scene into a directory and returns its file. */
  public static Path write(Path directory, String json) {
    try {
      return Files.writeString(directory.resolve("tiny.json"), json);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
