package io.github.lumbre.cli.diff;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.model.difference.PartChange;
import io.github.lumbre.model.difference.PartChange.Kind;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PartTable;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;

/**
 * Paints the changes of parts over a pale picture of the new model, and what is gone from where it
 * was in the old one. Confined to one thread.
 */
public final class ChangePicture {
  /** Rays per pixel and axis, so that edges are smooth. */
  private static final int GRID = 3;

  private static final double PALE = .35;

  /** Colors that people with any color vision tell apart (Okabe and Ito 2008), linear. */
  private static final Map<Kind, Rgb> COLORS = new EnumMap<>(Kind.class);

  /** The word for a part where it was, and is not any more. */
  private static final String WAS = "where it was";

  private static final Rgb GONE = new Rgb(.665, .112, 0);

  static {
    COLORS.put(Kind.ADDED, new Rgb(0, .342, .171));
    COLORS.put(Kind.MOVED, new Rgb(0, .168, .445));
    COLORS.put(Kind.CHANGED, new Rgb(.791, .347, 0));
    COLORS.put(Kind.RENAMED, new Rgb(.604, .191, .386));
  }

  private final Scene scene;
  private final RenderSettings settings;
  private final PartTable parts;
  private final Map<String, PartChange> changes = new HashMap<>();
  private final Map<String, Tint> tints = new TreeMap<>();
  private final NearestHit hit = new NearestHit();
  private final CameraRay aimed = new CameraRay();

  /**
   * A picture of changes.
   *
   * @param colors for each thing in it, by its word, the mean color in which it is drawn
   */
  public record Drawn(Image image, Map<String, Rgb> colors) {}

  /** The mean of colors. Mutable. */
  private static final class Tint {
    private Rgb sum = Rgb.BLACK;
    private int count;

    void add(Rgb color) {
      sum = sum.plus(color);
      count++;
    }

    Rgb mean() {
      return sum.times(1. / count);
    }
  }

  /** A changed part that a ray meets. */
  private record Seen(PartChange change, double distance) {
    /** Returns whether this part of the old model is not hidden by a part of the new one. */
    private boolean isBefore(Seen now) {
      return change != now.change && distance < now.distance;
    }
  }

  /**
   * @param names returns the names of changed parts in this model
   */
  private ChangePicture(
      ParsedScene file, List<PartChange> changes, Function<PartChange, List<String>> names) {
    scene = file.scene().framed(file.settings().aspect());
    settings = file.settings();
    parts = file.model().orElseThrow().parts(file.scene());
    for (PartChange change : changes) {
      names.apply(change).forEach(part -> this.changes.put(part, change));
    }
  }

  /**
   * Returns the picture, and the colors in it.
   *
   * @param oldPicture of the old scene
   * @param nowPicture of the new scene, by the same camera
   */
  public static Drawn of(
      ParsedScene old,
      Image oldPicture,
      ParsedScene now,
      Image nowPicture,
      List<PartChange> changes) {
    List<PartChange> gone =
        changes.stream().filter(c -> c.kind() == Kind.REMOVED || c.kind() == Kind.MOVED).toList();
    ChangePicture before = new ChangePicture(old, gone, PartChange::oldParts);
    ChangePicture after = new ChangePicture(now, changes, PartChange::nowParts);
    float[] rgb = new float[3 * nowPicture.width() * nowPicture.height()];
    for (int y = 0; y < nowPicture.height(); y++) {
      for (int x = 0; x < nowPicture.width(); x++) {
        Rgb color = pixel(before, oldPicture, after, nowPicture, x, y);
        int at = 3 * (y * nowPicture.width() + x);
        rgb[at] = (float) color.r();
        rgb[at + 1] = (float) color.g();
        rgb[at + 2] = (float) color.b();
      }
    }
    Map<String, Rgb> colors = new LinkedHashMap<>();
    after.tints.forEach((word, tint) -> colors.put(word, tint.mean()));
    return new Drawn(
        new Image(nowPicture.width(), nowPicture.height(), rgb, new float[0]), colors);
  }

  private static Rgb pixel(
      ChangePicture before, Image oldPicture, ChangePicture after, Image nowPicture, int x, int y) {
    double shade = brightness(nowPicture, x, y);
    double oldShade = brightness(oldPicture, x, y);
    Rgb pale = Rgb.gray(1 - PALE + PALE * shade);
    Rgb sum = Rgb.BLACK;
    for (int i = 0; i < GRID * GRID; i++) {
      double u = (x + (i % GRID + .5) / GRID) / nowPicture.width();
      double v = (y + (i / GRID + .5) / GRID) / nowPicture.height();
      Optional<Seen> seen = after.at(u, v);
      Rgb painted =
          seen.map(part -> COLORS.get(part.change.kind()).times(.3 + .7 * shade)).orElse(pale);
      boolean isGone =
          before.at(u, v).filter(old -> seen.isEmpty() || old.isBefore(seen.get())).isPresent();
      Rgb color = isGone ? GONE.times(.5 + .5 * oldShade).plus(painted).times(.5) : painted;
      if (isGone || seen.isPresent()) {
        String word = isGone ? WAS : ChangePage.word(seen.get().change.kind());
        after.tints.computeIfAbsent(word, w -> new Tint()).add(color);
      }
      sum = sum.plus(color);
    }
    return sum.times(1. / (GRID * GRID));
  }

  private static double brightness(Image picture, int x, int y) {
    return Math.min(1, picture.pixel(x, y).luminance());
  }

  /** Returns the changed part that is seen at a point of the frame. */
  private Optional<Seen> at(double u, double v) {
    if (changes.isEmpty() || !scene.camera().aim(u, v, new SobolSampler(0), aimed)) {
      return Optional.empty();
    }
    scene.intersect(aimed.toRay(), hit);
    int part = parts.at(hit);
    return part == PartTable.NONE
        ? Optional.empty()
        : Optional.ofNullable(changes.get(parts.parts().get(part).name()))
            .map(change -> new Seen(change, hit.t()));
  }
}
