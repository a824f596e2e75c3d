package io.github.lumbre;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.AccessTarget;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.syntax.elements.GivenClassesConjunction;
import io.github.lumbre.scene.Scene;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.module.ModuleDescriptor;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The layers of the code use only what is below them, and the library does not affect its host
 * program. The module exports no package that is internal or of formats.
 */
class LayersTest {
  private static final String ROOT = "io.github.lumbre.";

  /** The layers, from top to bottom: each uses only those below it. */
  private static final List<String> LAYERS =
      List.of(
          "cli", "lab", "stage", "scenefile", "model", "render", "integrator", "scene", "light",
          "material", "camera", "geometry", "texture", "image", "math", "base");

  /** The classes that use what is above them, in another layer or in a package of their own. */
  private static final Map<String, String> EXCEPTIONS =
      Map.of(
          "model.ModelOption", "model.section",
          "model.internal.ModelReader", "model.section",
          "image.format.gif.GifWriter", "image.animation",
          "image.format.png.ApngWriter", "image.animation",
          "image.format.imageio.JdkDecoder", "image.format.jpeg");

  /** Formats that are parts of others. */
  private static final Set<String> PARTS_OF_FORMATS =
      Set.of("model.format.draco", "model.format.meshopt", "image.format.zstd");

  /** The third-party libraries that each layer may use. */
  private static final Map<String, List<String>> LIBRARIES =
      Map.of(
          "geometry", List.of("jdk.incubator.vector."),
          "image", List.of("com.google.gson."),
          "base", List.of("com.google.gson."),
          "scenefile", List.of("com.google.gson."),
          "lab", List.of("com.sun.management.", "com.google.gson."),
          "cli", List.of("com.google.gson.", "picocli.", "com.sun.net.httpserver."));

  private static final Set<String> TRANSCENDENTAL =
      Set.of(
          "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp",
          "expm1", "log", "log10", "log1p", "pow", "cbrt", "hypot");

  private static final JavaClasses LUMBRE =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .importPackages("io.github.lumbre");

  /** A class and another class of Lumbre that it uses. */
  private record Use(JavaClass user, JavaClass used) {
    /** Returns whether the use is one of the exceptions. */
    boolean isExcepted() {
      String above = EXCEPTIONS.get(withoutNested(user.getName()).substring(ROOT.length()));
      return above != null && used.getPackageName().equals(ROOT + above);
    }

    @Override
    public String toString() {
      return withoutNested(user.getName()) + " -> " + withoutNested(used.getName());
    }
  }

  private static String withoutNested(String name) {
    return name.replaceFirst("\\$.*", "");
  }

  private static Stream<Use> uses() {
    return LUMBRE.stream()
        .filter(user -> user.getPackageName().startsWith(ROOT))
        .flatMap(
            user ->
                user.getDirectDependenciesFromSelf().stream()
                    .map(dependency -> dependency.getTargetClass().getBaseComponentType())
                    .filter(used -> used.getPackageName().startsWith(ROOT))
                    .map(used -> new Use(user, used)));
  }

  private static String layer(JavaClass type) {
    return type.getPackageName().substring(ROOT.length()).replaceFirst("\\..*", "");
  }

  /** Returns a package; what is internal, or reads and writes formats, belongs to the outer one. */
  private static String outer(JavaClass type) {
    return type.getPackageName().replaceFirst("\\.(internal|format)(\\..*)?$", "");
  }

  private static void assertNone(Stream<Use> uses) {
    assertThat(uses.map(Use::toString).distinct().sorted()).isEmpty();
  }

  @Test
  void everyPackageIsInALayer() {
    assertThat(
            LUMBRE.stream()
                .filter(type -> type.getPackageName().startsWith(ROOT))
                .map(LayersTest::layer)
                .collect(Collectors.toSet()))
        .isEqualTo(Set.copyOf(LAYERS));
  }

  @Test
  void layersUseWhatIsBelow() {
    assertNone(
        uses()
            .filter(use -> !use.isExcepted())
            .filter(use -> LAYERS.indexOf(layer(use.used)) < LAYERS.indexOf(layer(use.user))));
  }

