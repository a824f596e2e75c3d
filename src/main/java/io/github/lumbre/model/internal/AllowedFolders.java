package io.github.lumbre.model.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The folders in which the files that a model names may lie: its own, those that the user names,
 * and all below. Links are resolved, and nothing outside is touched. Mutable: the folders are
 * resolved and read once; confined to one thread.
 */
public final class AllowedFolders {
  private final Path own;
  private final List<Path> others;
  private final FileSearch search;
  private final List<FileSearch> otherSearches;

  /** The folders without links, the own one first; empty before the first file. */
  private List<Path> real = List.of();

  /** The folders by all names that lead to them; empty before the first file. */
  private List<Path> named = List.of();

  /**
   * @param own folder of the model, in which relative names start
   * @param others further folders; those that do not exist have no files
   */
  public AllowedFolders(Path own, List<Path> others) {
    this.own = own;
    this.others = others.stream().map(folder -> folder.toAbsolutePath().normalize()).toList();
    search = new FileSearch(own);
    otherSearches = this.others.stream().map(FileSearch::new).toList();
  }

  /**
   * Returns the folders of a model.
   *
   * @param options name further folders, which uploads, models whose bytes are limited, do not get
   */
  public static AllowedFolders of(Path own, ModelOptions options) {
    return new AllowedFolders(
        own, options.limits().hasLimitedBytes() ? List.of() : options.get(ModelOption.ASSETS));
  }

  /**
   * Returns the real path of a file.
   *
   * @param name as the model states it; an absolute one may lie in one of the folders, too
   * @return empty if it lies outside
   * @throws IOException if the file does not exist, or a link cannot be resolved
   */
  public Optional<Path> find(String name) throws IOException {
    resolve();
    Path path = real.get(0).resolve(name).normalize();
    if (named.stream().noneMatch(path::startsWith)) {
      return Optional.empty();
    }
    Path found = path.toRealPath();
    return real.stream().anyMatch(found::startsWith) ? Optional.of(found) : Optional.empty();
  }

  private void resolve() throws IOException {
    if (!real.isEmpty()) {
      return;
    }
    List<Path> folders = new ArrayList<>(List.of(own.toRealPath()));
    List<Path> names = new ArrayList<>(folders);
    for (Path folder : others) {
      try {
        folders.add(folder.toRealPath());
        names.add(folder.toRealPath());
        names.add(folder);
        if (folder.getParent() != null) {
          names.add(folder.getParent().toRealPath().resolve(folder.getFileName()));
        }
      } catch (IOException e) {
        continue; // It has no files.
      }
    }
    real = folders;
    named = names;
  }

  /** Returns whether the real path of a file lies in the model's own folder. */
  public boolean isOwn(Path file) {
    return !real.isEmpty() && file.startsWith(real.get(0));
  }

  /**
   * Returns files with the last name of a path, as {@link FileSearch#of} finds them: relative to
   * the model's own folder, or with absolute paths in the others if it has none.
   */
  public List<String> similar(String path) {
    List<String> found = search.of(path);
    if (!found.isEmpty()) {
      return found;
    }
    List<String> all = new ArrayList<>();
    for (int i = 0; i < others.size(); i++) {
      Path folder = others.get(i);
      otherSearches.get(i).of(path).forEach(file -> all.add(folder.resolve(file).toString()));
    }
    return all.stream().distinct().toList();
  }

  /** Returns what is wrong with a name that leads out of the folders. */
  public String refusal(String name) {
    return "expected a file inside the model's folder"
        + (others.isEmpty() ? "" : " or a further one that is allowed")
        + ", found "
        + PrintableText.quoted(name);
  }
}
