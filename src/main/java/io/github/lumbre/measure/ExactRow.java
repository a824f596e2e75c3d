package io.github.lumbre.measure;

/**
 * A setting that must not change the picture, beside the one that it was compared with.
 *
 * @param setting as flags say it
 * @param timeRatio its time over the other's, of renders in turn
 * @param cpuRatio the same of processor time
 * @param isSamePicture whether every bit of the picture is the same
 */
public record ExactRow(
    String setting, Interval timeRatio, Interval cpuRatio, boolean isSamePicture) {}
