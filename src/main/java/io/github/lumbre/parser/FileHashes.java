package io.github.lumbre.parser;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * SHA-256 of each file of a scene by itself, in hexadecimal: so that one can see which file has
 * changed.
 *
 * @param scene of the scene file
 * @param assets of the files that it names and uses, by the names that it gives them
 */
public record FileHashes(String scene, Map<String, String> assets) {
  public FileHashes {
    assets = Collections.unmodifiableSortedMap(new TreeMap<>(assets));
  }
}
