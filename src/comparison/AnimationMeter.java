package io.github.lumbre.render.denoise.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.animation.FrameRate;
import io.github.lumbre.image.compare.Flip;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.internal.ModelSequence;
import io.github.lumbre.stage.internal.ModelSequence.Motion;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Measures frames that are denoised alone and with their neighbors, against references. Arguments:
 * a folder for frames, a model, the size of the frames such as {@code 160x120}, samples of a frame,
 * samples of each half of a reference, the number of frames, {@code turn:N} for frames of a
 * turntable of N or {@code NAME:FPS:FIRST} for frames of an animation, and {@code sky=NAME} or
 * {@code ground}. Frames that are in the folder are not rendered again.
 *
 * <p>Values are in steps of 8 bits, as sRGB; noise of the references is subtracted. Prints, for
 * frames alone and mixed with up to 4 neighbors to each side: the mean and the median, over points
 * of surfaces that move by more than a quarter of a pixel a frame and stay visible for seven, of
 * the variance over time of their error; the squared difference of a point in neighboring frames,
 * and the squared error of that difference; the squared error, in the mean and in the worst frame,
 * and that of pixels whose light changes by more than 12 steps within three frames; FLIP in the
 * mean and in the worst frame; and the CPU time over that of frames alone. After ± are standard
 * errors of the ratio to frames alone: those of the jackknife over tiles of 16 x 16 pixels.
 */
final class AnimationMeter {
  private static final int REACH = 3;
  private static final double SLOWEST = .25;
  private static final double CHANGE = 12;
  private static final int TILE = 16;

  private final List<MeteredFrame> frames;
  private final List<SeenFrame> seen = new ArrayList<>();
  private final boolean isClosed;
  private final double seconds;
  private final double lookSeconds;

  AnimationMeter(List<MeteredFrame> frames, boolean isClosed) throws InterruptedException {
    this.frames = frames;
    this.isClosed = isClosed;
    double start = MeteredFrame.cpu();
    for (MeteredFrame frame : frames) {
      Optional<SeenFrame> like =
          seen.isEmpty() ? Optional.empty() : Optional.of(seen.get(seen.size() - 1));
      seen.add(frame.seen(like));
    }
    lookSeconds = MeteredFrame.cpu() - start;
    seconds = frames.stream().mapToDouble(MeteredFrame::seconds).sum();
  }

