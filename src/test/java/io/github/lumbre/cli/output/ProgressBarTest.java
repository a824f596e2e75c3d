package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Tests how the progress bar is drawn and erased. */
class ProgressBarTest {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private double now;
  private Optional<Integer> columns = Optional.of(60);
  private final TerminalWidth width = TerminalWidth.measuredBy(() -> columns);

  private ProgressBar bar(boolean hasEscapes) {
    return bar("", hasEscapes);
  }

  private ProgressBar bar(String title, boolean hasEscapes) {
    PrintStream out = new PrintStream(bytes, true, StandardCharsets.UTF_8);
    return ProgressBar.manual(title, out, width, hasEscapes, () -> now);
  }

  private String printed() {
    String text = bytes.toString(StandardCharsets.UTF_8);
    bytes.reset();
    return text;
  }

  @Test
  void barIsDrawnInPlaceAndErasedAtTheEnd() {
    ProgressBar bar = bar(true);
    bar.started(1000);
    bar.advanced(250);
    now = 1;
    bar.tick();
    assertThat(printed()).startsWith("\r 25 % [").endsWith("250 samples/s\033[K\r");
    bar.close();
    assertThat(printed()).isEqualTo("\r\033[J");
    bar.tick();
    assertThat(printed()).isEmpty();
  }

  @Test
  void titlesTakeAtMostAThirdOfTheLine() {
    ProgressBar bar = bar("3/12 \u001bwooden-chair.png", true);
    bar.started(1000);
    bar.advanced(250);
    now = 1;
    bar.tick();
    assertThat(printed()).startsWith("\r3/12 \\u001bwooden-ch:  25 % 0:00:03 left, 250 samples/s");
    bar.busy("reading chair.glb");
    now = 2;
    bar.tick();
    assertThat(printed()).startsWith("\r3/12 \\u001bwooden-ch: reading chair.glb ... 0:00:01");
  }

  @Test
  void terminalWithoutEscapesGetsBlanks() {
    ProgressBar bar = bar(false);
    bar.started(1000);
    bar.tick();
    assertThat(printed()).endsWith("0 samples/s\r");
    bar.close();
    assertThat(printed()).matches("\r {40,59}\r");
  }

  @Test
  void narrowerWindowIsErasedFirst() {
    ProgressBar bar = bar(true);
    bar.started(1000);
    bar.tick();
    printed();
    columns = Optional.of(30);
    bar.tick();
    assertThat(printed()).hasSizeGreaterThan(40);
    width.change();
    bar.tick();
    assertThat(printed()).startsWith("\r\033[J\r  0 %").hasSizeLessThan(40);
  }

  @Test
  void readingIsShownOnceItTakesAWhile() {
    ProgressBar bar = bar(true);
    bar.busy("reading big\033.json");
    now = 0.5;
    bar.tick();
    assertThat(printed()).isEmpty();
    now = 2;
    bar.tick();
    assertThat(printed()).isEqualTo("\rreading big\\u001b.json ... 0:00:02\033[K\r");
    bar.started(10);
    bar.tick();
    assertThat(printed()).startsWith("\r  0 %");
  }

  @Test
  void suspensionIsNoTimeOfTheRender() {
    ProgressBar bar = bar(true);
    bar.started(1000);
    for (now = 0; now < 10; now++) {
      bar.tick();
    }
    now = 1009;
    bar.advanced(100);
    bar.tick();
    printed();
    now = 1010;
    bar.tick();
    assertThat(printed()).contains("10 samples/s", "0:01:30 left");
  }

  @Test
  void furtherSamplesMakeATotal() {
    ProgressBar bar = bar(true);
    bar.started(0);
    bar.advanced(100);
    now = 1;
    bar.tick();
    assertThat(printed()).contains("? %");
    bar.expected(100);
    bar.tick();
    assertThat(printed()).contains(" 50 %");
  }

  @Test
  void widthIsTakenFromTheAnswerOfStty() {
    assertThat(TerminalWidth.parsed("132\n")).contains(132);
    assertThat(TerminalWidth.parsed("0")).isEmpty();
    assertThat(TerminalWidth.parsed("")).isEmpty();
    assertThat(TerminalWidth.parsed("standard input")).isEmpty();
    columns = Optional.empty();
    assertThat(width.columns()).isPositive();
  }

  /** Short activities one after the other are shown, too. */
  @Test
  void whatFollowsTheSamplesIsSoonShown() {
    ProgressBar bar = bar(true);
    bar.started(1000);
    bar.advanced(1000);
    now = 1;
    bar.tick();
    assertThat(printed()).contains("100 %");
    bar.busy("developing");
    now = 1.5;
    bar.tick();
    assertThat(printed()).isEmpty();
    bar.busy("denoising");
    now = 2;
    bar.tick();
    assertThat(printed()).isEqualTo("\rdenoising ... 0:00:01\033[K\r");
    bar.busy("writing a.png");
    now = 4;
    bar.tick();
    assertThat(printed()).isEqualTo("\rwriting a.png ... 0:00:02\033[K\r");
  }
}
