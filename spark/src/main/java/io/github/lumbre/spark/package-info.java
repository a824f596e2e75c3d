/**
 * Lumbre on Apache Spark: the command line's {@code render} and {@code resume}, whose passes are
 * rendered by executors.
 *
 * <p>{@link io.github.lumbre.spark.RenderOnSpark} runs the command line with a {@link
 * io.github.lumbre.spark.SparkEngine}. The engine sends a {@link
 * io.github.lumbre.spark.SceneBundle} to each executor once, divides each pass into {@link
 * io.github.lumbre.spark.WorkUnit}s and adds their films as they arrive. A film is a sum of exact
 * numbers, so that the order of arrival, repeated tasks and lost executors change no bit.
 */
package io.github.lumbre.spark;
