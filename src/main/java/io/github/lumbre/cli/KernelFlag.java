package io.github.lumbre.cli;

import io.github.lumbre.geometry.Kernel;
import java.util.Optional;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The flag that chooses how hierarchies are searched; it wins over the system property. */
final class KernelFlag {
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
   * Makes the choice, before the first hierarchy is built.
   *
   * @throws ParameterException if vectors are asked for and not available
   */
  void apply() {
    Kernel chosen = kernel.orElseGet(this::configured);
    Optional<String> obstacle = Kernel.vectorObstacle();
    if (chosen == Kernel.VECTOR && obstacle.isPresent()) {
      throw new ParameterException(
          spec.commandLine(), "--kernel: vector is not available: " + obstacle.get());
    }
    System.setProperty(Kernel.PROPERTY, FlagConverters.lower(chosen));
  }

  private Kernel configured() {
    try {
      return Kernel.configured();
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
  }
}
