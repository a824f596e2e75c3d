package io.github.lumbre.scenefile.internal;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * SHA-256 of each file of a scene. Separate hashes show which file has changed.
 *
 * @param scene hash of the scene file
 * @param assets hashes of the asset files that the scene uses, by their names in the scene
 */
public record FileHashes(LateHash scene, Map<String, LateHash> assets) {
  public FileHashes {
    assets = Collections.unmodifiableSortedMap(new TreeMap<>(assets));
  }
}
