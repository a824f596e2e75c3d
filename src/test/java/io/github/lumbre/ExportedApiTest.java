package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ModifiersTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePath;
import com.sun.source.util.TreePathScanner;
import com.sun.source.util.Trees;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Executable;
import java.lang.reflect.Member;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.jspecify.annotations.NullMarked;
import org.junit.jupiter.api.Test;

/**
 * The exported types and members are those of {@code src/test/resources/api.txt}, and each has a
 * documentation comment. To accept a change of the list: {@code ./mvnw test -Dtest=ExportedApiTest
 * -Dlumbre.write=true}.
 */
class ExportedApiTest {
  private static final Path SOURCES = Path.of("src/main/java");
  private static final Path LIST = Path.of("src/test/resources/api.txt");
  private static final int MOST_TYPES = 143;
  private static final int MOST_NESTED = 40;
  private static final Pattern EXPORT = Pattern.compile("(?m)^ *exports ([\\w.]+);");

  @Test
  void exportedSignaturesAreThoseOfTheList() throws IOException {
    List<String> lines = new ArrayList<>();
    for (Class<?> type : exportedTypes()) {
      lines.add(line(type));
      Stream.of(type.getDeclaredFields(), type.getDeclaredConstructors(), type.getDeclaredMethods())
          .flatMap(Arrays::stream)
          .map(Member.class::cast)
          .filter(member -> isVisible(member.getModifiers()) && !member.isSynthetic())
          .map(ExportedApiTest::line)
          .forEach(lines::add);
    }
    String expected = String.join("\n", lines.stream().sorted().toList()) + "\n";
    if (Boolean.getBoolean("lumbre.write")) {
      Files.writeString(LIST, expected);
    }
    assertThat(expected).isEqualTo(Files.readString(LIST));
  }

  /** Fewer types are easier to learn: these bounds go down, not up. */
  @Test
  void fewTypesAreExported() throws IOException {
    List<Class<?>> types = exportedTypes();
    long nested = types.stream().filter(Class::isMemberClass).count();
    assertThat(types.size() - nested).isLessThanOrEqualTo(MOST_TYPES);
    assertThat(nested).isLessThanOrEqualTo(MOST_NESTED);
  }

  /** Compilers of Kotlin, and checkers of Java, then refuse null wherever it is not accepted. */
  @Test
  void everyExportedPackageSaysWhatMayBeNull() throws Exception {
    for (Path folder : exportedFolders()) {
      String name = SOURCES.relativize(folder).toString().replaceAll("[/\\\\]", ".");
      Class<?> notes = Class.forName(name + ".package-info");
      assertThat(notes.isAnnotationPresent(NullMarked.class)).as(name).isTrue();
    }
  }

  private static List<Path> exportedFolders() throws IOException {
    return EXPORT
        .matcher(Files.readString(SOURCES.resolve("module-info.java")))
        .results()
        .map((MatchResult found) -> SOURCES.resolve(found.group(1).replace('.', '/')))
        .toList();
  }

  private static List<Path> exportedSources() throws IOException {
    List<Path> sources = new ArrayList<>();
    for (Path folder : exportedFolders()) {
      sources.addAll(Folders.files(folder, ".java"));
    }
    return sources;
  }

  private static List<Class<?>> exportedTypes() throws IOException {
    List<Class<?>> types = new ArrayList<>();
    for (Path source : exportedSources()) {
      String name = SOURCES.relativize(source).toString().replaceFirst("\\.java$", "");
      // The only class that needs the incubating module.
      if (!name.endsWith("package-info") && !name.endsWith("VectorTraversal")) {
        addVisible(name.replaceAll("[/\\\\]", "."), types);
      }
    }
    return types;
  }

  private static void addVisible(String name, List<Class<?>> types) {
    try {
      addVisible(Class.forName(name, false, ExportedApiTest.class.getClassLoader()), types);
    } catch (ClassNotFoundException e) {
      throw new AssertionError(name, e);
    }
  }

  private static void addVisible(Class<?> type, List<Class<?>> types) {
    if (isVisible(type.getModifiers())) {
      types.add(type);
      for (Class<?> nested : type.getDeclaredClasses()) {
        addVisible(nested, types);
      }
    }
  }

