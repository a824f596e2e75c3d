package io.github.lumbre.cli.view;

import io.github.lumbre.scene.RenderSettings;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A consistent copy of what the page shows besides the pixels.
 *
 * @param settings of the render; empty for a picture that is not rendered here
 * @param layers the names of the layers that the render records
 * @param samples added in this render, over all pixels
 * @param rate samples per second
 * @param seconds of rendering
 * @param secondsLeft expected rendering time until the end; empty if unknown
 * @param isMoved whether the camera is not where the scene has it
 */
record Snapshot(
    long version,
    String name,
    Optional<Frame> frame,
    String status,
    Optional<RenderSettings> settings,
    List<String> layers,
    long samples,
    double rate,
    double seconds,
    OptionalDouble secondsLeft,
    List<ErrorPoint> errors,
    List<String> problems,
    boolean isMoved) {}
