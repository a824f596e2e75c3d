import java.io.IOException;
import java.lang.annotation.Annotation;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * Generates picocli's models of the commands from their annotations, for the build, so that the
 * program need not read annotations when it starts: a subclass of {@code CommandModel} for each
 * command, mixin and group of flags.
 *
 * <p>Knows only those attributes of annotations that are used, and rejects others. {@code
 * CommandModelTest} compares the generated models with those that picocli makes.
 */
final class GenerateModels {
  private static final String OPTION = "io.github.lumbre.cli.option.";
  private static final String SPEC = "picocli.CommandLine.Model.CommandSpec";
  private static final String USAGE = "picocli.CommandLine.Model.UsageMessageSpec";

  private final Path sources;
  private final Set<Class<?>> done = new HashSet<>();
  private final List<String> files = new ArrayList<>();

  private GenerateModels(Path sources) {
    this.sources = sources;
  }

  /**
   * Generates sources and compiles them.
   *
   * @param args the folder for the sources; the folder of the program's classes, which gets those
   *     of the models too; the class that lists the commands
   */
  public static void main(String[] args) throws Exception {
    GenerateModels models = new GenerateModels(Path.of(args[0]));
    Method commands = Class.forName(args[2]).getDeclaredMethod("modeledClasses");
    commands.setAccessible(true);
    for (Object command : (Iterable<?>) commands.invoke(null)) {
      models.generate((Class<?>) command, CommandSpec.forAnnotatedObject(command).args());
    }
    models.compile(Path.of(args[1]));
  }

  /**
   * Generates the model of a class, and those of its mixins and groups.
   *
   * @param args picocli's models of all flags and arguments of the command
   */
  private void generate(Class<?> type, List<ArgSpec> args) throws Exception {
    if (!done.add(type)) {
      return;
    }
    Path file = sources.resolve(modelOf(type).replace('.', '/') + ".java");
    Files.createDirectories(file.getParent());
    Files.writeString(file, source(type, args));
    files.add(file.toString());
    for (Field field : type.getDeclaredFields()) {
      if (field.isAnnotationPresent(Mixin.class) || field.isAnnotationPresent(ArgGroup.class)) {
        generate(field.getType(), args);
      }
    }
  }

