package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.metrics.Interval;
import java.util.Optional;

/**
 * A setting that must not change the picture, beside the one that it was compared with.
 *
 * @param setting as flags say it
 * @param timeRatio its time over the other's, of renders in turn
 * @param cpuRatio the same of processor time; empty if renders are too short for its clock
 * @param isSamePicture whether every bit of the picture is the same
 */
public record ExactRow(
    String setting, Interval timeRatio, Optional<Interval> cpuRatio, boolean isSamePicture) {}
