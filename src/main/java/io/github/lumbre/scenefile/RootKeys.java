package io.github.lumbre.scenefile;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scenefile.internal.CameraKeys;
import java.util.List;

/** The keys of a scene itself; {@code $schema} names the schema for editors. */
final class RootKeys {
  static final Key<Integer> MAIN_CAMERA =
      Key.of(CameraKeys.MAIN_CAMERA, Value.ID, "The id of the camera that the scene is seen by.");
  static final Key<JsonNode> OPTIONS =
      Key.of("renderOptions", Value.other("{'$ref': '#/$defs/renderOptions'}"), "");
  static final Key<JsonNode> ASSETS =
      Key.of(
          "assets",
          Value.other("{'type': ['array', 'null'], 'items': {'$ref': '#/$defs/asset'}}"),
          "");
  static final Key<JsonNode> OBJECTS = Key.of(CameraKeys.OBJECTS, ObjectKeys.LIST, "");

  static final List<Key<?>> ALL =
      List.of(
          Key.of("$schema", Value.other("{}"), ""),
          ObjectKeys.NAME,
          MAIN_CAMERA,
          OPTIONS,
          ASSETS,
          OBJECTS);

  static final int DEFAULT_ANTIALIASING = 2;
  static final int MAX_ANTIALIASING = 16;
  static final Key<Integer> ANTIALIASING =
      Key.integer(
          "antialiasing",
          -1,
          MAX_ANTIALIASING,
          DEFAULT_ANTIALIASING,
          "Ray mode: 2^n samples per pixel, odd n raised by one; -1 is missing.");
  static final Key<JsonNode> BACKGROUND =
      Key.of(
          "background",
          Value.other("{'anyOf': [{'$ref': '#/$defs/color'}, {'const': 'transparent'}]}"),
          "Radiance of a uniform dome, or \"transparent\".");

  static final Key<Rgb> TOP = Key.color("top", "Light at the upper edge of the full frame.");
  static final Key<Rgb> BOTTOM = Key.color("bottom", "Light at the lower edge.");

  static final Key<Vec3> SHADOW_MIN =
      Key.vector(
          "shadowMin",
          Vec3.ZERO,
          "Lower corner of a box, whose contents have a contact shadow on the ground below it.");
  static final Key<Vec3> SHADOW_MAX =
      Key.vector("shadowMax", Vec3.ZERO, "Upper corner of the box.");

  /** The keys of a backplate that is not of one color. */
  static final List<Key<?>> OF_GRADIENTS = List.of(TOP, BOTTOM, SHADOW_MIN, SHADOW_MAX);

  /** The keys of render options that are not settings. */
  static final List<Key<?>> OF_OPTIONS = List.of(ANTIALIASING, BACKGROUND, ObjectKeys.NAME);

  private RootKeys() {}
}
