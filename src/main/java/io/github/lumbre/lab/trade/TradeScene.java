package io.github.lumbre.lab.trade;

import io.github.lumbre.scene.Scene;
import java.util.concurrent.atomic.LongAdder;

/**
 * A scene that a study renders, and its double that is slower and counts the work.
 *
 * @param scene whose times are taken
 * @param counting the same scene, which tells the two counters
 * @param nodes that searches for hits have visited
 * @param lookUps of values of textures
 */
public record TradeScene(Scene scene, Scene counting, LongAdder nodes, LongAdder lookUps) {}
