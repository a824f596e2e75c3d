package io.github.lumbre.cli.option;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.Setting.Group;
import io.github.lumbre.scene.internal.SettingTypes;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.IModelTransformer;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.TypeConversionException;

/**
 * The flags that set one {@link Setting} each, generated from its declaration. Mutable: picocli
 * stores the values from the command line here.
 *
 * <p>A command with this mixin must name {@link Adder} as its model transformer.
 */
@Command
public final class SettingFlags {
  private final Set<Group> groups;
  private final String unlessGiven;
  private final Map<Setting<?>, Object> given = new LinkedHashMap<>();

  /**
   * Offers the flags of some groups of settings.
   *
   * @param unlessGiven description of the default, for the help text; empty for the scene's value
   */
  public SettingFlags(String unlessGiven, Group first, Group... others) {
    this.unlessGiven = unlessGiven;
    groups = EnumSet.of(first, others);
  }

  /** Adds the flags to each command with this mixin. */
  public static final class Adder implements IModelTransformer {
    @Override
    public CommandSpec transform(CommandSpec command) {
      addFrom(command, command);
      return command;
    }

    private static void addFrom(CommandSpec mixed, CommandSpec command) {
      for (CommandSpec mixin : List.copyOf(mixed.mixins().values())) {
        if (mixin.userObject() instanceof SettingFlags flags) {
          flags.groups.forEach(group -> command.addMixin(group.name(), flags.mixin(group)));
        } else if (mixin.userObject() instanceof ModelFlags flags) {
          command.addMixin(Headings.MODEL, flags.flags());
        }
        addFrom(mixin, command);
      }
    }
  }

  /** Returns the flags of a group of settings, under the heading of the group. */
  private CommandSpec mixin(Group group) {
    CommandSpec mixin = CommandSpec.create();
    mixin.usageMessage().optionListHeading(heading(group));
    Setting.all().stream()
        .filter(setting -> setting.group() == group && !setting.flag().isEmpty())
        .forEach(setting -> mixin.addOption(option(setting)));
    return mixin;
  }

  private static String heading(Group group) {
    return switch (group) {
      case FRAME -> Headings.FRAME;
      case TRANSPORT -> Headings.TRANSPORT;
      case SAMPLING -> Headings.SAMPLES;
      case OUTPUT -> Headings.PICTURE;
      case EXECUTION -> Headings.EXECUTION;
    };
  }

  private <T> OptionSpec option(Setting<T> setting) {
    Given<Setting<?>> kept = new Given<>(given, setting);
    return OptionSpec.builder(setting.flag())
        .paramLabel(setting.label())
        .arity("1")
        .type(Object.class)
        .converters(new Converter<>(setting))
        .setter(kept)
        .getter(kept)
        .description(description(setting).replace("%", "%%"))
        .build();
  }

  private <T> String description(Setting<T> setting) {
    if (!unlessGiven.isEmpty()) {
      return setting.meaning() + " Default: " + unlessGiven + ".";
    }
    String text = setting.type().format(setting.defaultValue());
    boolean isNone =
        text.isEmpty() || Double.valueOf(Double.POSITIVE_INFINITY).equals(setting.defaultValue());
    String missing = isNone ? "none" : text;
    String from = setting.isInScenes() ? "scene or " + missing : missing;
    String inModels =
        setting.inModels().map(value -> "; models: " + setting.type().format(value)).orElse("");
    return setting.meaning() + " Default: " + from + inModels + ".";
  }

  /** Converts the texts of a setting. */
  private record Converter<T>(Setting<T> setting) implements ITypeConverter<T>, Choices {
    @Override
    public T convert(String text) {
      try {
        return setting.type().parse(text);
      } catch (IllegalArgumentException e) {
        throw new TypeConversionException(e.getMessage());
      }
    }

    @Override
    public List<String> choices() {
      return setting.type().names();
    }

    @Override
    public boolean isList() {
      return setting.type() instanceof SettingTypes.LayersType;
    }
  }

  /**
   * Checks the ranges of the given values.
   *
   * @param command that has these flags
   * @throws ParameterException that names the flag, the expected range and the value found
   */
  public void validate(CommandSpec command) {
    given.keySet().forEach(setting -> validate(setting, command));
  }

  @SuppressWarnings("unchecked") // The converter made a value of the setting's type.
  private <T> void validate(Setting<T> setting, CommandSpec command) {
    T value = (T) given.get(setting);
    if (!setting.type().accepts(value)) {
      String range = "expected " + setting.type().expected();
      String found = ", found " + setting.type().format(value);
      throw new ParameterException(command.commandLine(), setting.flag() + ": " + range + found);
    }
  }

  /** Returns whether a setting is given on the command line. */
  boolean isGiven(Setting<?> setting) {
    return given.containsKey(setting);
  }

  /** Sets all given values. */
  public void override(RenderSettings.Builder builder) {
    given.keySet().forEach(setting -> set(setting, builder));
  }

  @SuppressWarnings("unchecked") // The converter made a value of the setting's type.
  private <T> void set(Setting<T> setting, RenderSettings.Builder builder) {
    builder.set(setting, (T) given.get(setting));
  }

  /** Returns the value given for a setting, or a default. */
  @SuppressWarnings("unchecked") // The converter made a value of the setting's type.
  <T> T valueOr(Setting<T> setting, T other) {
    return (T) given.getOrDefault(setting, other);
  }
}
