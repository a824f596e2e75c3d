package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.option.CommandModel;
import io.github.lumbre.cli.output.PixelPlace;
import java.lang.reflect.Field;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.IFactory;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;

/** Compares the models that the build generates with those that picocli makes of annotations. */
class CommandModelTest {
  /**
   * The fields of picocli's models that say where they come from, that reach fields, or that Lumbre
   * does not use: translations, passwords, inherited flags.
   */
  private static final String NOT_COMPARED =
      "(.*\\.)?(userObject|annotatedElement|mixinAnnotatedElements|specElements|toString"
          + "|commandSpec|getter|setter|scope|initialValue|initialValueState|prompt|scopeType"
          + "|negatableOptionTransformer|originalDefaultValue|originalMapFallbackValue"
          + "|originalFallbackValue|descriptionKey|actualGenericTypeArguments|builderCapacity"
          + "|exitCodeListStrings|exitCodeList|group\\.typeInfo)";

  private static final IFactory FACTORY = CommandLine.defaultFactory();

  static List<Class<?>> commands() {
    return Lumbre.modeledClasses();
  }

  @ParameterizedTest
  @MethodSource("commands")
  void generatedModelIsThatOfTheAnnotations(Class<?> command) {
    assertThat(CommandModel.of(command, FACTORY))
        .usingRecursiveComparison()
        .withStrictTypeChecking()
        .ignoringFieldsMatchingRegexes(NOT_COMPARED)
        .isEqualTo(CommandSpec.forAnnotatedObject(command, FACTORY));
  }

  @ParameterizedTest
  @MethodSource("commands")
  void modelIsGenerated(Class<?> command) {
    assertThat(CommandModel.of(command, FACTORY).args())
        .allSatisfy(arg -> assertThat(arg.userObject()).isNull());
  }

  @ParameterizedTest
  @MethodSource("commands")
  void eachArgumentSetsItsOwnField(Class<?> command) throws IllegalAccessException {
    List<ArgSpec> generated = CommandModel.of(command, FACTORY).args();
    List<ArgSpec> reflected = CommandSpec.forAnnotatedObject(command, FACTORY).args();
    for (int i = 0; i < generated.size(); i++) {
      if (reflected.get(i).userObject() instanceof Field field && isOurs(field)) {
        Object value = sample(field.getType());
        set(generated.get(i), value);
        field.setAccessible(true);
        Object owner = owner(generated.get(i));
        assertThat(field.get(owner)).as(field.toString()).isEqualTo(value);
        assertThat(value(generated.get(i))).isEqualTo(value);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("commands")
  void initialValuesAreThoseOfTheFields(Class<?> command) {
    assertThat(CommandModel.of(command, FACTORY).args())
        .extracting(ArgSpec::initialValue)
        .isEqualTo(
            CommandSpec.forAnnotatedObject(command, FACTORY).args().stream()
                .map(arg -> arg.userObject() instanceof Field ? arg.initialValue() : null)
                .toList());
  }

  @ParameterizedTest
  @MethodSource("commands")
  void helpIsThatOfTheAnnotations(Class<?> command) {
    assertThat(new CommandLine(CommandModel.of(command, FACTORY)).getUsageMessage())
        .isEqualTo(new CommandLine(command).getUsageMessage());
  }

  @Test
  void commandsOfPicocliAreModeledByReflection() {
    assertThat(CommandModel.of(CommandLine.HelpCommand.class, FACTORY).name()).isEqualTo("help");
  }

  private static boolean isOurs(Field field) {
    return field.getDeclaringClass().getName().startsWith("io.github.lumbre.");
  }

  private static void set(ArgSpec arg, Object value) {
    try {
      arg.setter().set(value);
    } catch (Exception e) {
      throw new AssertionError(arg + " cannot be set", e);
    }
  }

  private static Object value(ArgSpec arg) {
    try {
      return arg.getter().get();
    } catch (Exception e) {
      throw new AssertionError(arg + " cannot be read", e);
    }
  }

  private static Object owner(ArgSpec arg) {
    try {
      return arg.scope().get();
    } catch (Exception e) {
      throw new AssertionError(arg + " has no object", e);
    }
  }

  /** Returns a value that no field has at first. Generic types do not matter here. */
  private static Object sample(Class<?> type) {
    if (type.isEnum()) {
      return type.getEnumConstants()[type.getEnumConstants().length - 1];
    }
    Object[] others = {Set.of("sample"), Map.of("sample", 47), new PixelPlace(4, 7)};
    Object[] numbers = {true, 4711, 47.11, new BigDecimal(47), Duration.ofDays(47)};
    Object[] texts = {"sample", Path.of("sample"), Optional.of("sample"), List.of("sample")};
    Stream<Object> all = Stream.of(others, numbers, texts).flatMap(Stream::of);
    return all.filter(value -> boxed(type).isInstance(value))
        .findFirst()
        .orElseThrow(() -> new AssertionError("no sample of " + type));
  }

  private static Class<?> boxed(Class<?> type) {
    Map<Class<?>, Class<?>> boxes =
        Map.of(boolean.class, Boolean.class, int.class, Integer.class, double.class, Double.class);
    return boxes.getOrDefault(type, type);
  }
}
