package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.metrics.PictureError;

/**
 * One render of one setting with one seed, up to one number of samples.
 *
 * @param samples per pixel
 * @param seconds on the wall, for all samples up to these
 * @param cpu seconds of the process
 * @param error against the reference
 */
record TradeTrial(
    TradeSetting setting,
    int samples,
    double seconds,
    double cpu,
    PictureError error,
    Image picture) {}
