package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.testing.FileMutator;
import io.github.lumbre.testing.Mutants;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every damaged stream is decoded or refused, soon, and with no more memory than it counts. */
class DracoMutationTest {
  private static final int QUICK = 3000;
  private static final int HEADER = 60;
  private static final long MAX_BYTES = 30_000_000;

  private static final List<byte[]> FILES = DracoSamples.files().toList();

  @Test
  void mutantsAreDecodedOrRefused() {
    Mutants.few(QUICK, DracoMutationTest::isDecoded);
  }

  @Test
  @Tag("fuzz")
  void manyMutantsAreDecodedOrRefused() {
    Mutants.many(DracoMutationTest::isDecoded);
  }

  private static boolean isDecoded(long seed) {
    Random random = new Random(seed);
    byte[] original = FILES.get(random.nextInt(FILES.size()));
    byte[] file = new FileMutator(random).changed(original, HEADER);
    long[] counted = {0};
    DracoLimits limits = new DracoLimits(100_000, 100_000, bytes -> count(bytes, counted));
    Mutants.Needs needs = new Mutants.Needs();
    try {
      DracoMesh mesh = DracoMesh.decode(file, "x", limits);
      check(mesh);
      return true;
    } catch (ModelFormatException e) {
      Mutants.assertPrintable(e.getMessage(), 200);
      return false;
    } finally {
      needs.assertLittle(counted[0]);
    }
  }

  private static void count(long bytes, long[] counted) throws ModelFormatException {
    if (counted[0] + bytes > MAX_BYTES) {
      throw new ModelFormatException(Kind.TOO_LARGE, "x", "expected less memory, found more");
    }
    counted[0] += bytes;
  }

  private static void check(DracoMesh mesh) {
    boolean isSound = mesh.corners().length % 3 == 0;
    for (int corner : mesh.corners()) {
      isSound &= corner >= 0 && corner < mesh.pointCount();
    }
    for (DracoAttribute attribute : mesh.attributes()) {
      long size = (long) mesh.pointCount() * attribute.components() * attribute.type().size();
      isSound &= attribute.values().remaining() == size;
    }
    if (!isSound) {
      throw new IllegalStateException("unsound mesh of " + mesh.pointCount() + " points");
    }
  }
}
