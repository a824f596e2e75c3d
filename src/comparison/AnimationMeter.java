package io.github.lumbre.render.denoise.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.animation.FrameRate;
import io.github.lumbre.image.compare.Flip;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.render.denoise.NoisyPicture.Halves;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.internal.ModelSequence;
import io.github.lumbre.stage.internal.ModelSequence.Motion;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Measures frames that are denoised alone and with their neighbors, against references. Arguments:
 * a model, the size of the frames such as {@code 160x120}, samples of a frame, samples of each half
 * of a reference, the number of frames, {@code turn:N} for frames of a turntable of N or {@code
 * NAME:FPS:FIRST} for frames of an animation, and {@code sky=NAME} or {@code ground}.
 *
 * <p>Values are in steps of 8 bits, as sRGB; noise of the references is subtracted. Prints, for
 * both kinds of frames: the mean and the median, over points of surfaces that move by more than a
 * quarter of a pixel a frame and stay visible for seven, of the variance over time of their error;
 * the squared difference of a point in neighboring frames, and that of the references; the squared
 * error; FLIP in the mean and in the worst frame; and the CPU time of the second over the first.
 */
final class AnimationMeter {
  private static final int REACH = SharedFrames.REACH;
  private static final double SLOWEST = .25;

  private final List<SceneFile> files = new ArrayList<>();
  private final List<NoisyPicture> noisy = new ArrayList<>();
  private final List<SeenFrame> seen = new ArrayList<>();
  private final List<Image> alone = new ArrayList<>();
  private final List<Image> mixed = new ArrayList<>();
  private final List<Image> references = new ArrayList<>();
  private final List<Image> halves = new ArrayList<>();
  private final int frames;
  private final boolean isClosed;
  private double before;
  private double after;

  private AnimationMeter(int frames, boolean isClosed) {
    this.frames = frames;
    this.isClosed = isClosed;
  }

  public static void main(String[] args) throws Exception {
    RenderSettings.Size size = RenderSettings.Size.of(args[1]);
    String[] motion = args[5].split(":");
    Stage stage = Stage.DEFAULT;
    for (int i = 6; i < args.length; i++) {
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
            Path.of(args[0]),
            Optional.empty(),
            stage,
            isTurntable
                ? Motion.turntable(Integer.parseInt(motion[1]))
                : Motion.animation(motion[0], new FrameRate(Integer.parseInt(motion[1]), 1)));
    int frames = Integer.parseInt(args[4]);
    int first = isTurntable ? 0 : Integer.parseInt(motion[2]);
    AnimationMeter meter = new AnimationMeter(frames, isTurntable && frames == sequence.count());
    for (int i = 0; i < frames; i++) {
      meter.render(
          sequence.frame(first + i), Integer.parseInt(args[2]), Integer.parseInt(args[3]), i);
    }
    meter.mix();
    meter.print(Path.of(args[0]).getFileName() + " " + args[5]);
  }

  private static double cpu() {
    return 1e-9
        * ProcessHandle.current().info().totalCpuDuration().orElseThrow().toNanos();
  }

  private static RenderSettings settings(SceneFile file, int samples, long seed) {
    return file.settings().toBuilder()
        .samples(samples)
        .seed(seed)
        .set(Setting.LAYERS, Layer.FOR_DENOISING)
        .build();
  }

  private static Film film(SceneFile file, int samples, long seed) throws InterruptedException {
    FilmRenderer renderer = new FilmRenderer(settings(file, samples, seed), file.scene());
    Film film = renderer.newFilm();
    renderer.addSamples(film, samples, Progress.NONE);
    return film;
  }

  private void render(SceneFile file, int samples, int half, int index) throws Exception {
    double start = cpu();
    NoisyPicture picture = NoisyPicture.of(film(file, samples, 0));
    List<float[]> left = new ArrayList<>();
    Image image = BuiltInDenoiser.denoise(picture, threads(), left::add).image();
    double middle = cpu();
    Optional<SeenFrame> like = index == 0 ? Optional.empty() : Optional.of(seen.get(index - 1));
    seen.add(seen(file, picture, image, left.get(0), like));
    before += middle - start;
    after += cpu() - start;
    files.add(file);
    noisy.add(picture);
    alone.add(image);
    Image one = film(file, half, 2L * index + 1).develop();
    Image other = film(file, half, 2L * index + 2).develop();
    references.add(combined(one, other, .5, .5));
    halves.add(combined(inSteps(one), inSteps(other), .5, -.5));
  }

  private static int threads() {
    return Runtime.getRuntime().availableProcessors();
  }

  private static SeenFrame seen(
      SceneFile file, NoisyPicture picture, Image image, float[] left, Optional<SeenFrame> like)
      throws InterruptedException {
    return SeenFrame.of(
        file.scene(), settings(file, 1, 0), picture, image, left, like, threads());
  }