  private static boolean isVisible(int modifiers) {
    return Modifier.isPublic(modifiers) || Modifier.isProtected(modifiers);
  }

  private static String line(Class<?> type) {
    Stream<String> above =
        Stream.concat(
                Stream.ofNullable(type.getGenericSuperclass()),
                Arrays.stream(type.getGenericInterfaces()))
            .map(java.lang.reflect.Type::getTypeName)
            .filter(name -> !name.equals("java.lang.Object"));
    return type.getName() + ": " + type.toGenericString() + " is " + above.toList();
  }

  private static String line(Member member) {
    String signature =
        member instanceof Executable code ? code.toGenericString() : member.toString();
    return member.getDeclaringClass().getName() + ": " + signature;
  }

  @Test
  void everyExportedMemberHasAComment() throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    List<String> missing = new ArrayList<>();
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
      JavacTask task =
          (JavacTask)
              compiler.getTask(
                  null,
                  files,
                  null,
                  List.of("-proc:none"),
                  null,
                  files.getJavaFileObjectsFromPaths(exportedSources()));
      Trees trees = Trees.instance(task);
      for (CompilationUnitTree unit : task.parse()) {
        new Comments(trees, missing).scan(unit, null);
      }
    }
    assertThat(missing).isEmpty();
  }

  /** Collects the visible declarations without a documentation comment. */
  private static final class Comments extends TreePathScanner<Void, Void> {
    private final Trees trees;
    private final List<String> missing;

    Comments(Trees trees, List<String> missing) {
      this.trees = trees;
      this.missing = missing;
    }

    @Override
    public Void visitClass(ClassTree type, Void unused) {
      if (!isVisible(type.getModifiers())) {
        return null;
      }
      require(type.getSimpleName().toString());
      return super.visitClass(type, unused);
    }

    @Override
    public Void visitMethod(MethodTree method, Void unused) {
      if (isVisible(method.getModifiers())
          && !isOverride(method.getModifiers())
          && !isCompact(method)) {
        require(method.getName().toString());
      }
      return null;
    }

    @Override
    public Void visitVariable(VariableTree field, Void unused) {
      if (getCurrentPath().getParentPath().getLeaf() instanceof ClassTree
          && isVisible(field.getModifiers())) {
        require(field.getName().toString());
      }
      return null;
    }

    /** Returns whether it is the constructor of a record without parameters of its own. */
    private boolean isCompact(MethodTree method) {
      CompilationUnitTree unit = getCurrentPath().getCompilationUnit();
      int from = (int) trees.getSourcePositions().getStartPosition(unit, method);
      int body = (int) trees.getSourcePositions().getStartPosition(unit, method.getBody());
      return method.getName().contentEquals("<init>")
          && method.getBody() != null
          && !text(unit).substring(from, body).contains("(");
    }

    private static String text(CompilationUnitTree unit) {
      try {
        return unit.getSourceFile().getCharContent(true).toString();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    private static boolean isOverride(ModifiersTree modifiers) {
      return modifiers.getAnnotations().stream()
          .anyMatch(annotation -> annotation.getAnnotationType().toString().equals("Override"));
    }

    /** Members of interfaces are public, whatever they state. */
    private boolean isVisible(ModifiersTree modifiers) {
      TreePath parent = getCurrentPath().getParentPath();
      boolean inInterface = parent.getLeaf().getKind() == Tree.Kind.INTERFACE;
      return modifiers.getFlags().contains(javax.lang.model.element.Modifier.PUBLIC)
          || modifiers.getFlags().contains(javax.lang.model.element.Modifier.PROTECTED)
          || inInterface
              && !modifiers.getFlags().contains(javax.lang.model.element.Modifier.PRIVATE);
    }

    private void require(String name) {
      if (trees.getDocComment(getCurrentPath()) == null) {
        CompilationUnitTree unit = getCurrentPath().getCompilationUnit();
        long line =
            unit.getLineMap()
                .getLineNumber(
                    trees.getSourcePositions().getStartPosition(unit, getCurrentPath().getLeaf()));
        missing.add(
            Path.of(unit.getSourceFile().getName()).getFileName() + ":" + line + " " + name);
      }
    }
  }
}
