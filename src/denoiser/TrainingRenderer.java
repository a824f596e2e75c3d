import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.image.Image;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Renders scenes as a denoiser sees them, and what it should make of them. Arguments: folder of
 * scenes, folder of the results, side of the pictures in pixels, number of threads, seconds after
 * which no further scene is begun; then maybe width, height and samples of references instead.
 *
 * <p>For training, each scene's file has 9 pictures of 14 planes and a target of 6, as 32-bit
 * floats, little-endian: pictures of the samples 0; 0 to 1, 3, 7, 15, 31, 63; 2 to 3, 4 to 7.
 * Planes: light, its noise, albedo, normal (three each), noise of albedo, noise of normal. The
 * target has 64 later samples, or up to 256 where its noise is large, far from the others, since
 * near samples of a low-discrepancy sequence have errors of opposite signs: light and its noise. A
 * reference has the light of the samples from 1024 on alone.
 */
final class TrainingRenderer {
  static final int PLANES = 14;
  private static final int[] ENDS = {1, 2, 4, 8, 16, 32, 64};
  private static final int[] PARTS = {2, 4};
  private static final int FIRST_OF_TARGET = 1024;
  private static final int TARGET = 64;
  private static final int LARGEST_TARGET = 256;
  private static final double NOISY = 0.008;
  private static final double BLACK = 1e-4;
  private static final int MOST_MESSAGES = 20;

  private final Path results;
  private final int width;
  private final int height;
  private final int reference;
  private final AtomicInteger done = new AtomicInteger();
  private final AtomicInteger failed = new AtomicInteger();

  private TrainingRenderer(Path results, int width, int height, int reference) {
    this.results = results;
    this.width = width;
    this.height = height;
    this.reference = reference;
  }

  public static void main(String[] args) throws Exception {
    int side = Integer.parseInt(args[2]);
    int threads = Integer.parseInt(args[3]);
    long end = System.nanoTime() + (long) (1e9 * Double.parseDouble(args[4]));
    TrainingRenderer renderer =
        args.length > 5
            ? new TrainingRenderer(
                Path.of(args[1]),
                Integer.parseInt(args[5]),
                Integer.parseInt(args[6]),
                Integer.parseInt(args[7]))
            : new TrainingRenderer(Path.of(args[1]), side, side, 0);
    Files.createDirectories(renderer.results);
    List<Path> scenes = new ArrayList<>();
    Path folder = Path.of(args[0]);
    try (var files = Files.walk(folder)) {
      files
          .filter(file -> file.toString().endsWith(".json"))
          .sorted(Comparator.comparing(Path::getFileName).thenComparing(file -> file))
          .forEach(scenes::add);
    }
    ExecutorService pool = Executors.newFixedThreadPool(threads);
    for (Path scene : scenes) {
      String name = folder.relativize(scene).toString().replace('/', '-');
      pool.submit(() -> renderer.renderBefore(end, scene, name.replace(".json", ".bin")));
    }
    pool.shutdown();
    pool.awaitTermination(1, TimeUnit.DAYS);
    System.out.printf("%d scenes, %d failed%n", renderer.done.get(), renderer.failed.get());
  }

  private void renderBefore(long end, Path scene, String name) {
    if (System.nanoTime() > end || Files.exists(results.resolve(name))) {
      return;
    }
    try {
      write(results.resolve(name), planes(scene));
      done.incrementAndGet();
    } catch (Exception | OutOfMemoryError e) {
      if (failed.incrementAndGet() <= MOST_MESSAGES) {
        System.out.println(scene + ": " + e);
      }
    }
  }

