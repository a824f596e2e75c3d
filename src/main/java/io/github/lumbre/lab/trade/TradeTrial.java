package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.compare.PictureError;

/**
 * One render of one setting with one seed, up to one number of samples.
 *
 * @param samples samples per pixel
 * @param seconds wall-clock time of all samples so far
 * @param cpu CPU seconds of the process
 * @param error error against the reference
 */
record TradeTrial(
    TradeSetting setting,
    int samples,
    double seconds,
    double cpu,
    PictureError error,
    Image picture) {}
