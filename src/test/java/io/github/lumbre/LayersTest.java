package io.github.lumbre;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
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
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import io.github.lumbre.scene.Scene;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.module.ModuleDescriptor;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Packages form layers with downward dependencies only, and the library does not affect its host
 * program. A package of the library and the packages inside it, such as {@code internal} and those
 * of file formats, are one layer; the module exports at most the outer one.
 */
class LayersTest {
  private static final String ROOT = "io.github.lumbre.";
  private static final String LIBRARY =
      "math image drawing sampling texture geometry file text limit json path material camera light"
          + " scene outline label model guiding integrator render parser checkpoint denoise"
          + " stopping preview audit compare thumbnail difference base";

  /** The packages that each package may use, in addition to itself and Java. */
  private static final Map<String, String> MAY_USE =
      Map.ofEntries(
          Map.entry("math", "text"),
          Map.entry("file", ""),
          Map.entry("text", ""),
          Map.entry("base", "file"),
          Map.entry("limit", ""),
          Map.entry("json", "text limit"),
          Map.entry("image", "file limit"),
          Map.entry("path", "math image"),
          Map.entry("drawing", "image"),
          Map.entry("sampling", "math"),
          Map.entry("texture", "math image sampling"),
          Map.entry("geometry", "math image sampling texture limit"),
          Map.entry("difference", "math image geometry limit text material model"),
          Map.entry("material", "math image sampling texture geometry"),
          Map.entry("camera", "math sampling"),
          Map.entry("light", "math image sampling texture geometry"),
          Map.entry("scene", "math image geometry text material camera light"),
          Map.entry("outline", "math image drawing geometry limit material camera scene"),
          Map.entry("label", "math image drawing text camera"),
          Map.entry("guiding", ""),
          Map.entry(
              "integrator",
              "math image sampling texture geometry path material camera light scene guiding"),
          Map.entry("render", "limit math image sampling path camera scene guiding integrator"),
          Map.entry(
              "model", "math image texture geometry file text limit json material light scene"),
          Map.entry(
              "parser",
              "math image drawing sampling texture geometry file text limit json material camera"
                  + " light scene outline label model"),
          Map.entry("checkpoint", "file image scene render"),
          Map.entry("denoise", "file math image sampling scene render"),
          Map.entry("stopping", "math image scene render"),
          Map.entry("preview", "image scene render checkpoint stopping"),
          Map.entry(
              "audit",
              "math image sampling texture geometry path material camera light scene render"
                  + " parser"),
          Map.entry("compare", "math image"),
          Map.entry("thumbnail", "image limit text scene model render parser denoise"),
          Map.entry("lab", "base image text scene render parser"),
          Map.entry("lab.metrics", "math image"),
          Map.entry("lab.perf", "base image text scene render parser lab lab.metrics"),
          Map.entry("lab.report", "base text scene render parser lab lab.perf"),
          Map.entry(
              "lab.checks",
              "math image sampling texture geometry text material camera light scene integrator"
                  + " render stopping lab"),
          Map.entry(
              "lab.trade",
              "math image sampling geometry text scene integrator render denoise stopping lab"
                  + " lab.metrics lab.perf compare"),
          Map.entry(
              "cli.output",
              "math image sampling geometry file text path material camera light scene model"
                  + " render parser checkpoint stopping base"),
          Map.entry(
              "cli.run",
              "image drawing file text limit scene render parser checkpoint denoise"
                  + " stopping base cli.output"),
          Map.entry(
              "cli.option",
              "image geometry file text scene model parser checkpoint denoise stopping base"
                  + " cli.output cli.run"),
          Map.entry(
              "cli.view",
              "math image geometry path camera scene render parser checkpoint denoise"
                  + " text stopping preview base cli.output cli.run"),
          Map.entry("cli.diff", "image drawing geometry camera sampling scene parser difference"),
          Map.entry(
              "cli.mcp",
              "math image drawing text limit json scene model render parser compare file base"
                  + " cli.output cli.run"),
          Map.entry(
              "cli",
              "base math image drawing texture file text scene model render parser checkpoint"
                  + " denoise audit compare lab lab.perf lab.report lab.checks lab.trade cli.output"
                  + " cli.run cli.option cli.view cli.mcp cli.diff difference math"));

  /** The third-party libraries that each package may use. */
  private static final Map<String, List<String>> LIBRARIES =
      Map.ofEntries(
          Map.entry("geometry", List.of("jdk.incubator.vector..")),
          Map.entry("image", List.of("com.google.gson..")),
          Map.entry("json", List.of("com.google.gson..")),
          Map.entry("parser", List.of("com.google.gson..")),
          Map.entry("lab", List.of("com.sun.management..")),
          Map.entry("lab.perf", List.of("com.google.gson..")),
          Map.entry("lab.trade", List.of("com.google.gson..")),
          Map.entry("cli.output", List.of("com.google.gson..", "picocli..")),
          Map.entry("cli.option", List.of("picocli..")),
          Map.entry("cli.view", List.of("com.google.gson..", "com.sun.net.httpserver..")),
          Map.entry("cli", List.of("com.google.gson..", "picocli..")));

