/**
 * Checks for what is physically or numerically questionable in a valid scene.
 *
 * <p>{@link io.github.lumbre.audit.SceneAudit} runs each check. What only light can tell (which
 * lamp arrives, what the depth cuts off, what no ray meets) comes from a {@link
 * io.github.lumbre.audit.Pilot}: a few thousand paths, spread over the frame, always the same for
 * the same scene.
 */
package io.github.lumbre.audit;
