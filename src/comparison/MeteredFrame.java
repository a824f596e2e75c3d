package io.github.lumbre.render.denoise.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.render.denoise.NoisyPicture.Halves;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.SceneFile;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A frame, denoised by itself, and its reference.
 *
 * @param left noise that is left
 * @param reference the mean of two halves
 * @param half what the halves differ from it, in steps of 8 bits
 * @param seconds CPU time of rendering and denoising
 */
record MeteredFrame(
    SceneFile file,
    NoisyPicture noisy,
    Image alone,
    float[] left,
    Image reference,
    Image half,
    double seconds) {

  /** Returns a frame of a folder; renders and writes it if it is not there. */
  static MeteredFrame of(Path file, SceneFile scene, int samples, int half, int index)
      throws IOException, InterruptedException {
    if (!Files.exists(file)) {
      write(file, scene, samples, half, index);
    }
    try (DataInputStream in = new DataInputStream(Files.newInputStream(file))) {
      double seconds = in.readDouble();
      int width = in.readInt();
      int height = in.readInt();
      float[] light = read(in);
      float[] albedo = read(in);
      float[] normal = read(in);
      float[] alpha = read(in);
      Image alone = new Image(width, height, read(in), read(in));
      float[] left = read(in);
      Image one = new Image(width, height, read(in), new float[0]);
      Image other = new Image(width, height, read(in), new float[0]);
      NoisyPicture noisy =
          new NoisyPicture(
              width, height, unknown(light), guide(albedo), guide(normal), alpha, 0);
      Image halves = combined(inSteps(one), inSteps(other), .5, -.5);
      return new MeteredFrame(
          scene, noisy, alone, left, combined(one, other, .5, .5), halves, seconds);
    }
  }

  private static void write(Path file, SceneFile scene, int samples, int half, int index)
      throws IOException, InterruptedException {
    double start = cpu();
    NoisyPicture noisy = NoisyPicture.of(film(scene, samples, 0));
    List<float[]> left = new ArrayList<>();
    Image image = BuiltInDenoiser.denoise(noisy, threads(), left::add).image();
    double seconds = cpu() - start;
    Path part = file.resolveSibling("part");
    try (DataOutputStream out = new DataOutputStream(Files.newOutputStream(part))) {
      out.writeDouble(seconds);
      out.writeInt(image.width());
      out.writeInt(image.height());
      write(out, noisy.light().mean());
      write(out, noisy.albedo().orElseThrow().mean());
      write(out, noisy.normal().orElseThrow().mean());
      write(out, noisy.alpha());
      write(out, image.rgb());
      float[] alpha = new float[image.hasAlpha() ? image.width() * image.height() : 0];
      for (int i = 0; i < alpha.length; i++) {
        alpha[i] = image.alpha(i % image.width(), i / image.width());
      }
      write(out, alpha);
      write(out, left.get(0));
      write(out, film(scene, half, 2L * index + 1).develop().rgb());
      write(out, film(scene, half, 2L * index + 2).develop().rgb());
    }
    Files.move(part, file);
  }

  private static void write(DataOutputStream out, float[] values) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(4 * values.length);
    bytes.asFloatBuffer().put(values);
    out.writeInt(values.length);
    out.write(bytes.array());
  }

  private static float[] read(DataInputStream in) throws IOException {
    float[] values = new float[in.readInt()];
    InputStream stream = in;
    ByteBuffer.wrap(stream.readNBytes(4 * values.length)).asFloatBuffer().get(values);
    return values;
  }

  private static Optional<Halves> guide(float[] mean) {
    return Optional.of(unknown(mean));
  }

  private static Halves unknown(float[] mean) {
    return new Halves(mean, new float[0]);
  }

  private static Film film(SceneFile file, int samples, long seed) throws InterruptedException {
    FilmRenderer renderer = new FilmRenderer(settings(file, samples, seed), file.scene());
    Film film = renderer.newFilm();
    renderer.addSamples(film, samples, Progress.NONE);
    return film;
  }

  private static RenderSettings settings(SceneFile file, int samples, long seed) {
    return file.settings().toBuilder()
        .samples(samples)
        .seed(seed)
        .set(Setting.LAYERS, Layer.FOR_DENOISING)
        .build();
  }

  /** Returns what the frame shows. */
  SeenFrame seen(Optional<SeenFrame> like) throws InterruptedException {
    return SeenFrame.of(
        file.scene(), settings(file, 1, 0), noisy, alone, left, like, threads());
  }

  /** Returns the same points with other values, without divisors. */
  SeenFrame showing(Image values, SeenFrame like) throws InterruptedException {
    float[] none = new float[3 * values.width() * values.height()];
    NoisyPicture plain =
        new NoisyPicture(
            values.width(),
            values.height(),
            unknown(none),
            Optional.empty(),
            noisy.normal(),
            noisy.alpha(),
            0);
    return SeenFrame.of(
        file.scene(), settings(file, 1, 0), plain, values, none, Optional.of(like), threads());
  }

  /** Returns the error of a picture, in steps of 8 bits. */
  Image error(Image image) {
    return combined(inSteps(image), inSteps(reference), 1, -1);
  }

  static int threads() {
    return Runtime.getRuntime().availableProcessors();
  }

  static double cpu() {
    return 1e-9 * ProcessHandle.current().info().totalCpuDuration().orElseThrow().toNanos();
  }

  static Image combined(Image one, Image other, double a, double b) {
    float[] values = new float[one.rgb().length];
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) (a * one.rgb()[i] + b * other.rgb()[i]);
    }
    return new Image(one.width(), one.height(), values, new float[0]);
  }

  static Image inSteps(Image linear) {
    float[] values = new float[linear.rgb().length];
    float[] rgb = linear.rgb();
    for (int i = 0; i < values.length; i += 3) {
      Rgb color = ToneCurve.SRGB.apply(new Rgb(rgb[i], rgb[i + 1], rgb[i + 2]));
      values[i] = (float) (255 * color.r());
      values[i + 1] = (float) (255 * color.g());
      values[i + 2] = (float) (255 * color.b());
    }
    return new Image(linear.width(), linear.height(), values, new float[0]);
  }
}
