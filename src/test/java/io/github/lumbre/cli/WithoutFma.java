package io.github.lumbre.cli;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.math.internal.FusedMultiplyAdd;
import java.nio.file.Path;
import java.util.List;

/**
 * Small renders in a JVM of its own, which uses no fused multiply-add. It prints whether {@link
 * Math#fma} is fast there, and why the vector kernel is not available.
 */
final class WithoutFma {
  private static final Path CASES = Path.of("src/test/resources/cases");

  /** Materials of all models: the clear coat and its tables, textures, smooth normals, colors. */
  static final List<Path> INPUTS =
      List.of(
          CASES.resolve("coat_normal.gltf"),
          CASES.resolve("terminator.glb"),
          CASES.resolve("texfile.ply"),
          CASES.resolve("vc.obj"),
          Path.of("scenes/cornell-box.json"),
          Path.of("scenes/torus-knot.json"),
          Path.of("scenes/glass-and-mirror.json"));

  private WithoutFma() {}

  /** Writes the pictures of all inputs into the folder of the first argument. */
  public static void main(String[] args) {
    for (Path input : INPUTS) {
      render(input, picture(Path.of(args[0]), input));
    }
    System.out.println(FusedMultiplyAdd.isFast());
    System.out.println(Kernel.vectorObstacle().orElse("none"));
  }

  static Path picture(Path folder, Path input) {
    return folder.resolve(input.getFileName() + ".exr");
  }

  static void render(Path input, Path picture) {
    String[] args = {"render", "" + input, "-s", "2", "--size", "24x18", "-o", "" + picture};
    Outcome outcome = Outcome.of(args);
    if (outcome.exitCode() != 0) {
      throw new AssertionError(outcome.err());
    }
  }
}
