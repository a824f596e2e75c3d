/**
 * The command line.
 *
 * <p>{@link io.github.lumbre.cli.Lumbre} is the entrance, with a class for each command: {@link
 * io.github.lumbre.cli.RenderCommand}, {@link io.github.lumbre.cli.CheckCommand}, {@link
 * io.github.lumbre.cli.AuditCommand}, {@link io.github.lumbre.cli.PixelCommand}, {@link
 * io.github.lumbre.cli.SelfTestCommand}, {@link io.github.lumbre.cli.BenchmarkCommand}, {@link
 * io.github.lumbre.cli.PerfCommand}, {@link io.github.lumbre.cli.GalleryCommand}. Commands end in
 * one of {@link io.github.lumbre.cli.output.ExitCodes}; what goes wrong leaves them as an exception
 * and is put into words in {@link io.github.lumbre.cli.output.Failures}, and nowhere else. Results
 * go to standard output; warnings, errors, progress and summaries to standard error.
 *
 * <p>This package alone prints, ends the program and knows the optional library picocli; programs
 * that embed Lumbre do not need it.
 */
package io.github.lumbre.cli;
