package io.github.lumbre.lab.trade;

/**
 * Work that does not depend on the machine, for one sample of one pixel, mean over the frame.
 *
 * @param rays followed to what they meet
 * @param shadowRays followed to see whether they meet anything
 * @param nodes of the hierarchy that searches of plain Java visit for those; of meshes placed
 *     often, not those inside
 * @param lookUps of values of textures
 */
public record TradeWork(double rays, double shadowRays, double nodes, double lookUps) {}
