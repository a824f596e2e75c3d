package io.github.lumbre.lab.perf;

import com.sun.management.OperatingSystemMXBean;
import io.github.lumbre.render.BucketRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.lang.management.ManagementFactory;

/**
 * A render with its times and allocated memory.
 *
 * @param seconds wall-clock time
 * @param cpuSeconds CPU time of the whole process, summed over processors, including JIT
 *     compilation and garbage collection
 * @param allocatedBytes bytes allocated by the rendering threads
 */
public record TimedRender(
    RenderResult result, double seconds, double cpuSeconds, long allocatedBytes) {
  private static final OperatingSystemMXBean PROCESS =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  /** Renders a scene and measures the render. */
  public static TimedRender of(Scene scene, RenderSettings settings, Progress progress)
      throws InterruptedException {
    AllocationMeter meter = new AllocationMeter(progress);
    BucketRenderer renderer = new BucketRenderer(settings);
    long cpuStart = PROCESS.getProcessCpuTime();
    long start = System.nanoTime();
    RenderResult result = renderer.render(scene, meter);
    double seconds = (System.nanoTime() - start) * 1e-9;
    double cpuSeconds = (PROCESS.getProcessCpuTime() - cpuStart) * 1e-9;
    return new TimedRender(result, seconds, cpuSeconds, meter.bytes());
  }
}
