package io.github.lumbre.lab.checks;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.material.Bsdf;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Folders;
import io.github.lumbre.testing.InParallel;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** The checks of {@code lumbre selftest} pass on this machine. */
class InvariantsTest {
  private static final Tries TRIES = new Tries(Effort.count(1, 10), Effort.seed(0));

  @Test
  void lawsHold() {
    InParallel.forEach(
        Invariants.all(),
        law -> assertThat(law.measure(TRIES).worst()).as(law.name()).isBetween(0.0, law.limit()));
  }

  /**
   * Every class that scatters light is measured. The others bend normals or count less of another
   * BSDF, or return black.
   */
  @Test
  void everyLobeOfEveryMaterialIsMeasured() throws Exception {
    Set<String> measured = new TreeSet<>();
    for (Bsdf bsdf : MeasuredMaterials.everything()) {
      addParts(bsdf, measured);
    }
    Path classes = Path.of(Bsdf.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    Path materials = classes.resolve("io/github/lumbre/material");
    Set<String> expected = new TreeSet<>();
    for (Path file : Folders.below(materials, ".class")) {
      String name = classes.relativize(file).toString().replace(".class", "");
      Class<?> type = Class.forName(name.replaceAll("[/\\\\]", "."));
      if (Bsdf.class.isAssignableFrom(type) && !Modifier.isAbstract(type.getModifiers())) {
        expected.add(type.getSimpleName());
      }
    }
    expected.removeAll(Set.of("Absorber", "Faded", "Tilted"));
    assertThat(measured).containsAll(expected);
  }

  private static void addParts(Object part, Set<String> names) throws IllegalAccessException {
    if (part instanceof Bsdf) {
      names.add(part.getClass().getSimpleName());
      for (Field field : part.getClass().getDeclaredFields()) {
        if (!Modifier.isStatic(field.getModifiers())) {
          field.setAccessible(true);
          addParts(field.get(part), names);
        }
      }
    }
  }

  @Test
  void namesAreDistinct() {
    List<String> names = Invariants.all().stream().map(Invariant::name).toList();
    assertThat(names).doesNotHaveDuplicates().allMatch(name -> name.matches("[a-z0-9-]+"));
  }

  @Test
  void whatIsNoNumberDoesNotHold() throws InterruptedException {
    assertThat(law(.9).measure(TRIES).holds()).isTrue();
    assertThat(law(1.1).measure(TRIES).holds()).isFalse();
    assertThat(law(Double.NaN).measure(TRIES).holds()).isFalse();
    assertThat(law(Double.POSITIVE_INFINITY).measure(TRIES).holds()).isFalse();
  }

  private static Invariant law(double worst) {
    return new Invariant("some", "what", "where", 1, tries -> worst);
  }
}
