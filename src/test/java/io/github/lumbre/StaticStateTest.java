package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import io.github.lumbre.cli.Lumbre;
import io.github.lumbre.cli.run.Engine;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * What is static does not change once its class is initialized, except in three classes. The test
 * follows all static fields to the objects that they reach.
 */
class StaticStateTest {
  private static final String ROOT = "io.github.lumbre.";
  private static final Path SOURCES = Path.of("src/main/java");

  private static final JavaClasses CLASSES =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .importPackages("io.github.lumbre");

  /** The classes with static state that changes, and why it can belong to no object. */
  private static final Map<String, String> STATE =
      Map.of(
          "geometry.internal.CompiledKernel", "all renders of a JVM share what its JIT compiled",
          "base.file.ProcessEnd", "signals arrive at a process, not at an object",
          "texture.internal.InvalidCoordinates", "textures get no argument to count with");

  /** Types of objects that the class of a static field fills, and that nobody writes again. */
  private static final Set<String> TABLES =
      Set.of("Family", "Kind", "MaterialParameter", "Setting", "Placements", "Table");

  /** Static collections of other types than immutable ones, and fields with parts of tables. */
  private static final Set<String> FILLED_ONCE =
      Set.of(
          "AssetTable.TYPES", "ChangePicture.COLORS", "Lumbre.COMMANDS", "Lumbre.SECTIONS",
          "ModelInputs.INPUTS", "Input.schema", "Suggestions.COMMANDS", "Suggestions.FLAGS",
          "EncodedFormat.LEGACY", "MaterialKinds.PARAMETERS", "ModelObjects.KEYS",
          "ObjectKeys.OF_EMITTERS", "View.STANDARD", "Value.reader", "GlyphTable.GLYPHS",
          "MaterialParameter.ALL", "Setting.ALL");

  /** Components of arrays, which are tables of numbers or of constants. */
  private static final Set<String> ARRAYS =
      Set.of(
          "byte", "short", "int", "long", "float", "double", "Class", "Integer", "Lamp", "Layer", "Mode",
          "PixelHalves", "Shape", "String", "UastcMode", "Vec3");

  /** Other types of Java and libraries, which are constants or state nothing of ours. */
  private static final Pattern CONSTANTS =
      Pattern.compile(
          "java\\.lang\\.(Boolean|Byte|Character|Class|Double|Float|Integer|Long|Module|Short)"
              + "|java\\.lang\\.String|java\\.math\\.MathContext|java\\.time\\..*"
              + "|java\\.util\\.regex\\.Pattern|java\\.util\\.Collections\\$ReverseComparator2?"
              + "|java\\.util\\.Optional(Double|Int|Long)|sun\\.nio\\.fs\\..*Path"
              + "|.*\\$\\$Lambda.*|jdk\\.incubator\\.vector\\..*Species|com\\.google\\.gson\\.Gson"
              + "|com\\.sun\\.management\\.internal\\..*|java\\.io\\.PrintWriter");

  /** The objects that static fields reach, and what of them may change. */
  private static final class Reached {
    final Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
    final Set<String> changeable = new TreeSet<>();
    int hash = 1;

    void addStatic(Class<?> type) {
      for (Field field : type.getDeclaredFields()) {
        if (Modifier.isStatic(field.getModifiers()) && !field.isSynthetic()) {
          add(field, null);
        }
      }
    }

    private void add(Field field, Object owner) {
      String type = field.getDeclaringClass().getName().replaceFirst(".*[.$](?=[A-Z])", "");
      String place = type + "." + field.getName();
      if (!Modifier.isFinal(field.getModifiers()) && (owner == null || !TABLES.contains(type))) {
        changeable.add(place + " is not final");
      }
      try {
        field.setAccessible(true);
        add(TABLES.contains(type) ? "table" : place, field.get(owner));
      } catch (IllegalAccessException e) {
        throw new AssertionError(e);
      }
    }

