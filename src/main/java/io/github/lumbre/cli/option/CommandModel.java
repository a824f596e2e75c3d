package io.github.lumbre.cli.option;

import picocli.CommandLine.IFactory;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * Makes picocli's model of a command, of a mixin or of a group of flags. From the annotations of
 * each such class, the build generates a subclass ({@code src/main/build/GenerateModels.java}): to
 * read annotations and to reach fields by reflection takes picocli a tenth of the processor time of
 * a small picture. Generated classes set the annotated fields, so that these are not private.
 *
 * @param <T> the annotated class
 */
public abstract class CommandModel<T> {
  /** The ending of the names of generated classes. */
  private static final String SUFFIX = "Model";

  /** The name under which picocli mixes in the flags of help and version. */
  private static final String HELP = "mixinStandardHelpOptions";

  /**
   * Returns the model of a command. Without a generated class, as for picocli's own commands,
   * picocli reads the annotations.
   *
   * @param factory makes the command
   */
  public static CommandSpec of(Class<?> type, IFactory factory) {
    try {
      return create(type, factory);
    } catch (ClassNotFoundException e) {
      return CommandSpec.forAnnotatedObject(type, factory);
    } catch (Exception e) {
      throw new AssertionError("A generated model cannot be used: " + e, e);
    }
  }

  private static <T> CommandSpec create(Class<T> type, IFactory factory) throws Exception {
    Class<?> generated = Class.forName(type.getName() + SUFFIX);
    @SuppressWarnings("unchecked") // The build names each class after the one that it describes.
    CommandModel<T> model = (CommandModel<T>) factory.create(generated);
    return model.spec(factory.create(type));
  }

  private CommandSpec spec(T object) {
    CommandSpec spec = CommandSpec.wrapWithoutInspection(object);
    describe(object, new ModelMembers<>(this, object, spec::add), spec);
    return spec;
  }

  /** Describes the object: adds everything that its annotations declare, in their order. */
  protected void describe(T object, ModelMembers<T> members, CommandSpec spec) {}

  /** Gives a mixin the model of the command that it is part of. */
  protected void mixedInto(T object, CommandSpec command) {}

  /** Returns the value of an annotated field, by its number. */
  protected Object get(T object, int field) {
    throw new IllegalArgumentException(object + " has no annotated fields");
  }

  /** Sets an annotated field, by its number. */
  protected void set(T object, int field, Object value) {
    throw new IllegalArgumentException(object + " has no annotated fields");
  }

  /** Adds a mixin to a model. */
  protected static <M> void mix(CommandSpec spec, String name, M mixin, CommandModel<M> model) {
    spec.addMixin(name, model.spec(mixin));
    model.mixedInto(mixin, spec);
  }

  /** Adds the flags of help and version, as picocli does for {@code mixinStandardHelpOptions}. */
  protected static void mixHelp(CommandSpec spec) {
    CommandSpec help = CommandSpec.create();
    help.addOption(
        OptionSpec.builder(names("help", "-h", "--help"))
            .usageHelp(true)
            .type(boolean.class)
            .paramLabel("<helpRequested>")
            .initialValue(false)
            .descriptionKey("mixinStandardHelpOptions.help")
            .description("Show this help message and exit.")
            .build());
    help.addOption(
        OptionSpec.builder(names("version", "-V", "--version"))
            .versionHelp(true)
            .type(boolean.class)
            .paramLabel("<versionRequested>")
            .initialValue(false)
            .descriptionKey("mixinStandardHelpOptions.version")
            .description("Print version information and exit.")
            .build());
    spec.addMixin(HELP, help);
  }

  /** Returns the names of a flag, which picocli lets system properties change. */
  private static String[] names(String flag, String brief, String full) {
    String property = "picocli." + flag + ".name.";
    return new String[] {
      "${" + property + "0:-" + brief + "}", "${" + property + "1:-" + full + "}"
    };
  }
}
