package io.github.lumbre.model.format.meshopt;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.meshopt.MeshoptSamples.Sample;
import io.github.lumbre.testing.FileMutator;
import io.github.lumbre.testing.Mutants;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every damaged stream is decoded or refused, soon, and with no memory besides its elements. */
class MeshoptMutationTest {
  private static final int QUICK = 1000;
  private static final int HEADER = 40;

  private static final List<Sample> SAMPLES =
      MeshoptSamples.all().stream().filter(sample -> sample.count() > 0).toList();

  @Test
  void mutantsAreDecodedOrRefused() {
    Mutants.few(QUICK, MeshoptMutationTest::isDecoded);
  }

  @Test
  @Tag("fuzz")
  void manyMutantsAreDecodedOrRefused() {
    Mutants.many(MeshoptMutationTest::isDecoded);
  }

  /** Decodes a damaged stream with any filter, sometimes as more elements. */
  private static boolean isDecoded(long seed) {
    Random random = new Random(seed);
    Sample sample = SAMPLES.get(random.nextInt(SAMPLES.size()));
    byte[] file = new FileMutator(random).changed(sample.stream(), HEADER);
    MeshoptFilter filter = MeshoptFilter.values()[random.nextInt(MeshoptFilter.values().length)];
    int count = sample.count() + (random.nextInt(4) == 0 ? 3 * random.nextInt(100_000) : 0);
    Mutants.Needs needs = new Mutants.Needs();
    try {
      ByteBuffer decoded = sample.mode().decode(ByteBuffer.wrap(file), count, sample.stride(), "x");
      assertThat(decoded.remaining()).isEqualTo(count * sample.stride());
      if (sample.mode() == MeshoptMode.ATTRIBUTES && filter.fits(sample.stride())) {
        filter.restore(decoded, sample.stride());
      }
      return true;
    } catch (ModelFormatException e) {
      Mutants.assertPrintable(e.getMessage(), 200);
      return false;
    } finally {
      needs.assertLittle((long) count * sample.stride());
    }
  }
}
