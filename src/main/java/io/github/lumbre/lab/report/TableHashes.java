package io.github.lumbre.lab.report;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.TextFile;
import io.github.lumbre.lab.Csv;
import io.github.lumbre.lab.Table;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** The expected hashes of the table's pictures, stored in the folder of scenes. Mutable. */
public final class TableHashes {
  /** The file's name. */
  public static final String FILE = "table-hashes.csv";

  private static final Table<Stored> TABLE =
      Table.<Stored>empty()
          .number("row", Stored::row)
          .text("scene", Stored::scene)
          .text("size", Stored::size)
          .number("samples", Stored::samples)
          .text("sha256", Stored::hash);

  private final Path file;
  private final List<Stored> hashes = new ArrayList<>();

  /** A picture's hash, and the render that it belongs to. */
  private record Stored(int row, String scene, String size, int samples, String hash) {
    static Stored of(BenchmarkResult result) {
      ReportRow row = result.row();
      String hash = result.renders().imageHash();
      return new Stored(row.number(), row.scene(), row.size().toString(), result.samples(), hash);
    }

    static Stored of(List<String> values) {
      int row = Integer.parseInt(values.get(0));
      int samples = Integer.parseInt(values.get(3));
      return new Stored(row, values.get(1), values.get(2), samples, values.get(4));
    }

    boolean isOfSameScene(Stored o) {
      return row == o.row && scene.equals(o.scene) && size.equals(o.size);
    }

    boolean isOfSameRender(Stored o) {
      return isOfSameScene(o) && samples == o.samples;
    }
  }

  private TableHashes(Path file) {
    this.file = file;
  }

  /**
   * Returns the hashes stored in a folder of scenes; none if the file does not exist.
   *
   * @throws TaskException if the file cannot be read or is invalid
   */
  public static TableHashes load(Path directory) throws TaskException {
    TableHashes hashes = new TableHashes(directory.resolve(FILE));
    if (Files.exists(hashes.file)) {
      hashes.hashes.addAll(Csv.read(hashes.file, Csv.line(TABLE.names()), Stored::of));
    }
    return hashes;
  }

  /** Returns an error message if a result's hash differs or is not stored; otherwise empty. */
  public Optional<String> complaint(BenchmarkResult result) {
    Stored found = Stored.of(result);
    String what =
        "row %d: %s, %s, %d samples: ".formatted(found.row, found.scene, found.size, found.samples);
    Optional<Stored> expected = hashes.stream().filter(found::isOfSameRender).findFirst();
    if (expected.isEmpty()) {
      return Optional.of(what + "no hash is stored, found " + found.hash);
    }
    String stored = expected.get().hash;
    return stored.equals(found.hash)
        ? Optional.empty()
        : Optional.of(what + "the picture differs: expected " + stored + ", found " + found.hash);
  }

  /** Stores the hash of a result, and removes hashes of the row's previous scene or size. */
  public void put(BenchmarkResult result) {
    Stored stored = Stored.of(result);
    hashes.removeIf(old -> old.row == stored.row && !old.isOfSameScene(stored));
    hashes.removeIf(stored::isOfSameRender);
    hashes.add(stored);
    hashes.sort(Comparator.comparingInt(Stored::row).thenComparingInt(Stored::samples));
  }

  /**
   * Writes the file.
   *
   * @throws TaskException if that fails
   */
  public void save() throws TaskException {
    TextFile.write(file, TABLE.csv(hashes));
  }
}
