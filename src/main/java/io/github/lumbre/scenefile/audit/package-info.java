/**
 * Checks of valid scenes for physically or numerically questionable properties.
 *
 * <p>{@link io.github.lumbre.scenefile.audit.SceneAudit} runs the checks. Some need light
 * transport: each light's share, energy lost to the path length limit, and objects that no ray
 * hits. They use a {@link io.github.lumbre.scenefile.audit.Pilot}, a deterministic pilot render of
 * 64 × 48 points over the frame with 2 samples each.
 */
@NullMarked
package io.github.lumbre.scenefile.audit;

import org.jspecify.annotations.NullMarked;
