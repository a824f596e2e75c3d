package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The exit codes of a command, which its help lists; {@link ExitCode#USAGE} and {@link
 * ExitCode#INTERNAL} are those of every command.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
@interface Exits {
  ExitCode[] value();

  /** What {@link ExitCode#DIFFERENT} means for this command. */
  String different() default "";
}
