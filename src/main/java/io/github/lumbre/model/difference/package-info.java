/**
 * What changed between two models: {@link io.github.lumbre.model.difference.ModelDifference} pairs
 * their parts by name and by shape and says which were added, removed, moved or changed.
 */
package io.github.lumbre.model.difference;
