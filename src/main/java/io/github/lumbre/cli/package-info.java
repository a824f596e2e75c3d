/**
 * The command line.
 *
 * <p>{@link io.github.lumbre.cli.Lumbre} is the entry point; each command is a class: {@link
 * io.github.lumbre.cli.RenderCommand}, {@link io.github.lumbre.cli.CheckCommand}, {@link
 * io.github.lumbre.cli.AuditCommand}, {@link io.github.lumbre.cli.PixelCommand}, {@link
 * io.github.lumbre.cli.SelfTestCommand}, {@link io.github.lumbre.cli.BenchmarkCommand}, {@link
 * io.github.lumbre.cli.PerfCommand}. Commands exit with an {@link
 * io.github.lumbre.base.ExitCode}. Failures are exceptions, which only {@link
 * io.github.lumbre.cli.output.Failures} turns into messages. Results go to standard output;
 * warnings, errors, progress and summaries to standard error.
 *
 * <p>Only this package prints, exits the program and depends on the optional library picocli.
 * Programs that embed Lumbre do not need it.
 */
package io.github.lumbre.cli;
