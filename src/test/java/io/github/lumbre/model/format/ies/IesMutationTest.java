package io.github.lumbre.model.format.ies;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.light.internal.LightProfile;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Warnings;
import io.github.lumbre.testing.FileMutator;
import io.github.lumbre.testing.Mutants;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every damaged file of a lamp is read, or refused with a reason. */
class IesMutationTest {
  private static final int QUICK = 3000;

  private static final List<String> FILES =
      List.of(
          IesSamples.FULL,
          IesSamples.OLD,
          IesSamples.file(
              List.of(0., 30., 60., 90.), List.of(0., 90., 180., 270., 360.), (p, a) -> p + a));

  @Test
  void mutantsAreReadOrRefused() {
    Mutants.few(QUICK, IesMutationTest::isRead);
  }

  @Test
  @Tag("fuzz")
  void manyMutantsAreReadOrRefused() {
    Mutants.many(IesMutationTest::isRead);
  }

  private static boolean isRead(long seed) {
    Random random = new Random(seed);
    String original = FILES.get(random.nextInt(FILES.size()));
    FileMutator mutator = new FileMutator(random);
    byte[] file =
        random.nextInt(4) == 0
            ? mutator.changed(IesSamples.bytes(original), original.length())
            : mutator.changedWords(
                original, "TILT=NONE", "TILT=INCLUDE", "TILT=a.tlt", "IESNA91", "90", "1024");
    try {
      Warnings warnings = new Warnings();
      check(IesReader.read(file, warnings), random);
      assertThat(warnings.all()).allMatch(text -> text.length() < 300);
      return true;
    } catch (ModelFormatException e) {
      Mutants.assertPrintable(e.getMessage(), 300);
      return false;
    }
  }

  private static void check(LightProfile lamp, Random random) {
    assertThat(lamp.flux()).isFinite().isGreaterThanOrEqualTo(0);
    for (int i = 0; i < 8; i++) {
      Vec3 direction =
          i == 0
              ? Vec3.Z.negated()
              : new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                  .normalized();
      double rounding = 1e-12 * lamp.largest();
      assertThat(lamp.intensity(direction)).isBetween(0., lamp.largest() + rounding);
    }
  }
}
