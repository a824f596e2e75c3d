package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.internal.Interrupts;
import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Finds files by their name alone, without regard to case, in a folder and three levels below.
 * Links to folders are not followed. In folders of more than 10,000 entries, nothing is found.
 * Mutable: the folder is read once.
 */
public final class FileSearch {
  private static final int LEVELS = 3;
  private static final int MAX_ENTRIES = 10_000;

  private final Path folder;
  private final int maxEntries;
  private int entries;

  /** Paths relative to the folder, by their last names in lower case; empty before the search. */
  private Optional<Map<String, List<String>>> files = Optional.empty();

  /** Creates a search that reads the folder when first used. */
  public FileSearch(Path folder) {
    this(folder, MAX_ENTRIES);
  }

  public FileSearch(Path folder, int maxEntries) {
    this.folder = folder;
    this.maxEntries = maxEntries;
  }

  /**
   * Returns the files with the last name of a path, relative to the folder and sorted.
   *
   * @param path with / or \ between names, with or without quotes around it
   */
  public List<String> of(String path) {
    if (files.isEmpty()) {
      Map<String, List<String>> found = new TreeMap<>();
      add(folder, "", LEVELS, found);
      found.values().forEach(names -> names.sort(null));
      files = Optional.of(entries > maxEntries ? Map.of() : found);
    }
    return files.get().getOrDefault(key(lastName(path)), List.of());
  }

  /** Returns the last name of a path, without quotes. */
  static String lastName(String path) {
    String plain = path.replace('\\', '/').replace("\"", "").strip();
    return plain.substring(plain.lastIndexOf('/') + 1);
  }

  private static String key(String name) {
    return name.toLowerCase(Locale.ROOT);
  }

  private void add(Path in, String prefix, int levels, Map<String, List<String>> found) {
    List<Path> folders = new ArrayList<>();
    try (DirectoryStream<Path> children = Files.newDirectoryStream(in)) {
      for (Path child : children) {
        Interrupts.check();
        if (++entries > maxEntries) {
          return;
        }
        String name = child.getFileName().toString();
        if (Files.isDirectory(child, LinkOption.NOFOLLOW_LINKS)) {
          folders.add(child);
        } else if (Files.isRegularFile(child)) {
          found.computeIfAbsent(key(name), k -> new ArrayList<>()).add(prefix + name);
        }
      }
    } catch (IOException | DirectoryIteratorException e) {
      // A folder that cannot be read has no files to find.
      return;
    }
    for (Path child : levels == 0 ? List.<Path>of() : folders) {
      add(child, prefix + child.getFileName() + "/", levels - 1, found);
    }
  }
}
