package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Measures the memory of {@code lumbre view} and of its page in a browser while it renders for
 * long: {@code -Pendurance}, 30 min or {@code -Dlumbre.endurance.minutes}. The measurements are in
 * {@code target/browser/view-endurance.tsv}.
 */
@Tag("endurance")
class ViewEnduranceTest {
  private static final Path SCENE = Path.of("scenes", "cornell-box.json");
  private static final Path TABLE = Path.of("target", "browser", "view-endurance.tsv");
  private static final long MEBIBYTE = 1 << 20;
  private static final Pattern ADDRESS = Pattern.compile("http://\\S+");

  /**
   * The memory of both sides at one moment, in bytes.
   *
   * @param page JavaScript's heap, after a garbage collection
   * @param nodes of the page's document, with detached ones
   * @param browser resident memory of the browser's process for the page
   * @param state size of the state that the page receives
   */
  private record Sample(
      double minutes,
      double samples,
      long heap,
      long resident,
      long page,
      long nodes,
      long browser,
      long state) {
    private static final String HEAD =
        "minutes\tsamples\theap KiB\tprocess KiB\tpage heap KiB\tnodes\tbrowser KiB\tstate bytes\n";

    private String line() {
      return "%.1f\t%.0f\t%d\t%d\t%d\t%d\t%d\t%d%n"
          .formatted(
              minutes,
              samples,
              heap >> 10,
              resident >> 10,
              page >> 10,
              nodes,
              browser >> 10,
              state);
    }
  }

  @Test
  void memoryOfBothSidesDoesNotGrow() throws Exception {
    long minutes = Long.getLong("lumbre.endurance.minutes", 30);
    StringWriter out = new StringWriter();
    FutureTask<Integer> view = new FutureTask<>(() -> view(new PrintWriter(out, true)));
    Thread thread = new Thread(view, "view-endurance");
    thread.start();
    List<Sample> found = new ArrayList<>();
    Files.createDirectories(TABLE.getParent());
    StringBuilder table = new StringBuilder(Sample.HEAD);
    try (Browser browser = Browser.start()) {
      browser.open(address(out), 1280, 800, false);
      browser.forgetRequests();
      long start = System.nanoTime();
      for (long minute = 1; minute <= minutes; minute++) {
        long end = start + TimeUnit.MINUTES.toNanos(minute);
        TimeUnit.NANOSECONDS.sleep(end - System.nanoTime());
        Sample sample = sample(browser, (System.nanoTime() - start) / 60e9);
        found.add(sample);
        table.append(sample.line());
        Files.writeString(TABLE, table);
      }
      assertThat(browser.complaints()).isEmpty();
    } finally {
      thread.interrupt();
      thread.join();
    }
    assertThat(view.get()).isEqualTo(130);
    assertFlat(found);
  }

  private static int view(PrintWriter out) {
    String[] args = {
      "view",
      SCENE.toString(),
      "--no-open",
      "--size",
      "160x120",
      "--threads",
      "1",
      "--layers",
      "normal",
      "--samples",
      "1000000"
    };
    return Lumbre.run(args, out, new PrintWriter(Writer.nullWriter()));
  }

  private static URI address(StringWriter out) throws InterruptedException {
    for (int i = 0; i < 600; i++) {
      Matcher matcher = ADDRESS.matcher(out.toString());
      if (matcher.find()) {
        return URI.create(matcher.group());
      }
      Thread.sleep(100);
    }
    throw new AssertionError("no address: " + out);
  }

  private static Sample sample(Browser browser, double minutes) throws Exception {
    String[] state = state(browser).split(" ");
    return new Sample(
        minutes,
        Double.parseDouble(state[1]),
        MemoryInUse.heap(),
        MemoryInUse.resident(),
        browser.metric("JSHeapUsedSize"),
        browser.metric("Nodes"),
        browser.rendererMemory(),
        Long.parseLong(state[0]));
  }

  /** Returns the size of the state in bytes, and the samples per pixel. */
  private static String state(Browser browser) throws InterruptedException {
    browser.evaluate(
        """
        (window.found = '', fetch('state?since=0').then(a => a.text())
          .then(t => { window.found = t.length + ' ' + JSON.parse(t).render.samples; }), '')
        """);
    for (int i = 0; i < 600; i++) {
      String found = browser.evaluate("window.found");
      if (!found.isEmpty()) {
        return found;
      }
      Thread.sleep(50);
    }
    throw new AssertionError("the page has no state");
  }

  /** Compares with the third minute: before, both sides still load and compile code. */
  private static void assertFlat(List<Sample> found) {
    assertThat(found).hasSizeGreaterThan(3);
    Sample first = found.get(2);
    List<Sample> later = found.subList(3, found.size());
    assertThat(found.get(found.size() - 1).samples).isGreaterThan(first.samples);
    assertThat(later).allMatch(now -> now.heap <= first.heap + MEBIBYTE);
    assertThat(later).allMatch(now -> now.resident <= first.resident + 16 * MEBIBYTE);
    assertThat(later).allMatch(now -> now.page <= first.page + MEBIBYTE);
    assertThat(later).allMatch(now -> now.nodes <= first.nodes + 500);
    assertThat(later).allMatch(now -> now.browser <= first.browser + 32 * MEBIBYTE);
    assertThat(later).allMatch(now -> now.state <= 40_000);
  }
}
