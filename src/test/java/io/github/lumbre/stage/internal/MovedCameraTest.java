package io.github.lumbre.stage.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.option.ModelFlags;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** The flags of a camera that was moved place this very camera. */
class MovedCameraTest {
  private static final String OBJ =
      "v 10 2 3\nv 70 2 3\nv 70 42 3\nv 10 42 23\no a\nf 1 2 3\no b\nf 1 3 4\n";

  /** A command with the flags of models. */
  @Command(modelTransformer = SettingFlags.Adder.class)
  private static final class Staged {
    @Mixin private ModelFlags model;
  }

  private static Stage stage(List<String> flags) {
    Staged staged = new Staged();
    new CommandLine(staged).parseArgs(flags.toArray(String[]::new));
    return staged.model.stage();
  }

  private static ParsedScene scene(List<String> flags) throws Exception {
    SceneParser parser =
        new SceneParser().overriding(settings -> settings.toBuilder().size(60, 40).build());
    byte[] model = OBJ.getBytes(StandardCharsets.US_ASCII);
    return StagedModel.read("a.obj", model, ModelFolder.NONE, stage(flags), parser)
        .scene()
        .parsed();
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "--up=z", "--up=z --unit=0.001", "--unit=25.4 --labels=size,parts"})
  void theFlagsGiveTheCamera(String given) throws Exception {
    List<String> kept = given.isEmpty() ? List.of() : List.of(given.split(" "));
    ParsedScene home = scene(kept);
    double size = home.scene().radius();
    Random random = new Random(6304);
    for (int i = 0; i < 40; i++) {
      Vec3 target = new Vec3(random.nextGaussian(), 1 + random.nextGaussian(), .3).times(size);
      Vec3 eye = target.plus(3 * size, direction(i, random));
      boolean isParallel = random.nextBoolean();
      double height = (.1 + random.nextDouble()) * (isParallel ? size : 1);
      MovedCamera moved =
          MovedCamera.of(home, eye, target, isParallel, height).orElseThrow();
      List<String> flags = new ArrayList<>(kept);
      flags.addAll(moved.flags());
      ParsedScene again = scene(flags);
      ParsedScene seen = home.seenBy(moved.camera());
      assertThat(again.scene().camera().position())
          .as("%s", flags)
          .isEqualTo(seen.scene().camera().position());
      assertThat(again.scene().camera().axes()).isEqualTo(seen.scene().camera().axes());
      assertThat(ViewNumbers.projection(again.scene(), again.settings()).orElseThrow().matrix())
          .isEqualTo(ViewNumbers.projection(seen.scene(), seen.settings()).orElseThrow().matrix());
      assertThat(moved.camera().pose().position().minus(eye).length()).isLessThan(1e-5 * 3 * size);
    }
  }

  private static Vec3 direction(int round, Random random) {
    return switch (round) {
      case 0 -> Vec3.Y;
      case 1 -> Vec3.Z;
      case 2 -> Vec3.X.negated();
      default ->
          new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
              .normalized();
    };
  }
}
