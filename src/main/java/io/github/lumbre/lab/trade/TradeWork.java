package io.github.lumbre.lab.trade;

/**
 * The work per sample, independent of the machine, mean over the frame.
 *
 * @param rays rays traced to the nearest hit
 * @param shadowRays rays traced for visibility
 * @param nodes BVH nodes that the scalar kernel visits for these rays, without those inside shared
 *     meshes
 * @param lookUps texture look-ups
 */
public record TradeWork(double rays, double shadowRays, double nodes, double lookUps) {
  double allRays() {
    return rays + shadowRays;
  }
}
