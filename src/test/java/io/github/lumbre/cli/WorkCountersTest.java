package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The program does not do more work than before: ray counts, which need no clock, are compared with
 * stored ones. Less work passes; update the stored counts then to keep the gain.
 */
class WorkCountersTest {
  private static final Path STORED = Path.of("src", "test", "resources", "work-counters.csv");

  /** The maximum relative growth of the counters. */
  private static final double GROWTH = .005;

  private static final String ADVICE =
      "If that is explained, store it: ./mvnw test -Dtest=WorkCountersTest -Dlumbre.counters=store";

  @Test
  void workHasNotGrown() throws Exception {
    List<WorkCounters> found = WorkCounters.ofScenes(Path.of("scenes"));
    if ("store".equals(System.getProperty("lumbre.counters"))) {
      store(found);
    }
    assertThat(complaints(stored(), found)).as(ADVICE).isEmpty();
  }

  private static List<WorkCounters> stored() throws IOException {
    return Files.readAllLines(STORED).stream().skip(1).map(WorkCounters::parse).toList();
  }

  private static void store(List<WorkCounters> found) throws IOException {
    Stream<String> lines = found.stream().map(WorkCounters::line);
    Files.writeString(
        STORED,
        Stream.concat(Stream.of(WorkCounters.HEADER), lines)
            .map(line -> line + "\n")
            .collect(Collectors.joining()));
  }

  private static List<String> complaints(List<WorkCounters> stored, List<WorkCounters> found) {
    List<String> complaints = new ArrayList<>();
    for (WorkCounters now : found) {
      stored.stream()
          .filter(now::isOfSame)
          .findFirst()
          .ifPresentOrElse(
              before -> complain(before, now, complaints),
              () -> complaints.add(now.scene() + ", " + now.mode() + ": nothing is stored"));
    }
    return complaints;
  }

  private static void complain(WorkCounters before, WorkCounters now, List<String> complaints) {
    String what = now.scene() + ", " + now.mode() + ": ";
    complain(what + "samples", before.samples(), now.samples(), complaints);
    complain(what + "rays", before.rays(), now.rays(), complaints);
    complain(what + "shadow rays", before.shadowRays(), now.shadowRays(), complaints);
  }

  private static void complain(String what, long before, long now, List<String> complaints) {
    if (now > before * (1 + GROWTH)) {
      complaints.add(
          String.format(
              Locale.ROOT,
              "%s grew from %d to %d, by %.2f %%, and may by %.1f %%",
              what,
              before,
              now,
              100 * (now / (double) before - 1),
              100 * GROWTH));
    }
  }

  @Test
  void growthIsNoticedCounterByCounter() {
    WorkCounters before = new WorkCounters("tiny", "path", 100, 1000, 2000);
    assertThat(complaints(List.of(before), List.of(before))).isEmpty();
    WorkCounters within = new WorkCounters("tiny", "path", 100, 1004, 1900);
    assertThat(complaints(List.of(before), List.of(within))).isEmpty();
    WorkCounters beyond = new WorkCounters("tiny", "path", 101, 1006, 2011);
    assertThat(complaints(List.of(before), List.of(beyond)))
        .containsExactly(
            "tiny, path: samples grew from 100 to 101, by 1.00 %, and may by 0.5 %",
            "tiny, path: rays grew from 1000 to 1006, by 0.60 %, and may by 0.5 %",
            "tiny, path: shadow rays grew from 2000 to 2011, by 0.55 %, and may by 0.5 %");
    assertThat(complaints(List.of(), List.of(before)))
        .containsExactly("tiny, path: nothing is stored");
  }
}
