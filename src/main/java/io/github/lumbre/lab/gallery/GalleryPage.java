package io.github.lumbre.lab.gallery;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.Markdown;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TextFile;
import io.github.lumbre.lab.perf.Hardware;
import io.github.lumbre.lab.report.ReportTime;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** The page that shows a folder's pictures and how each was rendered. Mutable. */
public final class GalleryPage {
  /** The page's file name; code hosts display this file with the folder. */
  public static final String FILE = "README.md";

  private static final String HEAD =
      """
      # Pictures

      Rendered by `lumbre gallery` from the scenes of the same names. The same number of samples \
      gives the same pixels on every machine. The time includes only rendering. The noise is an \
      estimate: the relative RMSE of the picture before it is denoised.

      | scene | picture | size | samples | time | threads | hardware | noise |
      |---|---|---|--:|--:|--:|---|---|
      """;

  private static final Pattern ROW = Pattern.compile("\\| \\[([^]]+)]\\(.*");
  private static final int WIDTH = 240;

  private final Path file;
  private final Map<String, String> rows = new TreeMap<>();

  private GalleryPage(Path file) {
    this.file = file;
  }

  /**
   * How a picture was rendered.
   *
   * @param scene name of the scene, and of the picture without its extension
   * @param noise of the picture before it was denoised, in words
   */
  public record Entry(
      String scene,
      String size,
      int samples,
      double seconds,
      int threads,
      Hardware hardware,
      String noise) {
    /** Returns the entry for a scene rendered on this machine. */
    public static Entry of(String scene, GalleryRenderer.Rendered rendered) {
      Hardware hardware = Hardware.here();
      int threads = rendered.settings().threads();
      Image image = rendered.result().image();
      return new Entry(
          scene,
          image.width() + "x" + image.height(),
          rendered.settings().samples(),
          rendered.seconds(),
          threads == 0 ? hardware.cores() : threads,
          hardware,
          noise(rendered));
    }

    private static String noise(GalleryRenderer.Rendered rendered) {
      String noise =
          rendered
              .noise()
              .map(known -> Markdown.percent(known.relativeRmse()))
              .orElse("not known");
      return rendered.denoised().isPresent() ? noise + ", then denoised" : noise;
    }
  }

  /**
   * Returns a folder's page with its entries for existing pictures; an empty page if there is none.
   *
   * @throws TaskException if the page exists but cannot be read
   */
  public static GalleryPage load(Path directory) throws TaskException {
    GalleryPage page = new GalleryPage(directory.resolve(FILE));
    if (Files.exists(page.file)) {
      for (String line : TextFile.lines(page.file)) {
        Matcher row = ROW.matcher(line);
        if (row.matches() && Files.exists(picture(directory, row.group(1)))) {
          page.rows.put(row.group(1), line);
        }
      }
    }
    return page;
  }

  /** Returns the file of a scene's picture, in this page's folder. */
  public Path picture(String scene) {
    return file.resolveSibling(scene + ".png");
  }

  /** Returns the file of a scene's picture. */
  public static Path picture(Path directory, String scene) {
    return directory.resolve(scene + ".png");
  }

  /** Adds or replaces the entry of a picture. */
  public void put(Entry entry) {
    String name = entry.scene;
    String image = "<img src=\"" + name + ".png\" width=\"" + WIDTH + "\" alt=\"" + name + "\">";
    rows.put(
        name,
        Markdown.row(
            List.of(
                "[" + name + "](" + name + ".png)",
                image,
                entry.size,
                String.valueOf(entry.samples),
                ReportTime.of(entry.seconds),
                String.valueOf(entry.threads),
                entry.hardware.line(),
                entry.noise)));
  }

  /**
   * Writes the page.
   *
   * @throws TaskException if that fails
   */
  public void save() throws TaskException {
    String lines = rows.values().stream().map(row -> row + "\n").collect(Collectors.joining());
    TextFile.write(file, HEAD + lines);
  }
}
