package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.metrics.Interval;
import java.util.Optional;

/**
 * The comparison of a setting that must not change the picture with another value of it.
 *
 * @param setting name of the setting and its two values
 * @param timeRatio ratio of wall-clock times, from alternating renders; empty if a render is too
 *     short
 * @param cpuRatio ratio of CPU times; empty if a render is too short
 * @param isSamePicture whether the pictures are bit-identical
 */
public record ExactRow(
    String setting,
    Optional<Interval> timeRatio,
    Optional<Interval> cpuRatio,
    boolean isSamePicture) {}
