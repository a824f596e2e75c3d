package io.github.lumbre.mutants;

/** A defect that cannot be planted: its file is not as described, or the sources have moved on. */
final class MutantException extends Exception {
  private static final long serialVersionUID = 1;

  MutantException(String message) {
    super(message);
  }
}
