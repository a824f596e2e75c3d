package io.github.lumbre.cli.view;

/**
 * The error of a picture at one moment.
 *
 * @param seconds of rendering
 * @param samples mean number of samples per pixel
 * @param error relative root mean squared error, an estimate
 * @param bound upper bound of the error, which may be infinite
 * @param isDoubtful whether the bound may not hold
 */
record ErrorPoint(
    double seconds, double samples, double error, double bound, boolean isDoubtful) {}
