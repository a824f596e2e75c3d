package io.github.lumbre.lab;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The columns of a table, each with its name and its cell in a row. The same columns are written as
 * Markdown, comma-separated values, members of a JSON object, or HTML. Immutable.
 *
 * @param <T> the type of the rows
 */
public final class Table<T> {
  private final List<Column<T>> columns;

  private record Column<T>(String name, String alignment, Function<T, ?> cell) {}

  private Table(List<Column<T>> columns) {
    this.columns = columns;
  }

  /** Returns a table without columns. */
  public static <T> Table<T> empty() {
    return new Table<>(List.of());
  }

  /** Returns this table with a further column, aligned to the left. */
  public Table<T> text(String name, Function<T, ?> cell) {
    return with(new Column<>(name, "---", cell));
  }

  /** Returns this table with a further column, aligned to the right. */
  public Table<T> number(String name, Function<T, ?> cell) {
    return with(new Column<>(name, "--:", cell));
  }

  private Table<T> with(Column<T> column) {
    List<Column<T>> all = new ArrayList<>(columns);
    all.add(column);
    return new Table<>(all);
  }

  public List<String> names() {
    return columns.stream().map(Column::name).toList();
  }

  /** Returns the cells of a row as text. */
  public List<String> cells(T row) {
    return columns.stream().map(column -> String.valueOf(column.cell.apply(row))).toList();
  }

  /** Returns the values of rows by the names of their columns; an empty Optional is left out. */
  public List<Map<String, Object>> members(List<T> rows) {
    return rows.stream().map(this::members).toList();
  }

  private Map<String, Object> members(T row) {
    Map<String, Object> members = new LinkedHashMap<>();
    for (Column<T> column : columns) {
      Object value = column.cell.apply(row);
      Optional<?> known = value instanceof Optional<?> optional ? optional : Optional.of(value);
      known.ifPresent(v -> members.put(column.name, v));
    }
    return members;
  }

  /** Returns lines of Markdown, followed by an empty line and the two header lines of the table. */
  public List<String> head(String... above) {
    String line =
        columns.stream().map(Column::alignment).collect(Collectors.joining("|", "|", "|"));
    return Stream.concat(Stream.of(above), Stream.of("", line(names()), line)).toList();
  }

  /** Returns a row as a line of Markdown. */
  public String line(T row) {
    return line(cells(row));
  }

  private static String line(List<String> cells) {
    return cells.stream()
        .map(cell -> cell.replace("|", "\\|"))
        .collect(Collectors.joining(" | ", "| ", " |"));
  }

  /** Returns rows as comma-separated values below a line of names; an empty text without rows. */
  public String csv(List<T> rows) {
    return Stream.concat(rows.stream().limit(1).map(row -> names()), rows.stream().map(this::cells))
        .map(cells -> Csv.line(cells) + "\n")
        .collect(Collectors.joining());
  }
}