  private static final Set<String> TRANSCENDENTAL =
      Set.of(
          "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp",
          "expm1", "log", "log10", "log1p", "pow", "cbrt", "hypot");

  private static final JavaClasses LUMBRE =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .importPackages("io.github.lumbre");

  private static final SliceAssignment LAYERS =
      new SliceAssignment() {
        @Override
        public SliceIdentifier getIdentifierOf(JavaClass type) {
          return type.getPackageName().startsWith(ROOT)
              ? SliceIdentifier.of(layer(type.getPackageName()))
              : SliceIdentifier.ignore();
        }

        @Override
        public String getDescription() {
          return "layers";
        }
      };

  static Stream<String> packages() {
    return MAY_USE.keySet().stream().sorted();
  }

  @Test
  void everyPackageHasItsLayer() {
    Set<String> found =
        LUMBRE.stream()
            .map(JavaClass::getPackageName)
            .filter(name -> name.startsWith(ROOT))
            .map(LayersTest::layer)
            .collect(Collectors.toSet());
    assertThat(found).isEqualTo(MAY_USE.keySet());
  }

  @ParameterizedTest
  @MethodSource("packages")
  void packageUsesOnlyWhatLiesBelow(String name) {
    String[] allowed =
        Stream.of(
                Stream.of("java..", "javax.imageio..", "org.jspecify.."),
                Stream.of(packagesOf(name)),
                below(name).stream().map(LayersTest::packagesOf).flatMap(Stream::of),
                LIBRARIES.getOrDefault(name, List.of()).stream())
            .flatMap(s -> s)
            .toArray(String[]::new);
    check(
        classes()
            .that()
            .resideInAnyPackage(packagesOf(name))
            .should()
            .onlyDependOnClassesThat(resideInAnyOf(allowed)));
  }

  /** What may be used and is not would hide that a layer has come apart. */
  @ParameterizedTest
  @MethodSource("packages")
  void packageUsesAllThatItMayUse(String name) {
    Set<String> used =
        LUMBRE.stream()
            .filter(
                type ->
                    type.getPackageName().startsWith(ROOT)
                        && layer(type.getPackageName()).equals(name))
            .flatMap(type -> type.getDirectDependenciesFromSelf().stream())
            .map(dependency -> dependency.getTargetClass().getBaseComponentType().getPackageName())
            .filter(target -> target.startsWith(ROOT))
            .map(LayersTest::layer)
            .collect(Collectors.toSet());
    assertThat(used).containsAll(below(name));
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

  @Test
  void packagesHaveNoCycles() {
    check(slices().assignedFrom(LAYERS).should().beFreeOfCycles());
  }

  @Test
  void zonesHaveArrowsOneWay() {
    check(
        noClasses()
            .that()
            .resideInAnyPackage(packagesOf(LIBRARY))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(ROOT + "lab..", ROOT + "cli.."));
    check(
        noClasses()
            .that()
            .resideInAPackage(ROOT + "lab..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage(ROOT + "cli.."));
    check(
        noClasses()
            .that()
            .resideOutsideOfPackage(ROOT + "cli..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("picocli.."));
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
  void everyPackageIsInOneZone() {
    assertThat(MAY_USE.keySet().stream().filter(LayersTest::isOfLibrary))
        .containsExactlyInAnyOrder(LIBRARY.split(" "));
  }

  @Test
  void moduleExportsTheLibraryAlone() throws IOException, URISyntaxException {
    URI classes = Scene.class.getProtectionDomain().getCodeSource().getLocation().toURI();
    ModuleDescriptor module;
    try (InputStream in = Files.newInputStream(Path.of(classes).resolve("module-info.class"))) {
      module = ModuleDescriptor.read(in);
    }
    assertThat(module.exports().stream().map(ModuleDescriptor.Exports::source))
        .isSubsetOf(Arrays.stream(LIBRARY.split(" ")).map(ROOT::concat).toList());
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
              "ExitCode.java", "Setting.java", "OpenImageDenoise.java", "Vectors.java");
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
            .resideOutsideOfPackages(packagesOf("image"))
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

  private static String[] packagesOf(String names) {
    return Arrays.stream(names.split(" "))
        .map(name -> ROOT + name + (isOfLibrary(name) ? ".." : ""))
        .toArray(String[]::new);
  }

  /** Returns the layer of a package below the root: in the library, the outer package. */
  private static String layer(String packageName) {
    String name = packageName.substring(ROOT.length());
    return isOfLibrary(name) ? name.replaceFirst("\\..*", "") : name;
  }

  private static boolean isOfLibrary(String name) {
    return !name.matches("(lab|cli)(\\..*)?");
  }

  private static List<String> below(String name) {
    return Arrays.stream(MAY_USE.get(name).split(" ")).filter(p -> !p.isEmpty()).toList();
  }

  private static DescribedPredicate<JavaClass> resideInAnyOf(String... packages) {
    return JavaClass.Predicates.resideInAnyPackage(packages)
        .or(DescribedPredicate.describe("are primitive", LayersTest::isPrimitive));
  }

  private static boolean isPrimitive(JavaClass type) {
    return type.getBaseComponentType().isPrimitive();
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
