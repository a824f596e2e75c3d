package io.github.lumbre.lab.trade;

import io.github.lumbre.scene.Scene;
import java.util.concurrent.atomic.LongAdder;

/**
 * A scene of a study, and a slower copy that counts the work.
 *
 * @param scene scene for timed renders
 * @param counting copy of the scene that updates the two counters
 * @param nodes counter of visited BVH nodes
 * @param lookUps counter of texture look-ups
 */
public record TradeScene(Scene scene, Scene counting, LongAdder nodes, LongAdder lookUps) {}