  @Test
  void exceptionsAreNeeded() {
    assertThat(
            uses()
                .filter(Use::isExcepted)
                .map(use -> withoutNested(use.user.getName()).substring(ROOT.length()))
                .collect(Collectors.toSet()))
        .isEqualTo(EXCEPTIONS.keySet());
  }

  /** Inside a layer, packages use each other one way. */
  @Test
  void packagesHaveNoCycles() {
    Map<String, Set<String>> below = new TreeMap<>();
    uses()
        .filter(use -> !use.isExcepted() && !outer(use.user).equals(outer(use.used)))
        .forEach(
            use ->
                below
                    .computeIfAbsent(outer(use.user), k -> new TreeSet<>())
                    .add(outer(use.used)));
    boolean isShorter = true;
    while (isShorter) {
      below.values().forEach(used -> used.retainAll(below.keySet()));
      isShorter = below.values().removeIf(Set::isEmpty);
    }
    assertThat(below).isEmpty();
  }

  @Test
  void formatsUseNoOtherFormats() {
    assertNone(
        uses()
            .filter(use -> !use.isExcepted())
            .filter(
                use ->
                    use.user.getPackageName().contains(".format.")
                        && use.used.getPackageName().contains(".format.")
                        && !use.user.getPackageName().equals(use.used.getPackageName())
                        && !PARTS_OF_FORMATS.contains(
                            use.used.getPackageName().substring(ROOT.length()))));
  }

  @Test
  void layersUseTheirLibrariesAlone() {
    Stream<String> found =
        LUMBRE.stream()
            .filter(user -> user.getPackageName().startsWith(ROOT))
            .flatMap(
                user ->
                    user.getDirectDependenciesFromSelf().stream()
                        .map(dependency -> dependency.getTargetClass().getBaseComponentType())
                        .filter(used -> !used.isPrimitive())
                        .filter(used -> !isKnown(layer(user), used.getName()))
                        .map(used -> user.getName() + " -> " + used.getName()));
    assertThat(found.distinct()).isEmpty();
  }

  private static boolean isKnown(String layer, String type) {
    return Stream.concat(
            Stream.of(ROOT, "java.", "javax.imageio.", "org.jspecify."),
            LIBRARIES.getOrDefault(layer, List.of()).stream())
        .anyMatch(type::startsWith);
  }

  @Test
  void oneClassNeedsTheVectorModule() {
    check(
        noClasses()
            .that()
            .doNotHaveFullyQualifiedName(ROOT + "geometry.VectorTraversal")
            .should()
            .dependOnClassesThat(
                resideInAPackage("jdk.incubator.vector..")
                    .or(named(ROOT + "geometry.VectorTraversal"))));
  }

