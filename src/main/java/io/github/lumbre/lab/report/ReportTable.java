package io.github.lumbre.lab.report;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.lab.Csv;
import io.github.lumbre.scene.RenderSettings.Size;
import io.github.lumbre.scene.Setting;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Collectors;

/** Reads the report's table, a file in the folder of scenes. */
public final class ReportTable {
  /** The file's name. */
  public static final String FILE = "table.csv";

  private static final String HEADER =
      "row,name,scene,size,mode,samples,bucket,depth,threads,hardware,time,note";

  private ReportTable() {}

  /**
   * Returns the rows of the table in a folder of scenes.
   *
   * @throws TaskException if the file is missing or a line is invalid; it names the line
   */
  public static List<ReportRow> load(Path directory) throws TaskException {
    return Csv.read(directory.resolve(FILE), HEADER, ReportTable::row);
  }

  private static ReportRow row(List<String> values) {
    return new ReportRow(
        Integer.parseInt(values.get(0)),
        values.get(1),
        values.get(2),
        Size.of(values.get(3)),
        Setting.MODE.type().parse(values.get(4)),
        Integer.parseInt(values.get(5)),
        Integer.parseInt(values.get(6)),
        depth(values.get(7)),
        Integer.parseInt(values.get(8)),
        values.get(9),
        values.get(10),
        values.get(11));
  }

  private static OptionalInt depth(String text) {
    return text.isEmpty() ? OptionalInt.empty() : OptionalInt.of(Integer.parseInt(text));
  }

  /**
   * Returns the rows with the given numbers, in the table's order; all if none are given.
   *
   * @throws IllegalArgumentException that names a number without a row
   */
  public static List<ReportRow> select(List<ReportRow> rows, List<Integer> numbers) {
    List<Integer> known = rows.stream().map(ReportRow::number).toList();
    for (int number : numbers) {
      if (!known.contains(number)) {
        String list = known.stream().map(String::valueOf).collect(Collectors.joining(", "));
        throw new IllegalArgumentException("expected some of " + list + ", found " + number);
      }
    }
    return rows.stream()
        .filter(row -> numbers.isEmpty() || numbers.contains(row.number()))
        .toList();
  }
}
