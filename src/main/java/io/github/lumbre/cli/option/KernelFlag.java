package io.github.lumbre.cli.option;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.parser.SceneParser;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flag that chooses how hierarchies are searched; it wins over the system property. */
public final class KernelFlag {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  @Option(
      names = "--kernel",
      paramLabel = "NAME",
      converter = FlagConverters.OfKernel.class,
      description =
          "How rays find what they hit: vector, scalar or auto (auto). Changes no bit of the"
              + " picture.")
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
   * Checks the choice before any work.
   *
   * @throws ParameterException if vectors are chosen and not available
   */
  public void validate() {
    chosen();
  }

  private Kernel chosen() {
    Kernel chosen = kernel.orElseGet(this::configured);
    Optional<String> obstacle = Kernel.vectorObstacle();
    if (chosen == Kernel.VECTOR && obstacle.isPresent()) {
      throw new ParameterException(
          spec.commandLine(), "--kernel: vector is not available: " + obstacle.get());
    }
    return chosen;
  }

  private Kernel configured() {
    try {
      return Kernel.configured();
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
  }
}
