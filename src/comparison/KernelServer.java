import com.sun.management.OperatingSystemMXBean;
import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Searches meshes for what rays meet with Lumbre's hierarchy, on command; the twin of
 * embree_server.cpp. A command is a line of standard input, an answer a JSON object in a line of
 * standard output.
 *
 * <pre>
 * load MESH             see below
 * rays FILE             floats: origin, direction, length (infinite: no end), seven for each ray
 * closest TIMES         searches for the nearest hit of every ray, so many times
 * any TIMES             searches for any hit before each ray's end, so many times
 * hits FILE             writes of each ray's nearest hit, in floats, distance and unit normal; the
 *                       distance is infinite where there is none
 * </pre>
 *
 * <p>A mesh is two files, all little-endian: MESH.positions, three floats for each vertex, and
 * MESH.indices, three integers of 32 bits for each triangle.
 */
final class KernelServer {
  private static final OperatingSystemMXBean PROCESS =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
  private static final int FLOATS_PER_RAY = 7;

  private final NearestHit nearest = new NearestHit();
  private Mesh mesh;
  private Bvh bvh;
  private float[] rays;

  private KernelServer() {}

  public static void main(String[] args) throws IOException {
    KernelServer server = new KernelServer();
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String line = in.readLine(); line != null; line = in.readLine()) {
      String[] words = line.split(" ");
      System.out.println(server.answer(words[0], words[1]));
    }
  }

  private String answer(String command, String argument) throws IOException {
    long cpu = PROCESS.getProcessCpuTime();
    long start = System.nanoTime();
    long hits =
        switch (command) {
          case "load" -> load(argument);
          case "rays" -> readRays(argument);
          case "closest" -> repeat(Integer.parseInt(argument), this::closest);
          case "any" -> repeat(Integer.parseInt(argument), this::any);
          case "hits" -> writeHits(argument);
          default -> throw new IllegalArgumentException("no such command: " + command);
        };
    return String.format(
        Locale.ROOT,
        "{\"cpu\": %.6f, \"seconds\": %.6f, \"hits\": %d}",
        (PROCESS.getProcessCpuTime() - cpu) * 1e-9,
        (System.nanoTime() - start) * 1e-9,
        hits);
  }

  private interface Search {
    int hits();
  }

  private static long repeat(int times, Search search) {
    long hits = 0;
    for (int i = 0; i < times; i++) {
      hits = search.hits();
    }
    return hits;
  }

  private long load(String name) throws IOException {
    mesh = null;
    bvh = null;
    ByteBuffer positions = read(name + ".positions");
    double[] coordinates = new double[positions.remaining() / Float.BYTES];
    Arrays.setAll(coordinates, i -> positions.getFloat(Float.BYTES * i));
    ByteBuffer corners = read(name + ".indices");
    int[] indices = new int[corners.remaining() / Integer.BYTES];
    corners.asIntBuffer().get(indices);
    TriangleMesh triangles = TriangleMesh.of(coordinates, new double[0], new double[0], indices);
    mesh = Mesh.baked(triangles, Transform.IDENTITY);
    bvh = Bvh.over(List.of(mesh), Kernel.VECTOR);
    return indices.length / 3;
  }

  private long readRays(String file) throws IOException {
    ByteBuffer bytes = read(file);
    rays = new float[bytes.remaining() / Float.BYTES];
    bytes.asFloatBuffer().get(rays);
    return rays.length / FLOATS_PER_RAY;
  }

  private void aim(int at, double length) {
    float[] r = rays;
    nearest.aim(r[at], r[at + 1], r[at + 2], r[at + 3], r[at + 4], r[at + 5], length);
  }

  private int closest() {
    int hits = 0;
    for (int at = 0; at < rays.length; at += FLOATS_PER_RAY) {
      aim(at, Double.POSITIVE_INFINITY);
      if (bvh.intersect(nearest)) {
        hits++;
      }
    }
    return hits;
  }

  private int any() {
    int hits = 0;
    for (int at = 0; at < rays.length; at += FLOATS_PER_RAY) {
      aim(at, rays[at + 6]);
      if (bvh.isOccluded(nearest)) {
        hits++;
      }
    }
    return hits;
  }

  private long writeHits(String file) throws IOException {
    int count = rays.length / FLOATS_PER_RAY;
    ByteBuffer bytes = ByteBuffer.allocate(4 * Float.BYTES * count).order(ByteOrder.LITTLE_ENDIAN);
    for (int at = 0; at < rays.length; at += FLOATS_PER_RAY) {
      aim(at, Double.POSITIVE_INFINITY);
      if (bvh.intersect(nearest)) {
        Vec3 normal = mesh.surfaceAt(nearest).geometricNormal();
        bytes.putFloat((float) nearest.t()).putFloat((float) normal.x());
        bytes.putFloat((float) normal.y()).putFloat((float) normal.z());
      } else {
        bytes.putFloat(Float.POSITIVE_INFINITY).putFloat(0).putFloat(0).putFloat(0);
      }
    }
    try (FileChannel channel =
        FileChannel.open(
            Path.of(file),
            StandardOpenOption.CREATE,
            StandardOpenOption.WRITE,
            StandardOpenOption.TRUNCATE_EXISTING)) {
      channel.write(bytes.flip());
    }
    return count;
  }

  private static ByteBuffer read(String file) throws IOException {
    try (FileChannel channel = FileChannel.open(Path.of(file))) {
      return channel
          .map(FileChannel.MapMode.READ_ONLY, 0, channel.size())
          .order(ByteOrder.LITTLE_ENDIAN);
    }
  }
}
