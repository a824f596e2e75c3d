package io.github.lumbre.model.internal;

import io.github.lumbre.model.ModelOption;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Values of options, each in its range. Immutable.
 *
 * @param given those that are not the defaults
 */
public record OptionValues(Map<ModelOption<?>, Object> given) {
  /** All options have their defaults. */
  public static final OptionValues NONE = new OptionValues(Map.of());

  public OptionValues {
    given = Map.copyOf(given);
  }

  /** Returns the value of an option, or its default; empty if it has none. */
  @SuppressWarnings("unchecked") // Method with puts values of this type.
  public <T> Optional<T> find(ModelOption<T> option) {
    return Optional.ofNullable((T) given.get(option)).or(option::defaultValue);
  }

  /**
   * Returns these values with another one.
   *
   * @throws IllegalArgumentException if it is out of range; the message names the option
   */
  public <T> OptionValues with(ModelOption<T> option, T value) {
    return with(option, Optional.of(value));
  }

  /** Returns these values with another one; with the default if it is empty. */
  public <T> OptionValues with(ModelOption<T> option, Optional<T> value) {
    Map<ModelOption<?>, Object> all = new HashMap<>(given);
    all.remove(option);
    value
        .map(v -> option.type().require(option.name(), v))
        .filter(v -> !option.defaultValue().equals(Optional.of(v)))
        .ifPresent(v -> all.put(option, v instanceof List<?> list ? List.copyOf(list) : v));
    return new OptionValues(all);
  }
}
