package io.github.lumbre.cli.option;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.scenefile.SceneParser;
import java.time.Duration;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flag that selects the traversal kernel of the BVH. */
@Command(optionListHeading = Headings.EXECUTION)
public final class KernelFlag extends Flags {
  /**
   * The shortest time limit with which a render changes to the vector kernel. In less time, the
   * scalar kernel takes more samples.
   */
  private static final Duration FIRST_FOR_VECTORS = Duration.ofSeconds(20);

  @Option(
      names = "--kernel",
      paramLabel = "NAME",
      description =
          "Ray traversal kernel: vector, scalar or auto (auto: scalar first; a long render changes"
              + " to vector where this is faster). The picture is bit-identical.")
  private Optional<Kernel> kernel;

  /**
   * Returns a parser whose scenes use the selected kernel.
   *
   * @throws ParameterException as {@link #validate}
   */
  public SceneParser over(SceneParser parser) {
    return parser.searchedBy(chosen());
  }

  /**
   * Returns a parser of scenes for one render. A short render has no time to compile the vector
   * kernel and keeps the scalar one.
   *
   * @param time limit of the whole command; empty if there is none
   * @throws ParameterException as {@link #validate}
   */
  public SceneParser over(SceneParser parser, Optional<Duration> time) {
    return parser.searchedBy(within(time, chosen()));
  }

  /** Returns the kernel that takes the most samples within a time limit. */
  public static Kernel within(Optional<Duration> time, Kernel chosen) {
    boolean isShort = time.filter(t -> t.compareTo(FIRST_FOR_VECTORS) < 0).isPresent();
    return chosen == Kernel.AUTO && isShort ? Kernel.SCALAR : chosen;
  }

  /**
   * Checks the flag before any work.
   *
   * @throws ParameterException if the vector kernel is selected but not available
   */
  public void validate() {
    chosen();
  }

  private Kernel chosen() {
    Kernel chosen = kernel.orElse(Kernel.AUTO);
    if (chosen == Kernel.VECTOR) {
      Optional<String> obstacle = Kernel.vectorObstacle();
      require(obstacle.isEmpty(), "--kernel: vector is not available: " + obstacle.orElse(""));
    }
    return chosen;
  }
}
