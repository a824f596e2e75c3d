package io.github.lumbre.base.file;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * What the end of this process must reach: hidden files to delete, commands that have a result to
 * save, the bar on the terminal; and the signal that requests the end. Static, because signals
 * arrive at a process and not at an object. Mutable and thread-safe.
 */
public final class ProcessEnd {
  private static final Set<Object> OPEN = ConcurrentHashMap.newKeySet();

  /** The exit code of the first signal; 0 before that. */
  private static final AtomicInteger SIGNAL = new AtomicInteger();

  private ProcessEnd() {}

  /** Keeps an object, which is returned, until {@link #remove}. */
  public static <T> T add(T open) {
    OPEN.add(open);
    return open;
  }

  /** Removes an object; returns whether it was there. */
  public static boolean remove(Object open) {
    return OPEN.remove(open);
  }

  /** Returns the objects of a type that are not removed. */
  public static <T> List<T> open(Class<T> type) {
    return OPEN.stream().filter(type::isInstance).map(type::cast).toList();
  }

  /** Takes note of a signal; returns whether it is the first. */
  public static boolean arrived(int exitCode) {
    return SIGNAL.compareAndSet(0, exitCode);
  }

  /** Returns the exit code of the first signal; 0 before that. */
  public static int signal() {
    return SIGNAL.get();
  }
}