  private static Image combined(Image one, Image other, double a, double b) {
    float[] values = new float[one.rgb().length];
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) (a * one.rgb()[i] + b * other.rgb()[i]);
    }
    return new Image(one.width(), one.height(), values, new float[0]);
  }

  private static Image inSteps(Image linear) {
    float[] values = new float[linear.rgb().length];
    for (int i = 0; i < values.length; i += 3) {
      float[] rgb = linear.rgb();
      Rgb color = ToneCurve.SRGB.apply(new Rgb(rgb[i], rgb[i + 1], rgb[i + 2]));
      values[i] = (float) (255 * color.r());
      values[i + 1] = (float) (255 * color.g());
      values[i + 2] = (float) (255 * color.b());
    }
    return new Image(linear.width(), linear.height(), values, new float[0]);
  }

  private void mix() throws InterruptedException {
    double start = cpu();
    for (int i = 0; i < frames; i++) {
      mixed.add(SharedFrames.mixed(seen.get(i), near(i, -1), near(i, 1), threads()));
    }
    after += cpu() - start;
  }

  private List<SeenFrame> near(int index, int step) {
    List<SeenFrame> near = new ArrayList<>();
    for (int k = 1; k <= REACH; k++) {
      int other = index + step * k;
      if (isClosed || 0 <= other && other < frames) {
        near.add(seen.get(Math.floorMod(other, frames)));
      }
    }
    return near;
  }

  /** Returns frames that show other values at the same points. */
  private List<SeenFrame> withValues(List<Image> values) throws InterruptedException {
    List<SeenFrame> frames = new ArrayList<>();
    for (int i = 0; i < values.size(); i++) {
      NoisyPicture of = noisy.get(i);
      float[] none = new float[of.light().mean().length];
      NoisyPicture plain =
          new NoisyPicture(
              of.width(),
              of.height(),
              new Halves(none, none),
              Optional.empty(),
              of.normal(),
              of.alpha(),
              0);
      frames.add(seen(files.get(i), plain, values.get(i), none, Optional.of(seen.get(i))));
    }
    return frames;
  }

  /** Values along the paths of points: their variances over time, and their steps. */
  private record Paths(List<Double> variances, double step) {
    double mean() {
      return variances.stream().mapToDouble(v -> v).average().orElse(Double.NaN);
    }

    double median() {
      return variances.isEmpty()
          ? Double.NaN
          : variances.stream().sorted().toList().get(variances.size() / 2);
    }
  }

  private Paths paths(List<Image> values) throws InterruptedException {
    List<SeenFrame> shown = withValues(values);
    List<Double> variances = new ArrayList<>();
    double steps = 0;
    long count = 0;
    double unit = shown.get(0).divisors[0];
    for (int t = REACH; t < frames - REACH; t++) {
      int[] numbers = shown.get(t).surfaces.numbersIn(shown.get(t + 1).surfaces);
      double[] places = FrameTracks.places(shown.get(t));
      List<FrameTracks> tracks = new ArrayList<>();
      for (int k = -REACH; k <= REACH; k++) {
        tracks.add(FrameTracks.of(shown.get(t), places, shown.get(t + k), threads()));
      }
      for (int pixel = 0; pixel < shown.get(t).variances.length; pixel++) {
        int at = pixel;
        boolean isSeen = tracks.stream().allMatch(track -> track.isFollowed[at] > 0);
        if (isSeen && isMoving(shown.get(t), shown.get(t + 1), numbers, pixel)) {
          variances.add(unit * unit * variance(tracks, pixel));
          for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
            double step = unit * tracks.get(REACH + 1).differences[i];
            steps += step * step / 3;
          }
          count++;
        }
      }
    }
    return new Paths(variances, steps / count);
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

  private static boolean isMoving(
      SeenFrame from, SeenFrame to, int[] numbers, int pixel) {
    int primitive = from.primitive(pixel);
    Vec3 there = from.point(pixel, to.surfaces, numbers[primitive]);
    Point2 start =
        from.surfaces.project(from.point(pixel, from.surfaces, primitive)).orElseThrow();
    Point2 end = to.surfaces.project(there).orElseThrow();
    double x = (end.x() - start.x()) * from.settings.width();
    double y = (end.y() - start.y()) * from.settings.height();
    return Math.sqrt(x * x + y * y) > SLOWEST;
  }

  private static double square(Image image) {
    double sum = 0;
    for (float value : image.rgb()) {
      sum += value * (double) value;
    }
    return sum / image.rgb().length;
  }

  private void print(String name) throws InterruptedException {
    Paths noise = paths(halves);
    double step = paths(references.stream().map(AnimationMeter::inSteps).toList()).step();
    System.out.printf(
        Locale.ROOT,
        "%s: %d points; step of references %.3f%n",
        name,
        noise.variances.size(),
        step - noise.step);
    print("alone", alone, noise);
    print("mixed", mixed, noise);
    System.out.printf(Locale.ROOT, "  CPU time %.3f%n", after / before);
  }

  private void print(String name, List<Image> images, Paths noise) throws InterruptedException {
    List<Image> errors = new ArrayList<>();
    double square = 0;
    double worst = 0;
    double flips = 0;
    double worstFlip = 0;
    for (int i = 0; i < frames; i++) {
      errors.add(combined(inSteps(images.get(i)), inSteps(references.get(i)), 1, -1));
      double error = square(errors.get(i)) - square(halves.get(i));
      square += error / frames;
      worst = Math.max(worst, error);
      double flip = Flip.mean(images.get(i), references.get(i));
      flips += flip / frames;
      worstFlip = Math.max(worstFlip, flip);
    }
    Paths paths = paths(errors);
    System.out.printf(
        Locale.ROOT,
        "  %s: variance %.3f, median %.3f; step %.3f; squared error %.3f, worst %.3f; FLIP %.5f,"
            + " worst %.5f%n",
        name,
        paths.mean() - noise.mean(),
        paths.median(),
        paths(images.stream().map(AnimationMeter::inSteps).toList()).step(),
        square,
        worst,
        flips,
        worstFlip);
  }
}