  private List<float[]> planes(Path scene) throws Exception {
    int last = FIRST_OF_TARGET + Math.max(LARGEST_TARGET, reference);
    SceneFile file =
        new SceneParser()
            .overriding(settings -> settings.toBuilder().size(width, height).samples(last).build())
            .parse(scene);
    RenderSettings settings =
        file.settings().toBuilder()
            .set(Setting.LAYERS, Layer.FOR_DENOISING)
            .threads(1)
            .bucketSize(width)
            .build();
    FilmRenderer renderer = new FilmRenderer(settings, file.scene());
    if (reference > 0) {
      return List.of(planar(light(part(renderer, FIRST_OF_TARGET, last))));
    }
    Film target = part(renderer, FIRST_OF_TARGET, FIRST_OF_TARGET + TARGET);
    if (mean(light(target)) < BLACK) {
      throw new IOException("black");
    }
    for (int n = 2 * TARGET; n <= LARGEST_TARGET && relativeNoise(target) > NOISY; n *= 2) {
      renderer.addSamples(target, n, Progress.NONE);
    }
    List<float[]> planes = new ArrayList<>();
    Film film = renderer.newFilm();
    for (int end : ENDS) {
      renderer.addSamples(film, end, Progress.NONE);
      planes.add(picture(film));
    }
    for (int first : PARTS) {
      planes.add(picture(part(renderer, first, 2 * first)));
    }
    planes.add(planar(light(target)));
    planes.add(planar(target.developNoise()));
    return planes;
  }

  private static Film part(FilmRenderer renderer, int first, int end) throws InterruptedException {
    Film film = renderer.newFilm(first);
    renderer.addSamples(film, end - first, Progress.NONE);
    return film;
  }

  /** Returns the mean of squared noise over squared light. */
  private static double relativeNoise(Film film) {
    float[] light = light(film);
    float[] noise = film.developNoise();
    double sum = 0;
    for (int i = 0; i < light.length; i++) {
      double deviation = known(noise[i]);
      sum += deviation * deviation / (light[i] * (double) light[i] + 0.01);
    }
    return sum / light.length;
  }

  private static double mean(float[] values) {
    double sum = 0;
    for (float value : values) {
      sum += value;
    }
    return sum / values.length;
  }

  /** Returns the light of a film, not divided by alpha. */
  private static float[] light(Film film) {
    Image image = film.develop();
    double[] seen = PictureError.seen(image);
    float[] light = new float[seen.length];
    for (int i = 0; i < light.length; i++) {
      light[i] = (float) seen[i];
    }
    return light;
  }

  private static float[] picture(Film film) {
    float[] light = light(film);
    float[] noise = film.developNoise();
    float[] albedo = film.develop(Layer.DENOISING_ALBEDO);
    float[] albedoNoise = film.developNoise(Layer.DENOISING_ALBEDO);
    float[] normal = film.develop(Layer.DENOISING_NORMAL);
    float[] normalNoise = film.developNoise(Layer.DENOISING_NORMAL);
    int pixels = light.length / 3;
    float[] planes = new float[PLANES * pixels];
    for (int i = 0; i < pixels; i++) {
      for (int c = 0; c < 3; c++) {
        planes[c * pixels + i] = light[3 * i + c];
        planes[(3 + c) * pixels + i] = known(noise[3 * i + c]);
        planes[(6 + c) * pixels + i] = albedo[3 * i + c];
        planes[(9 + c) * pixels + i] = normal[3 * i + c];
      }
      planes[12 * pixels + i] = length(albedoNoise, i);
      planes[13 * pixels + i] = length(normalNoise, i);
    }
    return planes;
  }

  private static float length(float[] noise, int pixel) {
    double sum = 0;
    for (int c = 0; c < 3; c++) {
      double value = known(noise[3 * pixel + c]);
      sum += value * value;
    }
    return (float) Math.sqrt(sum);
  }

  /** Returns noise, or 0 where a single sample tells none. */
  private static float known(float noise) {
    return Float.isFinite(noise) ? noise : 0;
  }

  private static float[] planar(float[] values) {
    int pixels = values.length / 3;
    float[] planes = new float[values.length];
    for (int i = 0; i < values.length; i++) {
      planes[i % 3 * pixels + i / 3] = known(values[i]);
    }
    return planes;
  }

  private static void write(Path file, List<float[]> planes) throws IOException {
    int count = planes.stream().mapToInt(part -> part.length).sum();
    ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * count).order(ByteOrder.LITTLE_ENDIAN);
    planes.forEach(
        part -> {
          for (float value : part) {
            bytes.putFloat(value);
          }
        });
    Path part = Path.of(String.format(Locale.ROOT, "%s.part", file));
    Files.write(part, bytes.array());
    Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
  }
}