  static AnimationMeter of(String[] args) throws Exception {
    Path folder = Files.createDirectories(Path.of(args[0]));
    RenderSettings.Size size = RenderSettings.Size.of(args[2]);
    String[] motion = args[6].split(":");
    Stage stage = Stage.DEFAULT;
    for (int i = 7; i < args.length; i++) {
      stage =
          args[i].equals("ground")
              ? stage.with(Stage.GROUND, true)
              : stage.with(Stage.SKY, args[i].substring(4));
    }
    boolean isTurntable = motion[0].equals("turn");
    SceneParser parser =
        new SceneParser()
            .overriding(s -> s.toBuilder().size(size.width(), size.height()).build());
    ModelSequence sequence =
        ModelSequence.of(
            parser,
            Path.of(args[1]),
            Optional.empty(),
            stage,
            isTurntable
                ? Motion.turntable(Integer.parseInt(motion[1]))
                : Motion.animation(motion[0], new FrameRate(Integer.parseInt(motion[1]), 1)));
    int count = Integer.parseInt(args[5]);
    int first = isTurntable ? 0 : Integer.parseInt(motion[2]);
    List<MeteredFrame> frames = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      frames.add(
          MeteredFrame.of(
              folder.resolve("frame-" + i),
              sequence.frame(first + i),
              Integer.parseInt(args[3]),
              Integer.parseInt(args[4]),
              i));
    }
    return new AnimationMeter(frames, isTurntable && count == sequence.count());
  }

  public static void main(String[] args) throws Exception {
    of(args).print(Path.of(args[0]).getFileName().toString());
  }

  /** Returns the frames, mixed with so many to each side. */
  List<Image> mixed(int reach) throws InterruptedException {
    List<Image> mixed = new ArrayList<>();
    for (int i = 0; i < frames.size(); i++) {
      List<SeenFrame> before = near(i, -1, reach);
      mixed.add(
          SharedFrames.mixed(seen.get(i), before, near(i, 1, reach), MeteredFrame.threads()));
    }
    return mixed;
  }

  private List<SeenFrame> near(int index, int step, int reach) {
    List<SeenFrame> near = new ArrayList<>();
    for (int k = 1; k <= reach; k++) {
      int other = index + step * k;
      if (isClosed || 0 <= other && other < frames.size()) {
        near.add(seen.get(Math.floorMod(other, frames.size())));
      }
    }
    return near;
  }

  /** Sums over tiles. */
  private final class Tiles {
    private final int width = frames.get(0).alone().width();
    private final int columns = (width + TILE - 1) / TILE;
    private final double[] sums =
        new double[columns * ((frames.get(0).alone().height() + TILE - 1) / TILE)];
    private final double[] counts = new double[sums.length];
    private final List<Double> values = new ArrayList<>();

    void add(int pixel, double value) {
      int tile = pixel / width / TILE * columns + pixel % width / TILE;
      sums[tile] += value;
      counts[tile]++;
      values.add(value);
    }

    double mean() {
      return meanWithout(-1);
    }

    double median() {
      return values.isEmpty() ? 0 : values.stream().sorted().toList().get(values.size() / 2);
    }

    private double meanWithout(int tile) {
      double sum = 0;
      double count = 0;
      for (int i = 0; i < sums.length; i++) {
        sum += i == tile ? 0 : sums[i];
        count += i == tile ? 0 : counts[i];
      }
      return sum / count;
    }

    /** Returns the standard error of the ratio of two means, less noise. */
    double error(Tiles base, Tiles noise) {
      double sum = 0;
      double squares = 0;
      int n = 0;
      for (int i = 0; i < sums.length; i++) {
        if (counts[i] > 0) {
          double without = noise.meanWithout(i);
          double ratio = (meanWithout(i) - without) / (base.meanWithout(i) - without);
          sum += ratio;
          squares += ratio * ratio;
          n++;
        }
      }
      return Math.sqrt(Math.max(0, squares - sum * sum / n) * (n - 1) / n);
    }
  }

  /** Values along the paths of points: their variances over time, and their steps. */
  private final class Paths {
    final Tiles variances = new Tiles();
    final Tiles steps = new Tiles();

    Paths(List<Image> values) throws InterruptedException {
      List<SeenFrame> shown = new ArrayList<>();
      for (int i = 0; i < values.size(); i++) {
        shown.add(frames.get(i).showing(values.get(i), seen.get(i)));
      }
      double unit = shown.get(0).divisors[0];
      for (int t = REACH; t < frames.size() - REACH; t++) {
        add(shown, t, unit);
      }
    }

    private void add(List<SeenFrame> shown, int t, double unit) throws InterruptedException {
      SeenFrame frame = shown.get(t);
      int[] numbers = frame.surfaces.numbersIn(shown.get(t + 1).surfaces);
      double[] places = FrameTracks.places(frame);
      List<FrameTracks> tracks = new ArrayList<>();
      for (int k = -REACH; k <= REACH; k++) {
        tracks.add(FrameTracks.of(frame, places, shown.get(t + k), MeteredFrame.threads()));
      }
      for (int pixel = 0; pixel < frame.variances.length; pixel++) {
        int at = pixel;
        boolean isSeen = tracks.stream().allMatch(track -> track.isFollowed[at] > 0);
        if (isSeen && isMoving(frame, shown.get(t + 1), numbers, pixel)) {
          variances.add(pixel, unit * unit * variance(tracks, pixel));
          double step = 0;
          for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
            double difference = unit * tracks.get(REACH + 1).differences[i];
            step += difference * difference / 3;
          }
          steps.add(pixel, step);
        }
      }
    }
  }

  private static double variance(List<FrameTracks> tracks, int pixel) {
    double variance = 0;
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      double sum = 0;
      double squares = 0;
      for (FrameTracks track : tracks) {
        sum += track.differences[i];
        squares += track.differences[i] * (double) track.differences[i];
      }
      variance += (squares - sum * sum / tracks.size()) / (tracks.size() - 1) / 3;
    }
    return variance;
  }

  private static boolean isMoving(SeenFrame from, SeenFrame to, int[] numbers, int pixel) {
    int primitive = from.primitive(pixel);
    Vec3 there = from.point(pixel, to.surfaces, numbers[primitive]);
    Point2 start =
        from.surfaces.project(from.point(pixel, from.surfaces, primitive)).orElseThrow();
    Point2 end = to.surfaces.project(there).orElseThrow();
    double x = (end.x() - start.x()) * from.settings.width();
    double y = (end.y() - start.y()) * from.settings.height();
    return Math.sqrt(x * x + y * y) > SLOWEST;
  }

  /** Squared errors of a sequence. */
  private final class Errors {
    final Tiles all = new Tiles();
    final Tiles changes = new Tiles();
    final double[] frame = new double[frames.size()];
    final double[] change = new double[frames.size()];
    final double[] changed = new double[frames.size()];

    Errors(List<Image> errors) {
      for (int t = 0; t < errors.size(); t++) {
        int pixels = errors.get(t).rgb().length / 3;
        for (int pixel = 0; pixel < pixels; pixel++) {
          double square = 0;
          for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
            square += errors.get(t).rgb()[i] * (double) errors.get(t).rgb()[i] / 3;
          }
          all.add(pixel, square);
          frame[t] += square / pixels;
          if (isChange[t][pixel]) {
            changes.add(pixel, square);
            change[t] += square;
            changed[t]++;
          }
        }
      }
    }
  }

  private boolean[][] isChange;

  private boolean[][] changes() {
    List<Image> shown =
        frames.stream().map(frame -> MeteredFrame.inSteps(frame.reference())).toList();
    boolean[][] isChange = new boolean[frames.size()][shown.get(0).rgb().length / 3];
    for (int t = 0; t < shown.size(); t++) {
      for (int k = Math.max(0, t - REACH); k <= Math.min(shown.size() - 1, t + REACH); k++) {
        for (int i = 0; i < 3 * isChange[t].length; i++) {
          isChange[t][i / 3] |= Math.abs(shown.get(t).rgb()[i] - shown.get(k).rgb()[i]) > CHANGE;
        }
      }
    }
    return isChange;
  }

  private void print(String name) throws InterruptedException {
    isChange = changes();
    List<Image> halves = frames.stream().map(MeteredFrame::half).toList();
    Kind noise = new Kind(new Paths(halves), new Errors(halves), 0);
    Paths references =
        new Paths(frames.stream().map(frame -> MeteredFrame.inSteps(frame.reference())).toList());
    System.out.printf(
        Locale.ROOT,
        "%s: %d points; step of references %.3f; noise of references: variance %.3f, error %.3f%n",
        name,
        noise.paths.variances.values.size(),
        references.steps.mean() - noise.paths.steps.mean(),
        noise.paths.variances.mean(),
        noise.errors.all.mean());
    List<Image> alone = frames.stream().map(MeteredFrame::alone).toList();
    Kind base = kind(alone);
    print("alone", alone, base, base, noise, 1);
    mixed(1); // so that its compiler does not count
    for (int reach = 1; reach <= REACH + 1; reach++) {
      double start = MeteredFrame.cpu();
      List<Image> mixed = mixed(reach);
      double took = MeteredFrame.cpu() - start + lookSeconds;
      print("mixed " + reach, mixed, kind(mixed), base, noise, 1 + took / seconds);
    }
  }

  /** What is measured of a kind of frames. */
  private record Kind(Paths paths, Errors errors, double step) {}

  private Kind kind(List<Image> images) throws InterruptedException {
    List<Image> errors = new ArrayList<>();
    for (int i = 0; i < images.size(); i++) {
      errors.add(frames.get(i).error(images.get(i)));
    }
    Paths steps = new Paths(images.stream().map(MeteredFrame::inSteps).toList());
    Paths paths = new Paths(errors);
    return new Kind(paths, new Errors(errors), steps.steps.mean());
  }

  private void print(
      String name, List<Image> images, Kind kind, Kind base, Kind noise, double time) {
    double worst = 0;
    double worstChange = 0;
    double flips = 0;
    double worstFlip = 0;
    for (int i = 0; i < images.size(); i++) {
      worst = Math.max(worst, kind.errors.frame[i] - noise.errors.frame[i]);
      double ratio =
          (kind.errors.change[i] - noise.errors.change[i])
              / (base.errors.change[i] - noise.errors.change[i]);
      worstChange = Math.max(worstChange, kind.errors.changed[i] == 0 ? 0 : ratio);
      double flip = Flip.mean(images.get(i), frames.get(i).reference());
      flips += flip / images.size();
      worstFlip = Math.max(worstFlip, flip);
    }
    Paths paths = kind.paths;
    System.out.printf(
        Locale.ROOT,
        "  %s: variance %.3f ±%.3f, median %.3f; step %.3f, its error %.3f; squared error %.3f"
            + " ±%.3f, worst %.3f; in changes %.3f ±%.3f, worst ratio %.3f;"
            + " FLIP %.5f, worst %.5f; CPU %.3f%n",
        name,
        paths.variances.mean() - noise.paths.variances.mean(),
        paths.variances.error(base.paths.variances, noise.paths.variances),
        paths.variances.median(),
        kind.step,
        paths.steps.mean() - noise.paths.steps.mean(),
        kind.errors.all.mean() - noise.errors.all.mean(),
        kind.errors.all.error(base.errors.all, noise.errors.all),
        worst,
        kind.errors.changes.mean() - noise.errors.changes.mean(),
        kind.errors.changes.error(base.errors.changes, noise.errors.changes),
        worstChange,
        flips,
        worstFlip,
        time);
  }
}
