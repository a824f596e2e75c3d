package io.github.lumbre.cli.mcp;

import java.util.ArrayList;
import java.util.List;

/** The members of results that are made of a summary, as commands print it. Stateless. */
final class SummaryOutputs {
  static final Output WARNINGS =
      Output.texts("warnings", "What the file has and the picture lacks.");

  static final Output NOTES =
      Output.texts("notes", "Labels without room, and settings of a scene that do not count.");

  private static final Output BOUNDS =
      Output.rows(
          "bounds", 2, 3, "Least and largest coordinates: +Y up, in meters if there is a unit.");

  private static final Output VIEWS =
      Output.objects(
          "views",
          "What is seen.",
          Output.text("view", "Name or angles."),
          Output.count("width", "Of the picture, in pixels."),
          Output.count("height", "Of the picture, in pixels."),
          Output.text("projection", "parallel or perspective.").optional(),
          Output.rows(
                  "matrix",
                  4,
                  4,
                  "Maps a point (x, y, z, 1) to (X, Y, D, W): it is at the pixel (X/W, Y/W), at the"
                      + " depth D.")
              .optional(),
          Output.numbers("depth", 2, "Depths of the nearest and the farthest visible point.")
              .optional(),
          Output.count("visible_part_count", "Number of visible parts of a model."),
          Output.objects(
              "visible_parts",
              "The first 1,000 of them.",
              Output.text("name", "As 'describe' lists it."),
              Output.count("pixels", "In which it is the nearest."),
              Output.numbers(
                  "box", 4, "Left, top, right and bottom; the last two are the first beyond.")));

  private SummaryOutputs() {}

  /** Returns the members that all summaries have. */
  private static List<Output> head() {
    return new ArrayList<>(
        List.of(
            Output.text("format", "Changes with incompatible changes."),
            Output.text("version", "Of the program."),
            Output.text("command", "Name of the tool."),
            Output.text("model", "Path of the model.").optional(),
            Output.text("scene", "Path of the scene, if it is no model.").optional(),
            WARNINGS));
  }

  /** Returns the members of pictures. */
  static List<Output> ofPictures() {
    List<Output> outputs = head();
    outputs.add(Output.text("crop", "Left, top, width and height of the rectangle.").optional());
    outputs.add(VIEWS);
    outputs.add(NOTES);
    return outputs;
  }

  /** Returns the members of descriptions. */
  static List<Output> ofContents() {
    List<Output> outputs = head();
    outputs.addAll(
        List.of(
            Output.text("camera", "Kind of the camera."),
            Output.count("shapes", "Number of shapes."),
            Output.count("meshes", "Number of meshes."),
            Output.count("triangles", "Number of triangles."),
            Output.count("points", "Number of points."),
            Output.count("lights", "Number of lights."),
            Output.count("materials", "Number of materials."),
            Output.count("textures", "Number of textures."),
            Output.texts("cameras", "Names of the model's cameras.").optional(),
            Output.objects(
                    "animations",
                    "The model's animations.",
                    Output.text("name", "For 'pose'."),
                    Output.number("seconds", "Length.").optional())
                .optional(),
            Output.texts("variants", "Names for 'variant'.").optional(),
            Output.texts("material_names", "Names of the model's materials.").optional(),
            Output.text("unit", "Of the bounds; missing if the file states none.").optional(),
            Output.text("file_unit", "That the file states.").optional(),
            BOUNDS.optional(),
            Output.count("part_count", "Number of parts of a model.").optional(),
            Output.objects(
                    "parts",
                    "The first 1,000 of them.",
                    Output.text("name", "For 'hide', 'highlight' and 'crop'."),
                    Output.count("triangles", "Number of triangles.").optional(),
                    Output.count("points", "Number of points.").optional(),
                    BOUNDS)
                .optional(),
            Output.count("width", "Of a scene's picture, in pixels.").optional(),
            Output.count("height", "Of a scene's picture, in pixels.").optional(),
            Output.count("samples_per_pixel", "Of a scene's picture.").optional(),
            NOTES.optional()));
    return outputs;
  }
}
