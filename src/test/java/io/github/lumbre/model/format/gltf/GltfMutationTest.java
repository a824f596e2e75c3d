package io.github.lumbre.model.format.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.Mutants;
import java.io.IOException;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every damaged glTF file is read, or refused with a reason. */
class GltfMutationTest {
  /** Far more than the undamaged file needs. */
  private static final long MAX_BYTES = 1_000_000;

  private static final ModelOptions OPTIONS =
      new ModelOptions(
          Optional.of(new ModelOptions.Pose("0", .5)), Optional.of("red"), ModelOptions.Up.Y, 1);

  /** The same in motion, so that all that moves is read four times. */
  private static final ModelOptions MOVING =
      OPTIONS.with(ModelOption.POSE, new ModelOptions.Pose("0", .5, .25, 4));

  @Test
  void originalIsRead() throws ModelFormatException, IOException {
    Model model =
        GltfReader.read(
            GltfSample.file(),
            GltfFile.EMPTY,
            OPTIONS,
            new GltfBudget(Limits.NONE.withMemory(MAX_BYTES)));
    assertThat(model.parts()).hasSize(3);
    assertThat(model.warnings()).isEmpty();
  }

  @Test
  void mutantsAreReadOrRefused() throws IOException {
    Map<Ending, Integer> endings = run(Effort.seed(0), 2000);
    assertThat(endings).containsKeys(Ending.READ, Ending.MALFORMED, Ending.TOO_LARGE);
    assertThat(endings.get(Ending.READ)).isBetween(200, 1800);
  }

  @Test
  @Tag("fuzz")
  void aMillionMutants() throws IOException {
    long seed = Effort.seed(1);
    for (int i = 0; i < 100; i++) {
      assertThat(run(seed + 10_000L * i, 10_000)).containsKey(Ending.READ);
    }
  }

  /** How the reading of a file ends. */
  private enum Ending {
    READ,
    MALFORMED,
    UNSUPPORTED,
    TOO_LARGE,
    ASSET
  }

  private static Map<Ending, Integer> run(long seed, int count) throws IOException {
    byte[] original = GltfSample.file();
    Map<Ending, Integer> endings = new EnumMap<>(Ending.class);
    Mutants.read(
        seed,
        count,
        number -> {
          Ending ending = ending(new GltfMutator(number).mutant(original), number);
          endings.merge(ending, 1, Integer::sum);
          return ending == Ending.READ;
        });
    return endings;
  }

  private static Ending ending(byte[] file, long seed) throws IOException {
    try {
      ModelOptions options = (seed % 4 < 2 ? OPTIONS : MOVING).mayLackFiles(seed % 2 == 0);
      check(
          GltfReader.read(
              file, GltfFile.EMPTY, options, new GltfBudget(Limits.NONE.withMemory(MAX_BYTES))));
      return Ending.READ;
    } catch (ModelFormatException e) {
      assertThat(e.getMessage()).hasSizeLessThan(1000);
      return Ending.valueOf(e.kind().name());
    }
  }

  /** Reads mutants of another file, of which some are read and some refused. */
  static void checkMutants(byte[] original, long seed, int count) throws IOException {
    int read =
        Mutants.read(seed, count, number -> isRead(new GltfMutator(number).mutant(original)));
    assertThat(read).isBetween(count / 20, count * 19 / 20);
  }

  private static boolean isRead(byte[] mutant) throws IOException {
    try {
      GltfBudget budget = new GltfBudget(Limits.NONE.withMemory(10 * MAX_BYTES));
      check(GltfReader.read(mutant, GltfFile.EMPTY, ModelOptions.DEFAULT, budget));
      return true;
    } catch (ModelFormatException e) {
      assertThat(e.getMessage()).hasSizeLessThan(1000);
      return false;
    }
  }

  private static void check(Model model) {
    model.parts().forEach(GltfMutationTest::check);
    model.poses().forEach(pose -> pose.parts().forEach(GltfMutationTest::check));
  }

  private static void check(ModelPart part) {
    ModelGeometry mesh = part.geometry();
    int vertices = mesh.vertexCount();
    boolean isSound =
        part.toWorld().isInvertible()
            && mesh.indices().length % 3 == 0
            && fits(mesh.normals().length, 3 * vertices)
            && fits(mesh.tangents().length, 4 * vertices)
            && fits(mesh.uv0().length, 2 * vertices)
            && fits(mesh.uv1().length, 2 * vertices)
            && fits(mesh.colors().length, 4 * vertices);
    for (double position : mesh.positions()) {
      isSound &= Double.isFinite(position);
    }
    for (int index : mesh.indices()) {
      isSound &= index >= 0 && index < vertices;
    }
    if (!isSound) {
      throw new IllegalStateException("unsound mesh of " + vertices + " vertices");
    }
  }

  private static boolean fits(int found, int expected) {
    return found == 0 || found == expected;
  }
}
