package io.github.lumbre.spark;

import io.github.lumbre.render.FilmRenderer;
import java.lang.ref.SoftReference;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;

/**
 * The renderers of the scenes that were used last. A sequence has one for each frame, so that all
 * of them would not fit into memory. Thread-safe.
 */
final class KeptRenderers {
  private final int most;
  private final Map<String, Kept> byKey = new LinkedHashMap<>(16, .75f, true);

  /**
   * @param most number of renderers to keep, at least 1
   */
  KeptRenderers(int most) {
    this.most = most;
  }

  /** Returns the renderer with a key; makes it, once at a time, if it is not kept. */
  FilmRenderer get(String key, Supplier<FilmRenderer> maker) {
    return kept(key).get(maker);
  }

  private synchronized Kept kept(String key) {
    Kept kept = byKey.computeIfAbsent(key, k -> new Kept());
    if (byKey.size() > most) {
      byKey.remove(byKey.keySet().iterator().next());
    }
    return kept;
  }

  /** A renderer, which may go if memory is needed and no unit uses it. */
  private static final class Kept {
    private SoftReference<FilmRenderer> renderer = new SoftReference<>(null);

    synchronized FilmRenderer get(Supplier<FilmRenderer> maker) {
      FilmRenderer known = renderer.get();
      if (known == null) {
        known = maker.get();
        renderer = new SoftReference<>(known);
      }
      return known;
    }
  }
}
