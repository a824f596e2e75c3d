package io.github.lumbre.lab.report;

import io.github.lumbre.lab.Csv;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.lab.TextFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** The expected hashes of the table's pictures, stored in the folder of scenes. Mutable. */
public final class TableHashes {
  /** The file's name. */
  public static final String FILE = "table-hashes.csv";

  private static final String HEADER = "row,scene,size,samples,sha256";
  private static final int COLUMNS = 5;

  private final Path file;
  private final Map<Key, String> hashes = new TreeMap<>(Key.ORDER);

  /** The render that a hash belongs to. */
  private record Key(int row, String scene, String size, int samples) {
    private static final Comparator<Key> ORDER =
        Comparator.comparingInt(Key::row)
            .thenComparing(Key::scene)
            .thenComparing(Key::size)
            .thenComparingInt(Key::samples);

    static Key of(BenchmarkResult result) {
      ReportRow row = result.row();
      return new Key(row.number(), row.scene(), row.size(), result.samples());
    }

    /** Returns whether both belong to the same row but to a different scene or size. */
    boolean contradicts(Key o) {
      return row == o.row && !(scene.equals(o.scene) && size.equals(o.size));
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
      List<String> lines = TextFile.lines(hashes.file);
      for (int i = 1; i < lines.size(); i++) {
        hashes.read(lines.get(i), i + 1);
      }
    }
    return hashes;
  }

  private void read(String line, int number) throws TaskException {
    try {
      List<String> values = Csv.values(line);
      if (values.size() != COLUMNS) {
        throw new IllegalArgumentException("expected " + HEADER);
      }
      Key key =
          new Key(
              Integer.parseInt(values.get(0)),
              values.get(1),
              values.get(2),
              Integer.parseInt(values.get(3)));
      hashes.put(key, values.get(4));
    } catch (IllegalArgumentException e) {
      throw new TaskException(Kind.USAGE, file + ": line " + number + ": " + e.getMessage(), e);
    }
  }

  /** Returns an error message if a result's hash differs or is not stored; otherwise empty. */
  public Optional<String> complaint(BenchmarkResult result) {
    Key key = Key.of(result);
    String what =
        "row " + key.row + ": " + key.scene + ", " + key.size + ", " + key.samples + " samples: ";
    String found = result.renders().imageHash();
    if (!hashes.containsKey(key)) {
      return Optional.of(what + "no hash is stored, found " + found);
    }
    String stored = hashes.get(key);
    return stored.equals(found)
        ? Optional.empty()
        : Optional.of(what + "the picture differs: expected " + stored + ", found " + found);
  }

  /** Stores the hash of a result, and removes hashes of the row's previous scene or size. */
  public void put(BenchmarkResult result) {
    Key key = Key.of(result);
    hashes.keySet().removeIf(key::contradicts);
    hashes.put(key, result.renders().imageHash());
  }

  /**
   * Writes the file.
   *
   * @throws TaskException if that fails
   */
  public void save() throws TaskException {
    String lines =
        hashes.entrySet().stream()
            .map(e -> line(e.getKey(), e.getValue()) + "\n")
            .collect(Collectors.joining());
    TextFile.write(file, HEADER + "\n" + lines);
  }

  private static String line(Key key, String hash) {
    return Csv.line(List.of(key.row, key.scene, key.size, key.samples, hash));
  }
}