    private void add(String place, Object value) {
      if (value == null || !seen.add(value)) {
        return;
      }
      Class<?> type = value.getClass();
      if (type.isArray()) {
        addArray(place, value);
      } else if (value instanceof Collection<?> all) {
        addAll(place, type, all);
      } else if (value instanceof Map<?, ?> all) {
        addAll(place, type, all.keySet());
        addAll(place, type, all.values());
      } else if (value instanceof Optional<?> one) {
        add(place, one.orElse(null));
      } else if (type.getName().startsWith(ROOT) && !type.isHidden()) {
        for (Class<?> c = type; c.getName().startsWith(ROOT); c = c.getSuperclass()) {
          Stream.of(c.getDeclaredFields())
              .filter(field -> !Modifier.isStatic(field.getModifiers()))
              .forEach(field -> add(field, value));
        }
      } else {
        addConstant(place, value);
      }
    }

    private void addAll(String place, Class<?> type, Collection<?> values) {
      if (!type.getName().matches("java\\.util\\.(Immutable)?Collections\\$.*")
          && !place.equals("table")
          && !FILLED_ONCE.contains(place)) {
        changeable.add(place + " is a " + type.getSimpleName());
      }
      hash = 31 * hash + values.size();
      values.forEach(value -> add(place, value));
    }

    private void addArray(String place, Object array) {
      Class<?> component = array.getClass().getComponentType();
      if (!component.isArray() && !ARRAYS.contains(component.getSimpleName())) {
        changeable.add(place + " is an array of " + component.getSimpleName());
      }
      for (int i = 0; i < Array.getLength(array); i++) {
        if (component.isPrimitive()) {
          hash = 31 * hash + Array.get(array, i).hashCode();
        } else {
          add(place, Array.get(array, i));
        }
      }
    }

    private void addConstant(String place, Object value) {
      if (!CONSTANTS.matcher(value.getClass().getName()).matches()) {
        changeable.add(place + " is a " + value.getClass().getName());
      }
      if (value instanceof Number || value instanceof String || value instanceof Boolean) {
        hash += value.hashCode();
      }
    }
  }

  private static Reached reached() {
    Reached reached = new Reached();
    CLASSES.stream()
        .filter(type -> !STATE.containsKey(type.getName().substring(ROOT.length())))
        .forEach(type -> reached.addStatic(type.reflect()));
    return reached;
  }

  @Test
  void staticStateThatChangesIsInFewClasses() {
    assertThat(STATE).hasSizeLessThanOrEqualTo(3);
    assertThat(reached().changeable).isEmpty();
  }

  /** Tables stay what they are while the program works. */
  @Test
  void rendersChangeNoTable(@TempDir Path directory) {
    int before = reached().hash;
    PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
    String[] render = {
      "render", "scenes/cornell-box.json", "-s", "2", "--size", "16x16", "-o",
      directory.resolve("a.png").toString()
    };
    assertThat(Lumbre.run(render, nowhere, nowhere, Engine.LOCAL)).isZero();
    assertThat(reached().hash).isEqualTo(before);
  }

  /** Whoever needs what an internal implementation has gets it without a cast. */
  @Test
  void nothingIsCastToAnInternalImplementation() throws IOException {
    Set<String> names =
        CLASSES.stream()
            .filter(type -> !isExported(type) && !type.isAnonymousClass())
            .filter(StaticStateTest::isOfAnExportedType)
            .map(JavaClass::getSimpleName)
            .collect(Collectors.toCollection(TreeSet::new));
    assertThat(names).contains("ParsedScene", "SobolSampler", "ProfileLight");
    Pattern cast = Pattern.compile("\\((" + String.join("|", names) + ")(<[^()]*>)?\\) ?[\\w(]");
    try (Stream<Path> files = Files.walk(SOURCES)) {
      assertThat(
              files
                  .filter(file -> file.toString().endsWith(".java"))
                  .filter(file -> !file.endsWith("MetallicRoughness.java")) // a map, typed by keys
                  .filter(file -> cast.matcher(text(file)).find()))
          .isEmpty();
    }
  }

  private static boolean isOfAnExportedType(JavaClass type) {
    return Stream.concat(
            type.getAllRawSuperclasses().stream(), type.getAllRawInterfaces().stream())
        .anyMatch(above -> above.getModifiers().contains(JavaModifier.PUBLIC) && isExported(above));
  }

  private static boolean isExported(JavaClass type) {
    return text(SOURCES.resolve("module-info.java"))
        .contains("exports " + type.getPackageName() + ";");
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
