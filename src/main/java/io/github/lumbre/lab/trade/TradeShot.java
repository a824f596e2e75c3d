package io.github.lumbre.lab.trade;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.lab.Cost;

/**
 * The picture of one setting with one seed at one number of samples.
 *
 * @param samples samples per pixel
 * @param seed number of the seed, from 1
 * @param cost cost of all samples so far and of developing and denoising this picture
 * @param error error against the reference
 */
public record TradeShot(
    TradeSetting setting, int samples, int seed, Cost cost, PictureError error, Image picture) {}
