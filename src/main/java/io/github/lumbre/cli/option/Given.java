package io.github.lumbre.cli.option;

import java.util.Map;
import picocli.CommandLine.Model.IGetter;
import picocli.CommandLine.Model.ISetter;

/** Where picocli keeps the value of a generated flag: in a map, if it is given. */
record Given<K>(Map<K, Object> values, K key) implements IGetter, ISetter {
  @Override
  @SuppressWarnings("unchecked") // Only picocli calls this, with the type that it has set.
  public <V> V get() {
    return (V) values.get(key);
  }

  @Override
  public <V> V set(V value) {
    if (value == null) {
      values.remove(key);
    } else {
      values.put(key, value);
    }
    return null;
  }
}
