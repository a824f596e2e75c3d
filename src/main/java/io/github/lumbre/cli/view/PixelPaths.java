package io.github.lumbre.cli.view;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.cli.output.PixelJson;
import io.github.lumbre.cli.output.PixelPlace;
import io.github.lumbre.cli.output.PixelReport;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.Contribution;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The paths of a pixel's samples as {@code lumbre pixel} prints them, with the places of their
 * vertices in the picture.
 */
final class PixelPaths {
  /** The largest number of samples that are repeated. */
  static final int MAX_SAMPLES = 2048;

  private static final int SHOWN = 8;

  /** The length of a ray towards a light or the sky, relative to the distance from the camera. */
  private static final double RAY_LENGTH = .15;

  private static final Gson GSON = new GsonBuilder().disableHtmlEscaping().create();

  private final SceneFile file;
  private final PixelPlace place;
  private final Camera camera;

  /**
   * @param place pixel of the full frame, inside it
   */
  PixelPaths(SceneFile file, PixelPlace place) {
    this.file = file;
    this.place = place;
    camera = file.scene().camera();
  }

  /**
   * Returns the statistics of a pixel, and the paths of its brightest samples or of one sample.
   *
   * @param samples number of samples to repeat, from the first, at least 1
   * @param only the number of the one sample; empty for the brightest
   */
  String json(int samples, Optional<Integer> only) {
    RenderSettings settings =
        file.settings().toBuilder().samples(Math.min(samples, MAX_SAMPLES)).build();
    PixelReplay replay = new PixelReplay(file.scene(), settings);
    PixelReport report = new PixelReport(file, place);
    JsonObject result;
    List<PixelReplay.Sample> shown;
    if (only.isPresent()) {
      shown = List.of(replay.sample(place.x(), place.y(), only.get()));
      result = new JsonObject();
      JsonArray one = new JsonArray();
      one.add(JsonParser.parseString(PixelJson.text(report, shown.get(0))));
      result.add("brightest", one);
    } else {
      PixelReplay.Pixel all = replay.pixel(place.x(), place.y(), SHOWN);
      shown = all.brightest();
      result = JsonParser.parseString(PixelJson.text(report, all)).getAsJsonObject();
      result.addProperty("summary", report.text(all));
    }
    JsonArray paths = result.getAsJsonArray("brightest");
    for (int i = 0; i < shown.size(); i++) {
      JsonObject path = paths.get(i).getAsJsonObject();
      path.addProperty("text", report.text(shown.get(i)));
      path.add("drawing", drawing(shown.get(i)));
    }
    return GSON.toJson(result);
  }

  /**
   * Returns the lines of a path in the picture: for each vertex its ray, its place and the rays to
   * the lights that it sampled. Coordinates are in pixels; a place that the camera does not see is
   * missing.
   */
  private JsonArray drawing(PixelReplay.Sample sample) {
    JsonArray vertices = new JsonArray();
    for (PathVertex vertex : sample.vertices()) {
      JsonObject drawn = new JsonObject();
      Vec3 origin = vertex.ray().origin();
      Optional<Vec3> hit = vertex.hit().map(PathVertex.Hit::position);
      put("from", origin, drawn);
      put("to", hit.orElseGet(() -> along(origin, vertex.ray().direction())), drawn);
      drawn.addProperty("isHit", hit.isPresent());
      JsonArray lights = new JsonArray();
      hit.ifPresent(place -> lights(vertex, place).forEach(lights::add));
      drawn.add("lights", lights);
      vertices.add(drawn);
    }
    return vertices;
  }

  private List<JsonObject> lights(PathVertex vertex, Vec3 position) {
    List<JsonObject> lights = new ArrayList<>();
    for (Contribution contribution : vertex.contributions()) {
      for (FoundLight light : contribution.lights()) {
        if (light.source() == Source.LIGHT) {
          JsonObject drawn = new JsonObject();
          put("to", along(position, light.wi()), drawn);
          drawn.addProperty("isBlocked", light.blocked());
          lights.add(drawn);
        }
      }
    }
    return lights;
  }

  private Vec3 along(Vec3 origin, Vec3 direction) {
    double length = RAY_LENGTH * Math.max(1e-9, origin.minus(camera.position()).length());
    double radius = file.scene().radius();
    boolean isAtCamera = length < 1e-6 * radius;
    return origin.plus(isAtCamera ? Math.max(1, radius) : length, direction);
  }

  private void put(String name, Vec3 point, JsonObject into) {
    camera
        .project(point)
        .ifPresent(
            film -> {
              JsonArray place = new JsonArray();
              place.add(Math.rint(100 * film.x() * file.settings().width()) / 100);
              place.add(Math.rint(100 * film.y() * file.settings().height()) / 100);
              into.add(name, place);
            });
  }
}
