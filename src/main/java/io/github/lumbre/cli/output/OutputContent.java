package io.github.lumbre.cli.output;

import io.github.lumbre.image.format.png.PngFile;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.render.checkpoint.FilmFile;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Predicate;

/** The kinds of files that commands write, and tests that recognize existing ones. */
public enum OutputContent {
  PICTURE("a PNG, JPEG, OpenEXR, PFM, HDR or SVG picture", OutputContent::startsPicture),
  ANIMATION("a GIF, PNG, MP4 or WebM file", OutputContent::startsAnimation),
  FILM("a checkpoint file", FilmFile::startsIn),
  SCENE("a JSON scene", text(start -> start.contains("\"mainCameraId\""))),
  TRADE_PAGE(
      "a page of 'lumbre trade'",
      text(start -> start.startsWith("<!DOCTYPE html>") && start.contains("Speed for accuracy"))),
  DIFF_PAGE(
      "a page of 'lumbre diff'",
      text(start -> start.startsWith("<!DOCTYPE html>") && start.contains("What changed"))),
  TRADE_CSV("a CSV file of 'lumbre trade'", text(start -> start.startsWith("knob,value,kind,"))),
  TRADE_JSON(
      "a JSON file of 'lumbre trade'",
      text(start -> start.contains("\"format\": \"lumbre-trade-"))),
  BENCH_JSON(
      "a JSON file of 'lumbre perf'", text(start -> start.contains("\"format\": \"lumbre-bench-"))),
  BENCHMARK_CSV(
      "a CSV file of 'lumbre benchmark'", text(start -> start.startsWith("row,name,scene,size,"))),
  HASHES(
      "a file of 'lumbre benchmark --store'",
      text(start -> start.startsWith("row,scene,size,samples,sha256")));

  private static final int START_BYTES = 4096;

  private final String description;
  private final Predicate<byte[]> isStart;

  OutputContent(String description, Predicate<byte[]> isStart) {
    this.description = description;
    this.isStart = isStart;
  }

  private static Predicate<byte[]> text(Predicate<String> isStart) {
    return start -> isStart.test(new String(start, StandardCharsets.UTF_8));
  }

  private static boolean startsPicture(byte[] start) {
    return ImageFormat.startsPicture(start) || text(t -> t.contains("<svg ")).test(start);
  }

  private static boolean startsAnimation(byte[] start) {
    String text = new String(start, StandardCharsets.ISO_8859_1);
    return text.startsWith("GIF8")
        || PngFile.startsIn(start)
        || text.startsWith("ftyp", 4)
        || text.startsWith("\u001aE\u00df\u00a3");
  }

  /** Returns the name of the kind for messages, with its article. */
  String description() {
    return description;
  }

  /**
   * Returns whether a new file of this kind may replace an existing file: it is empty or begins
   * like a file of this kind.
   *
   * @throws IOException if the file cannot be read
   */
  boolean mayReplace(Path existing) throws IOException {
    try (InputStream in = Files.newInputStream(existing)) {
      byte[] start = in.readNBytes(START_BYTES);
      return start.length == 0 || isStart.test(start);
    }
  }
}
