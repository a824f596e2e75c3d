package io.github.lumbre.cli.option;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.parser.SceneParser;
import java.time.Duration;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flag that chooses how hierarchies are searched. */
public final class KernelFlag {
  /**
   * In less time, plain Java takes more samples. Until the virtual machine has compiled it, the
   * vector kernel is about a hundred times slower, for 2 s to 4 s on two processors; then it is 10
   * % to 30 % faster.
   */
  private static final Duration FIRST_FOR_VECTORS = Duration.ofSeconds(20);

  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Option(
      names = "--kernel",
      paramLabel = "NAME",
      converter = FlagConverters.OfKernel.class,
      description =
          "How rays find what they hit: vector, scalar or auto (auto: vector where it is faster,"
              + " not with --time below 20s). Changes no bit of the picture.")
  private Optional<Kernel> kernel;

  /**
   * Returns a parser of scenes that are searched by the chosen kernel.
   *
   * @throws ParameterException as {@link #validate}
   */
  public SceneParser over(SceneParser parser) {
    return parser.searchedBy(chosen());
  }

  /**
   * Returns a parser of scenes for one render, which has no time to compile the vector kernel if it
   * is a short one.
   *
   * @param time of the whole command; empty if no time limits it
   * @throws ParameterException as {@link #validate}
   */
  public SceneParser over(SceneParser parser, Optional<Duration> time) {
    return parser.searchedBy(within(time, chosen()));
  }

  /** Returns the kernel that takes the most samples in a time. */
  public static Kernel within(Optional<Duration> time, Kernel chosen) {
    boolean isShort = time.filter(t -> t.compareTo(FIRST_FOR_VECTORS) < 0).isPresent();
    return chosen == Kernel.AUTO && isShort ? Kernel.SCALAR : chosen;
  }

  /**
   * Checks the choice before any work.
   *
   * @throws ParameterException if vectors are chosen and not available
   */
  public void validate() {
    chosen();
  }

  private Kernel chosen() {
    Kernel chosen = kernel.orElse(Kernel.AUTO);
    Optional<String> obstacle = Kernel.vectorObstacle();
    if (chosen == Kernel.VECTOR && obstacle.isPresent()) {
      throw new ParameterException(
          spec.commandLine(), "--kernel: vector is not available: " + obstacle.get());
    }
    return chosen;
  }
}
