package io.github.lumbre.cli.mcp;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Keeps what was made of the models of the last calls, within a bound of memory. Thread-safe. */
final class ModelCache<T> {
  private final long mostBytes;
  private final Map<Object, Entry<T>> entries = new LinkedHashMap<>(16, .75f, true);
  private long bytes;

  private record Entry<T>(T value, long bytes) {}

  ModelCache(long mostBytes) {
    this.mostBytes = mostBytes;
  }

  synchronized Optional<T> get(Object key) {
    return Optional.ofNullable(entries.get(key)).map(Entry::value);
  }

  /**
   * Keeps a value, and forgets those that were not used for the longest time.
   *
   * @param size about how many bytes it takes
   */
  synchronized void put(Object key, T value, long size) {
    Optional.ofNullable(entries.remove(key)).ifPresent(old -> bytes -= old.bytes);
    if (size > mostBytes) {
      return;
    }
    entries.put(key, new Entry<>(value, size));
    bytes += size;
    for (var eldest = entries.values().iterator(); bytes > mostBytes; ) {
      bytes -= eldest.next().bytes;
      eldest.remove();
    }
  }
}
