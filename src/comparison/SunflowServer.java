import com.sun.management.OperatingSystemMXBean;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import org.sunflow.SunflowAPI;
import org.sunflow.core.Display;
import org.sunflow.image.Color;
import org.sunflow.math.Matrix4;
import org.sunflow.math.Point3;
import org.sunflow.math.Vector3;
import org.sunflow.system.UI;
import org.sunflow.system.ui.SilentInterface;

/**
 * Renders with Sunflow on command. Commands and answers are those of RenderServer.java, but the
 * scene is a file of sunflow_scene.py's, which knows its size and depth, samples are a power of
 * four, and there is no seed: Sunflow always makes the same picture.
 */
final class SunflowServer {
  private static final OperatingSystemMXBean PROCESS =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  private static final String LINEAR = "sRGB linear";

  private SunflowAPI scene;
  private int names;

  private SunflowServer() {}

  public static void main(String[] args) throws IOException {
    UI.set(new SilentInterface());
    SunflowServer server = new SunflowServer();
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String line = in.readLine(); line != null; line = in.readLine()) {
      String[] words = line.split(" ");
      System.out.println(words[0].equals("load") ? server.load(words) : server.render(words));
    }
  }

  private String load(String[] words) throws IOException {
    long start = System.nanoTime();
    scene = new SunflowAPI();
    try (BufferedReader file = Files.newBufferedReader(Path.of(words[1]))) {
      for (String line = file.readLine(); line != null; line = file.readLine()) {
        names++;
        String[] parts = line.split(" ", 2);
        add(parts[0], parts[1].split(" "));
      }
    }
    return String.format(Locale.ROOT, "{\"seconds\": %.6f}", seconds(start));
  }

  private void add(String kind, String[] values) {
    switch (kind) {
      case "frame" -> frame(floats(values, 0, 3));
      case "camera" -> camera(floats(values, 0, 11));
      case "matte" -> {
        scene.parameter("diffuse", LINEAR, floats(values, 1, 3));
        scene.shader(values[0], "diffuse");
      }
      case "mesh" -> {
        shape(values, 1);
        scene.geometry("mesh" + names, "triangle_mesh");
        scene.parameter("shaders", new String[] {values[0]});
        scene.instance("instance" + names, "mesh" + names);
      }
      case "lamp" -> {
        scene.parameter("radiance", LINEAR, floats(values, 0, 3));
        scene.parameter("samples", 1);
        shape(values, 3);
        scene.light("lamp" + names, "triangle_mesh");
      }
      default -> throw new IllegalArgumentException("no such line: " + kind);
    }
  }

  private void frame(float[] values) {
    scene.parameter("resolutionX", (int) values[0]);
    scene.parameter("resolutionY", (int) values[1]);
    scene.parameter("depths.diffuse", (int) values[2]);
    scene.parameter("gi.engine", "path");
    scene.parameter("gi.path.samples", 1);
    scene.parameter("aa.samples", 1);
    scene.parameter("aa.jitter", true);
    scene.parameter("filter", "box");
    scene.options(SunflowAPI.DEFAULT_OPTIONS);
  }

  private void camera(float[] v) {
    Point3 eye = new Point3(v[0], v[1], v[2]);
    Point3 target = new Point3(v[3], v[4], v[5]);
    Matrix4 place = Matrix4.lookAt(eye, target, new Vector3(v[6], v[7], v[8]));
    scene.parameter("transform", place);
    scene.parameter("fov", v[9]);
    scene.parameter("aspect", v[10]);
    scene.camera("camera", "pinhole");
    scene.parameter("camera", "camera");
    scene.options(SunflowAPI.DEFAULT_OPTIONS);
  }

  private void shape(String[] values, int at) {
    int coordinates = 3 * Integer.parseInt(values[at]);
    float[] corners = floats(values, at + 2 + coordinates, 3 * Integer.parseInt(values[at + 1]));
    int[] triangles = new int[corners.length];
    Arrays.setAll(triangles, i -> (int) corners[i]);
    scene.parameter("points", "point", "vertex", floats(values, at + 2, coordinates));
    scene.parameter("triangles", triangles);
  }

  private static float[] floats(String[] values, int from, int count) {
    float[] floats = new float[count];
    for (int i = 0; i < count; i++) {
      floats[i] = Float.parseFloat(values[from + i]);
    }
    return floats;
  }

  private String render(String[] words) throws IOException {
    int samples = Integer.parseInt(words[1]);
    int powerOfFour = Integer.numberOfTrailingZeros(samples) / 2;
    if (samples != 1 << (2 * powerOfFour)) {
      throw new IllegalArgumentException("samples: expected a power of four, found " + samples);
    }
    scene.parameter("aa.min", powerOfFour);
    scene.parameter("aa.max", powerOfFour);
    scene.parameter("threads", Integer.parseInt(words[3]));
    scene.parameter("threads.lowPriority", false);
    scene.options(SunflowAPI.DEFAULT_OPTIONS);
    Picture picture = new Picture();
    long cpuStart = PROCESS.getProcessCpuTime();
    long start = System.nanoTime();
    scene.render(SunflowAPI.DEFAULT_OPTIONS, picture);
    double seconds = seconds(start);
    double cpu = (PROCESS.getProcessCpuTime() - cpuStart) * 1e-9;
    if (!words[4].equals("-")) {
      picture.write(Path.of(words[4]));
    }
    return String.format(
        Locale.ROOT,
        "{\"cpu\": %.6f, \"seconds\": %.6f, \"samples\": %d}",
        cpu,
        seconds,
        (long) samples * picture.rgb.length / 3);
  }

  private static double seconds(long start) {
    return (System.nanoTime() - start) * 1e-9;
  }

  /** Gathers the linear values of the pixels. */
  private static final class Picture implements Display {
    private int width;
    private float[] rgb;

    @Override
    public void imageBegin(int w, int h, int bucketSize) {
      width = w;
      rgb = new float[3 * w * h];
    }

    @Override
    public void imagePrepare(int x, int y, int w, int h, int id) {}

    @Override
    public void imageUpdate(int x, int y, int w, int h, Color[] data, float[] alpha) {
      for (int i = 0; i < data.length; i++) {
        int pixel = (y + i / w) * width + x + i % w;
        System.arraycopy(data[i].getRGB(), 0, rgb, 3 * pixel, 3);
      }
    }

    @Override
    public void imageFill(int x, int y, int w, int h, Color c, float alpha) {
      throw new UnsupportedOperationException("Sunflow's renderer by buckets fills nothing");
    }

    @Override
    public void imageEnd() {}

    private void write(Path file) throws IOException {
      ByteBuffer bytes = ByteBuffer.allocate(4 * rgb.length).order(ByteOrder.LITTLE_ENDIAN);
      bytes.asFloatBuffer().put(rgb);
      Files.write(file, bytes.array());
    }
  }
}
