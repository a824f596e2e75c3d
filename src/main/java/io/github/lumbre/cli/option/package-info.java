/** Flags that several commands share, and the conversion of their values. */
package io.github.lumbre.cli.option;
