package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.RenderCommand.Invocation;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.run.Frames;
import io.github.lumbre.image.Dither;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.ContactSheet.Grid;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.stage.drawing.DisplayLight;
import io.github.lumbre.stage.drawing.NamedSheet;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** Renders several scenes onto one contact sheet. Mutable, for one run. */
final class RenderSheet {
  /** The longer side of a cell's picture without a flag, in pixels. */
  private static final FrameSize CELL = new FrameSize(256, OptionalInt.empty());

  /** The pictures and the sheet, each with up to four numbers of four bytes for a pixel. */
  private static final long BYTES_PER_PIXEL = 32;

  private final RenderOptions options;
  private final Invocation invocation;
  private final Batch batch;
  private final Path target;
  private final NamedSheet sheet;

  /** Renders the scenes in turn, and returns the highest of their exit codes. */
  interface Batch {
    ExitCode run(Invocation invocation, Frames frames) throws Exception;
  }

  RenderSheet(RenderOptions options, Invocation shared, Batch batch) {
    this.options = options;
    this.batch = batch;
    invocation = shared;
    target = options.to.sheet().orElseThrow();
    sheet = new NamedSheet(names(shared.scenes()));
    options.flags.sizeUnlessGiven(CELL);
  }

  /** Returns the names of files, with those of their folders where files have the same name. */
  static List<String> names(List<Path> scenes) {
    List<String> names = new ArrayList<>();
    scenes.forEach(scene -> names.add(String.valueOf(scene.getFileName())));
    List<String> all = List.copyOf(names);
    for (int i = 0; i < all.size(); i++) {
      Path folder = scenes.get(i).toAbsolutePath().normalize().getParent();
      if (Collections.frequency(all, all.get(i)) > 1 && folder.getFileName() != null) {
        names.set(i, folder.getFileName() + "/" + all.get(i));
      }
    }
    return names;
  }

  /**
   * Renders the scenes, and writes the sheet if there is a picture for it.
   *
   * @return the highest of the exit codes
   */
  ExitCode run() throws Exception {
    JsonSummary report = new JsonSummary("render", "sheet", target);
    return options
        .run
        .border(invocation.interruption(), Optional.empty())
        .of(report, () -> run(report));
  }

  private ExitCode run(JsonSummary report) throws Exception {
    options.checkOutputs(invocation.scenes(), "--sheet", List.of(target));
    try (PictureOutput output = PictureOutput.reserve(target, options.checkpoints.fallback());
        Frames frames =
            new Frames(invocation.scenes(), invocation.interruption(), invocation.deadline())) {
      frames.reservePartsOf(target);
      frames.checkedBy(settings -> requireFits(settings, frames));
      try {
        return batch.run(receiving(frames), frames);
      } finally {
        options.run.aboutAll();
        write(output, frames, report);
      }
    }
  }

  private Invocation receiving(Frames frames) {
    return new Invocation(
        invocation.start(),
        invocation.startup(),
        invocation.deadline(),
        invocation.interruption(),
        invocation.scenes(),
        drawn -> sheet.put(frames.index(), shown(drawn)),
        Optional.empty());
  }

  private static Image shown(DisplayLight drawn) {
    return DisplayLight.of(drawn.image(), drawn.options()).inSrgb();
  }

  /** Requires that the sheet fits into its format and into memory; otherwise all scenes fail. */
  private void requireFits(RenderSettings settings, Frames frames) throws TaskException {
    Crop window = settings.window();
    Grid grid = sheet.gridWith(window.width(), window.height());
    Optional<String> limit = limit(grid);
    if (limit.isPresent()) {
      frames.endAll();
      throw ExitCode.LIMIT.failure(
          "%s: would have %dx%d pixels, but %s; choose a smaller --size or fewer scenes"
              .formatted(target, grid.sheetWidth(), grid.sheetHeight(), limit.get()));
    }
  }

  /** Returns the limit that a sheet exceeds; empty if it can be written. */
  private Optional<String> limit(Grid grid) {
    boolean isJpeg = ImageFormat.of(target).equals(Optional.of(ImageFormat.JPG));
    long side = Math.max(grid.sheetWidth(), grid.sheetHeight());
    if (grid.pixels() > ImageReader.MAX_PIXELS) {
      return Optional.of("a sheet has at most 2^28 pixels");
    }
    if (isJpeg && side > ImageWriter.MAX_JPEG_SIDE) {
      return Optional.of(
          "a JPEG has at most %d pixels on a side".formatted(ImageWriter.MAX_JPEG_SIDE));
    }
    long bytes = BYTES_PER_PIXEL * grid.pixels();
    long heap = Runtime.getRuntime().maxMemory();
    return bytes > heap
        ? Optional.of(
            "needs %s, and the maximum heap size is %s; %s"
                .formatted(
                    MemoryEstimate.mebibytes(bytes),
                    MemoryEstimate.mebibytes(heap),
                    MemoryCheck.advice(bytes)))
        : Optional.empty();
  }

  /** Writes the sheet if it has a picture; partial if a signal or the deadline came before. */
  private void write(PictureOutput output, Frames frames, JsonSummary report)
      throws TaskException {
    Grid grid = sheet.grid();
    boolean isEmpty = sheet.count() == 0;
    describe(report, grid, frames);
    long unreadable = sheet.unreadable();
    if (!isEmpty) {
      output.write(sheet.image(), options(frames));
    }
    if (!isEmpty && unreadable > 0) {
      String names = unreadable == 1 ? "1 name has" : unreadable + " names have";
      options
          .run
          .errors()
          .warning(target + ": " + names + " no room below the picture; choose a larger --size");
    }
    if (!isEmpty || !frames.haveEnded()) {
      summarize(isEmpty ? "not written" : size(grid, frames), frames);
    }
  }

  private static String size(Grid grid, Frames frames) {
    return "%dx%d pixels, %s%s"
        .formatted(
            grid.sheetWidth(),
            grid.sheetHeight(),
            Numbers.count(grid.columns(), "column"),
            frames.left() > 0 ? ", partial" : "");
  }

  private void summarize(String what, Frames frames) {
    options.run.summarize(
        target + ": " + what + "; " + frames.summary(),
        Duration.between(invocation.start(), Instant.now()));
  }

  private ImageWriter.Options options(Frames frames) {
    int all = invocation.scenes().size();
    Map<String, String> texts =
        frames.left() > 0
            ? Map.of(
                PictureMetadata.PARTIAL,
                "%d of %d pictures are complete".formatted(frames.complete(), all))
            : Map.of();
    return new ImageWriter.Options(
        Exposure.NONE,
        ToneCurve.SRGB,
        options.bits(),
        options.stored.jpegQuality(),
        texts,
        Optional.empty(),
        Optional.of(Dither.FULL_FRAME));
  }

  /** Adds where the picture of each scene is on the sheet. */
  private void describe(JsonSummary report, Grid grid, Frames frames) {
    if (sheet.count() > 0) {
      report.put("output", target.toString());
    }
    report.put("width", grid.sheetWidth());
    report.put("height", grid.sheetHeight());
    report.put("columns", grid.columns());
    report.put("complete", frames.left() == 0);
    List<Object> cells = new ArrayList<>();
    for (int i = 0; i < invocation.scenes().size(); i++) {
      Map<String, Object> cell = new LinkedHashMap<>();
      cell.put("scene", invocation.scenes().get(i).toString());
      cell.put("empty", !sheet.has(i));
      cell.put("box", List.of(grid.left(i), grid.top(i), grid.width(), grid.height()));
      cells.add(cell);
    }
    report.put("cells", cells);
  }
}
