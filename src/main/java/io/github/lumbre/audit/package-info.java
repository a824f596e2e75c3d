/**
 * What is physically or numerically questionable in a scene that can be rendered.
 *
 * <p>{@link io.github.lumbre.audit.SceneAudit} asks each check in turn. What only light can tell
 * (which lamp arrives, what the depth cuts off, what no ray meets) comes from a {@link
 * io.github.lumbre.audit.Pilot}: a few thousand paths, spread over the frame, always the same for
 * the same scene.
 */
package io.github.lumbre.audit;

