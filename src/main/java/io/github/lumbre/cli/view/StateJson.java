package io.github.lumbre.cli.view;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The state of a session as JSON for the page. */
final class StateJson {
  private StateJson() {}

  /**
   * Returns the state.
   *
   * @param look how the page shows the picture at first
   * @param other the picture to compare with
   */
  static String of(Snapshot state, Look look, Other other) {
    JsonObject json = new JsonObject();
    json.addProperty("version", state.version());
    json.addProperty("name", state.name());
    json.addProperty("status", state.status());
    json.addProperty("isMoved", state.isMoved());
    json.add("problems", texts(state.problems().stream()));
    json.addProperty("isDisplayReferred", look.isDisplayReferred());
    json.addProperty("other", other.name());
    json.addProperty("otherIsDisplayReferred", other.isDisplayReferred());
    json.addProperty("toneMap", look.curve().label());
    look.exposure()
        .stops()
        .ifPresentOrElse(
            stops -> json.addProperty("exposure", stops),
            () -> json.addProperty("exposure", "auto"));
    look.background().ifPresent(c -> json.add("background", numbers(c.r(), c.g(), c.b())));
    state.frame().ifPresent(frame -> json.add("frame", frame(frame)));
    state.settings().ifPresent(settings -> json.add("render", render(state, settings)));
    return json.toString();
  }

  /**
   * How a picture is shown at first.
   *
   * @param exposure of the scene, or none
   * @param curve tone curve of the scene
   * @param isDisplayReferred whether both are already applied to the picture
   * @param background linear color of the screen behind a picture with alpha
   */
  record Look(
      Exposure exposure,
      ToneCurve curve,
      boolean isDisplayReferred,
      Optional<Rgb> background) {
    Look(Exposure exposure, ToneCurve curve, boolean isDisplayReferred) {
      this(exposure, curve, isDisplayReferred, Optional.empty());
    }
  }

  /**
   * The picture to compare with.
   *
   * @param name empty without such a picture
   * @param isDisplayReferred whether exposure and tone curve are already applied to it
   */
  record Other(String name, boolean isDisplayReferred) {}

  private static JsonObject frame(Frame frame) {
    JsonObject json = new JsonObject();
    json.addProperty("version", frame.version());
    json.addProperty("width", frame.image().width());
    json.addProperty("height", frame.image().height());
    json.addProperty("samples", frame.samples());
    json.addProperty("isDraft", frame.isDraft());
    json.addProperty("isFinal", frame.isFinal());
    json.add("layers", texts(frame.layers().stream().map(ImageLayer::name)));
    frame.denoised().ifPresent(clean -> json.addProperty("denoised", clean.version()));
    return json;
  }

  private static JsonObject render(Snapshot state, RenderSettings settings) {
    JsonObject json = new JsonObject();
    Crop window = settings.window();
    long pixels = window.pixels();
    json.addProperty("width", settings.width());
    json.addProperty("height", settings.height());
    json.add("window", numbers(window.x(), window.y(), window.width(), window.height()));
    boolean isOpen = settings.samples() == RenderSettings.MAX_SAMPLES;
    json.addProperty("goal", isOpen ? -1 : settings.samples());
    json.addProperty("samples", (double) state.samples() / pixels);
    json.addProperty("rate", state.rate());
    json.addProperty("seconds", state.seconds());
    json.addProperty("secondsLeft", state.secondsLeft().orElse(-1));
    json.add("recorded", texts(state.layers().stream()));
    json.add("errors", errors(state.errors()));
    json.addProperty("estimatedAt", estimatedAt(state, pixels));
    return json;
  }

  /**
   * Returns of how many samples per pixel the last error estimate is, as {@code at 4 samples};
   * empty if the picture has no more than those. Errors are estimated between passes, and a pass
   * may take minutes.
   */
  private static String estimatedAt(Snapshot state, long pixels) {
    if (state.errors().isEmpty()) {
      return "";
    }
    double samples = state.errors().get(state.errors().size() - 1).samples();
    return Math.round(samples * pixels) < state.samples()
        ? "at " + Numbers.count(Math.round(samples), "sample")
        : "";
  }

  private static JsonArray errors(List<ErrorPoint> points) {
    JsonArray all = new JsonArray();
    for (ErrorPoint p : points) {
      // An infinite bound has no number in JSON.
      double bound = Double.isFinite(p.bound()) ? p.bound() : -1;
      all.add(numbers(p.seconds(), p.samples(), p.error(), bound, p.isDoubtful() ? 1 : 0));
    }
    return all;
  }

  private static JsonArray texts(Stream<String> values) {
    JsonArray array = new JsonArray();
    values.forEach(array::add);
    return array;
  }

  private static JsonArray numbers(double... values) {
    JsonArray array = new JsonArray();
    for (double value : values) {
      array.add(value);
    }
    return array;
  }
}