  /** Compiles beside the sources: the module descriptor among the program's classes would count. */
  private void compile(Path classes) throws IOException {
    String path = System.getProperty("java.class.path");
    List<String> options =
        List.of("--release", "17", "-proc:none", "-cp", path, "-d", sources.toString());
    String[] all = Stream.concat(options.stream(), files.stream()).toArray(String[]::new);
    if (ToolProvider.getSystemJavaCompiler().run(null, null, null, all) != 0) {
      throw new IllegalStateException("the generated models cannot be compiled");
    }
    for (String source : files) {
      Path compiled = Path.of(source.replaceAll("java$", "class"));
      Path target = classes.resolve(sources.relativize(compiled));
      Files.move(compiled, target, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  private static String source(Class<?> type, List<ArgSpec> args) throws Exception {
    String described = type.getCanonicalName();
    String members = OPTION + "ModelMembers<" + described + "> members, " + SPEC + " spec";
    return """
        package %s;

        /** Generated from the annotations of {@link %s}. */
        @SuppressWarnings("unchecked") // picocli sets values of the types of the fields.
        public final class %s extends %sCommandModel<%s> {
        """
            .formatted(type.getPackageName(), described, nameOf(type), OPTION, described)
        + method("void describe", described, members, description(type, args))
        + method("void mixedInto", described, SPEC + " command", specs(type, Spec.Target.MIXEE))
        + method("Object get", described, "int field", getters(type))
        + method("void set", described, "int field, Object value", setters(type))
        + "}\n";
  }

  /** Returns a method; nothing without statements. */
  private static String method(String name, String described, String parameters, String body) {
    String method =
        """

          @Override
          protected %s(%s object, %s) {
        %s  }
        """;
    return body.isEmpty() ? "" : method.formatted(name, described, parameters, body);
  }

  /** Returns the statements that describe a class: its attributes, then its fields in order. */
  private static String description(Class<?> type, List<ArgSpec> args) throws Exception {
    StringBuilder code = new StringBuilder();
    Command command = type.getAnnotation(Command.class);
    if (command != null) {
      for (Method attribute : given(command)) {
        code.append(attribute(attribute.getName(), attribute.invoke(command)));
      }
    }
    code.append(specs(type, Spec.Target.SELF));
    int number = 0;
    for (Field field : type.getDeclaredFields()) {
      String object = "object." + field.getName();
      if (field.isAnnotationPresent(Mixin.class)) {
        code.append(creation(object, field.getType()));
        String model = made(modelOf(field.getType()));
        code.append("    mix(spec, \"%s\", %s, %s);\n".formatted(field.getName(), object, model));
      } else if (field.isAnnotationPresent(ArgGroup.class)) {
        String model = made(modelOf(field.getType()));
        code.append("    members.addGroup(spec, %s, %s);\n".formatted(object, model));
      } else if (isArgument(field)) {
        code.append(argument(number++, field, args));
      }
    }
    if (command != null && command.mixinStandardHelpOptions()) {
      code.append("    mixHelp(spec);\n");
    }
    return code.toString();
  }

  /** Returns the statement that sets an attribute of a command. */
  private static String attribute(String name, Object value) {
    String usage = "    spec.usageMessage().";
    return switch (name) {
      case "mixinStandardHelpOptions" -> ""; // Comes last.
      case "name" -> "    spec.name(" + literal(value) + ");\n";
      case "versionProvider", "modelTransformer" ->
          "    spec." + name + "(" + made(((Class<?>) value).getCanonicalName()) + ");\n";
      case "exitCodeList" ->
          usage + "exitCodeList(" + USAGE + ".keyValuesMap(" + literal(value) + "));\n";
      case "header", "description", "footer", "exitCodeListHeading" ->
          usage + name + "(" + literal(value) + ");\n";
      case "synopsisSubcommandLabel", "sortOptions", "abbreviateSynopsis" ->
          usage + name + "(" + literal(value) + ");\n";
      default -> throw new IllegalArgumentException("an attribute without generator: " + name);
    };
  }

  /** Returns the statement that creates a mixin where its command does not, if it can. */
  private static String creation(String object, Class<?> type) {
    String statement =
        """
            if (%1$s == null) {
              %1$s = %2$s;
            }
        """;
    return Stream.of(type.getConstructors()).anyMatch(made -> made.getParameterCount() == 0)
        ? statement.formatted(object, made(type.getCanonicalName()))
        : "";
  }

  /** Returns the statement that adds a flag or an argument. */
  private static String argument(int number, Field field, List<ArgSpec> args) throws Exception {
    Option option = field.getAnnotation(Option.class);
    Annotation annotation = option == null ? field.getAnnotation(Parameters.class) : option;
    ArgSpec arg = args.stream().filter(a -> field.equals(a.userObject())).findFirst().orElseThrow();
    List<String> calls = new ArrayList<>();
    calls.add(
        option == null
            ? "argument(" + number + ")"
            : "option(" + number + ", " + literal(option.names()) + ")");
    calls.add("type(" + literal(arg.type()) + ")");
    calls.add("auxiliaryTypes(" + literal(arg.auxiliaryTypes()) + ")");
    calls.add("paramLabel(" + literal(arg.paramLabel()) + ")");
    if (option == null) {
      calls.add("required(" + arg.required() + ")");
    }
    for (Method attribute : given(annotation)) {
      String name = attribute.getName();
      Object value = attribute.invoke(annotation);
      switch (name) {
        case "names", "paramLabel" -> {} // Above.
        case "description", "required", "arity", "index", "defaultValue" ->
            calls.add(name + "(" + literal(value) + ")");
        case "split" -> calls.add("splitRegex(" + literal(value) + ")");
        case "converter" -> calls.add("converters(" + allMade((Class<?>[]) value) + ")");
        default -> throw new IllegalArgumentException("an attribute without generator: " + name);
      }
    }
    calls.add("build()");
    return "    members.add(\n        members\n            ."
        + String.join("\n            .", calls)
        + ");\n";
  }

  /** Returns the statements that hand the model to the fields that hold it. */
  private static String specs(Class<?> type, Spec.Target target) {
    String value = target == Spec.Target.SELF ? "spec" : "command";
    return Stream.of(type.getDeclaredFields())
        .filter(field -> field.isAnnotationPresent(Spec.class))
        .filter(field -> field.getAnnotation(Spec.class).value() == target)
        .map(field -> "    object." + field.getName() + " = " + value + ";\n")
        .collect(Collectors.joining());
  }

  private static String getters(Class<?> type) {
    String cases = cases(type, "      case %d -> object.%s;\n");
    String other = "      default -> super.get(object, field);\n";
    return cases.isEmpty() ? "" : "    return switch (field) {\n" + cases + other + "    };\n";
  }

  private static String setters(Class<?> type) {
    String cases = cases(type, "      case %d -> object.%s = (%s) value;\n");
    String other = "      default -> super.set(object, field, value);\n";
    return cases.isEmpty() ? "" : "    switch (field) {\n" + cases + other + "    }\n";
  }

  private static String cases(Class<?> type, String line) {
    List<Field> fields =
        Stream.of(type.getDeclaredFields()).filter(GenerateModels::isArgument).toList();
    return IntStream.range(0, fields.size())
        .mapToObj(i -> line.formatted(i, fields.get(i).getName(), typeOf(fields.get(i))))
        .collect(Collectors.joining());
  }

  private static boolean isArgument(Field field) {
    return field.isAnnotationPresent(Option.class) || field.isAnnotationPresent(Parameters.class);
  }

  /** Returns the attributes whose values are not the default, in alphabetical order. */
  private static List<Method> given(Annotation annotation) throws Exception {
    List<Method> given = new ArrayList<>();
    for (Method attribute : annotation.annotationType().getDeclaredMethods()) {
      if (!Objects.deepEquals(attribute.invoke(annotation), attribute.getDefaultValue())) {
        given.add(attribute);
      }
    }
    given.sort(Comparator.comparing(Method::getName));
    return given;
  }

  private static String typeOf(Field field) {
    return field.getGenericType().getTypeName().replace('$', '.');
  }

  private static String modelOf(Class<?> type) {
    return type.getPackageName() + "." + nameOf(type);
  }

  private static String nameOf(Class<?> type) {
    String name = type.getName().substring(type.getPackageName().length() + 1);
    return name.replace("$", "") + "Model";
  }

  private static String made(String type) {
    return "new " + type + "()";
  }

  private static String allMade(Class<?>... types) {
    return Stream.of(types)
        .map(type -> made(type.getCanonicalName()))
        .collect(Collectors.joining(", "));
  }

  private static String literal(Object value) {
    if (value instanceof Object[] values) {
      return Stream.of(values).map(GenerateModels::literal).collect(Collectors.joining(", "));
    }
    if (value instanceof String text) {
      return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n") + '"';
    }
    return value instanceof Class<?> type ? type.getCanonicalName() + ".class" : value.toString();
  }
}