  /** The measuring commands, and what they alone use. */
  @Test
  void theLabIsKnownToTheMeasuringCommandsAlone() {
    check(
        noClasses()
            .that()
            .resideInAPackage(ROOT + "cli..")
            .and()
            .haveNameNotMatching(
                ".*\\.cli\\.((Benchmark|Coverage|Perf|SelfTest|Trade)Command|TradeRun"
                    + "|CommandLineHost)(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .resideInAPackage(ROOT + "lab.."));
  }

  @Test
  void moduleExportsTheLibraryAlone() throws IOException, URISyntaxException {
    URI classes = Scene.class.getProtectionDomain().getCodeSource().getLocation().toURI();
    ModuleDescriptor module;
    try (InputStream in = Files.newInputStream(Path.of(classes).resolve("module-info.class"))) {
      module = ModuleDescriptor.read(in);
    }
    assertThat(module.exports().stream().map(ModuleDescriptor.Exports::source))
        .noneMatch(name -> name.matches(".*\\.(cli|lab|internal|format)(\\..*)?"));
    assertThat(module.opens()).isEmpty();
    assertThat(
            module.requires().stream()
                .filter(r -> !r.modifiers().contains(ModuleDescriptor.Requires.Modifier.STATIC))
                .map(ModuleDescriptor.Requires::name))
        .containsExactlyInAnyOrder("java.base", "java.desktop", "com.google.gson");
  }

  @Test
  void geometryKnowsOfTexturesOnlyWhereTheyAreRead() {
    check(
        noClasses()
            .that()
            .resideInAPackage(ROOT + "geometry")
            .should()
            .dependOnClassesThat(
                resideInAPackage(ROOT + "texture")
                    .and(DescribedPredicate.not(named(ROOT + "texture.TexturePoint")))
                    .and(DescribedPredicate.not(named(ROOT + "texture.SurfacePoint")))));
  }

  @Test
  void libraryNeitherPrintsNorExits() {
    check(
        library()
            .should()
            .accessTargetWhere(
                accessTo(System.class, Set.of("out", "err", "exit"))
                    .or(accessTo(Runtime.class, Set.of("exit", "halt", "addShutdownHook")))
                    .or(accessTo(Throwable.class, Set.of("printStackTrace")))));
  }

  /** A setting declares its flag, an exit code its cause; programs and Java have flags, too. */
  @Test
  void theLibraryKnowsNoFlags() throws IOException {
    Pattern flag = Pattern.compile("\"([^\"]*[^\"\\w-])?--[a-z][^\"]*\"");
    Path sources = Path.of("src/main/java/io/github/lumbre");
    try (Stream<Path> files = Files.walk(sources)) {
      assertThat(
              files
                  .map(sources::relativize)
                  .filter(file -> file.toString().endsWith(".java"))
                  .filter(file -> !file.startsWith("cli") && !file.startsWith("lab"))
                  .filter(file -> flag.matcher(text(sources.resolve(file))).find())
                  .map(file -> file.getFileName().toString()))
          .containsExactlyInAnyOrder(
              "ExitCode.java",
              "KnownProgram.java",
              "Setting.java",
              "OpenImageDenoise.java",
              "Vectors.java");
    }
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void nothingIsRandomButBySeed() {
    check(
        noClasses()
            .that()
            .doNotHaveFullyQualifiedName(ROOT + "cli.view.RequestGuard") // a secret
            .should()
            .dependOnClassesThat()
            .haveNameMatching(
                "java\\.util\\.(Random|SplittableRandom)|java\\.util\\.random\\..*"
                    + "|java\\.util\\.concurrent\\.ThreadLocalRandom|java\\.security\\.SecureRandom"));
    check(noClasses().should().accessTargetWhere(accessTo(Math.class, Set.of("random"))));
  }

  @Test
  void elementaryFunctionsAreTheSameOnEveryMachine() {
    check(library().should().accessTargetWhere(accessTo(Math.class, TRANSCENDENTAL)));
  }

  @Test
  void strictMathHasTwoHomes() {
    check(
        library()
            .and()
            .haveNameNotMatching(".*\\.math\\.internal\\.Elementary(\\$.*)?")
            .and()
            .resideOutsideOfPackage(ROOT + "image..")
            .should()
            .dependOnClassesThat()
            .areAssignableTo(StrictMath.class));
  }

  @Test
  void nothingOpensAWindow() {
    check(
        noClasses()
            .should()
            .dependOnClassesThat()
            .haveNameMatching(
                "javax\\.swing\\..*|java\\.awt\\.event\\..*"
                    + "|java\\.awt\\.(Component|Window|Frame|Dialog|Canvas|Toolkit|Robot|Desktop)"));
  }

  private static GivenClassesConjunction library() {
    return noClasses().that().resideOutsideOfPackage(ROOT + "cli..");
  }

  private static DescribedPredicate<JavaClass> named(String name) {
    return DescribedPredicate.describe(name, type -> type.getName().equals(name));
  }

  private static DescribedPredicate<JavaAccess<?>> accessTo(Class<?> owner, Set<String> names) {
    return DescribedPredicate.describe(
        owner.getSimpleName() + "." + names,
        access -> {
          AccessTarget target = access.getTarget();
          return target.getOwner().isAssignableTo(owner) && names.contains(target.getName());
        });
  }

  private static void check(ArchRule rule) {
    rule.check(LUMBRE);
  }
}
