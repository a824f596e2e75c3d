package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class ProblemTextTest {
  private static final Path MODEL = Path.of("src/test/resources/cases/vc.obj");

  /** The library names the Java argument, and the command line its flag. */
  @Test
  void aLargePictureIsNamedByItsFlag() {
    SceneParser parser = new SceneParser().overriding(s -> s.toBuilder().size(9, 9).build());
    SceneFormatException e =
        catchThrowableOfType(
            SceneFormatException.class,
            () -> StagedModel.read(MODEL, Stage.DEFAULT, parser.limitedTo(80)));
    String found = "expected width x height <= 80, found 9x9";
    assertThat(e).hasMessage("vc.obj: size: " + found);
    assertThat(ProblemText.of(e)).containsExactly("vc.obj: --size: " + found);
  }

  @Test
  void placesInFilesStay() {
    Problem problem = new Problem("a.json", "$.sky", "found nothing");
    assertThat(ProblemText.of(problem)).isEqualTo("a.json: $.sky: found nothing");
    assertThat(ProblemText.of(new Problem("a.json", "", "found it"))).isEqualTo("a.json: found it");
  }
}
