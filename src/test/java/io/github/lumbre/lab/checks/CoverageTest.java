package io.github.lumbre.lab.checks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.lab.checks.Coverage.Cell;
import io.github.lumbre.lab.checks.Coverage.Judged;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests how pictures beyond their bounds are counted. */
class CoverageTest {
  private static Cell cell(int beyond, int within) {
    List<Judged> pictures = new ArrayList<>();
    for (int i = 0; i < beyond + within; i++) {
      pictures.add(new Judged(i < beyond ? .26 : .1, .1, .2, i == 0, false, 16));
    }
    return new Cell("16 samples", pictures, .0001);
  }

  @Test
  void picturesBeyondTheirBoundAreCounted() {
    assertThat(cell(3, 7).beyond()).isEqualTo(3);
    assertThat(cell(3, 7).farBeyond()).isEqualTo(3);
    assertThat(cell(0, 7).farBeyond()).isZero();
    assertThat(cell(3, 7).doubtful()).isEqualTo(1);
    assertThat(cell(3, 7).boundRatio()).isEqualTo(2);
    assertThat(cell(0, 7).referenceShare()).isCloseTo(.01, within(1e-12));
    assertThat(cell(3, 7).line()).startsWith("16 samples  3 of 10 beyond (3 by a quarter, 1 doub");
  }

  /** Binomial probabilities: 1 − .95^10, and 25 or more of 200. */
  @Test
  void chanceIsThatOfABoundThatHolds() {
    assertThat(cell(0, 10).chance()).isEqualTo(1);
    assertThat(cell(1, 9).chance()).isCloseTo(.401263, within(1e-6));
    assertThat(cell(25, 175).chance()).isCloseTo(2.607e-5, within(1e-8));
  }

  /** The mean of independent errors, with that of the reference taken off, is that of one seed. */
  @Test
  void errorsAreThoseAgainstTheConvergedPicture() throws Exception {
    SceneFile file =
        new SceneParser()
            .overriding(settings -> settings.toBuilder().size(16, 16).build())
            .parse(Path.of("scenes", "cornell-box.json"));
    Coverage few = new Coverage(file.scene(), file.settings(), 16, 64);
    Coverage many = new Coverage(file.scene(), file.settings(), 16, 2048);
    double error = many.ofSamples(List.of(4)).get(0).error();
    assertThat(few.ofSamples(List.of(4)).get(0).error()).isCloseTo(error, within(.05 * error));
  }
}
