import com.sun.management.OperatingSystemMXBean;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Renders with Lumbre on command, so that another program can let it take turns with other
 * renderers while its virtual machine stays warm. A command is a line of standard input, an answer
 * a JSON object in a line of standard output; nothing runs in between.
 *
 * <pre>
 * load PATH WIDTH HEIGHT DEPTH [SPLIT]
 * render SAMPLES SEED THREADS FILE    FILE gets the floats of the picture, or is -
 * </pre>
 */
final class RenderServer {
  private static final OperatingSystemMXBean PROCESS =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  private SceneFile scene;

  private RenderServer() {}

  public static void main(String[] args) throws Exception {
    RenderServer server = new RenderServer();
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String line = in.readLine(); line != null; line = in.readLine()) {
      System.out.println(server.answer(line.split(" ")));
    }
  }

  private String answer(String[] words) throws Exception {
    return switch (words[0]) {
      case "load" -> load(words);
      case "render" -> render(words);
      default -> throw new IllegalArgumentException("no such command: " + words[0]);
    };
  }

  private String load(String[] words) throws Exception {
    int width = Integer.parseInt(words[2]);
    int height = Integer.parseInt(words[3]);
    int depth = Integer.parseInt(words[4]);
    int split = words.length > 5 ? Integer.parseInt(words[5]) : 1;
    long start = System.nanoTime();
    scene =
        new SceneParser()
            .overriding(
                s -> s.toBuilder().size(width, height).maxTraceDepth(depth).split(split).build())
            .parse(Path.of(words[1]));
    return String.format(Locale.ROOT, "{\"seconds\": %.6f}", seconds(start));
  }

  private String render(String[] words) throws Exception {
    RenderSettings settings =
        scene.settings().toBuilder()
            .samples(Integer.parseInt(words[1]))
            .seed(Long.parseLong(words[2]))
            .threads(Integer.parseInt(words[3]))
            .build();
    PictureRenderer renderer = new PictureRenderer(settings);
    long cpuStart = PROCESS.getProcessCpuTime();
    long start = System.nanoTime();
    RenderResult result = renderer.render(scene.scene(), Progress.NONE);
    double seconds = seconds(start);
    double cpu = (PROCESS.getProcessCpuTime() - cpuStart) * 1e-9;
    if (!words[4].equals("-")) {
      write(result.image().rgb(), Path.of(words[4]));
    }
    RenderStatistics statistics = result.statistics();
    return String.format(
        Locale.ROOT,
        "{\"cpu\": %.6f, \"seconds\": %.6f, \"samples\": %d, \"rays\": %d}",
        cpu,
        seconds,
        statistics.samples(),
        statistics.rays() + statistics.shadowRays());
  }

  private static double seconds(long start) {
    return (System.nanoTime() - start) * 1e-9;
  }

  private static void write(float[] values, Path file) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    bytes.asFloatBuffer().put(values);
    Files.write(file, bytes.array());
  }
}
