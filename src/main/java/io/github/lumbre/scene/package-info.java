/**
 * Scenes and render settings, both immutable.
 *
 * <p>{@link io.github.lumbre.scene.SceneBuilder} collects a camera, {@linkplain
 * io.github.lumbre.scene.Primitive primitives} and lights; the {@link io.github.lumbre.scene.Scene}
 * it builds is complete and finds the hits of rays. {@link io.github.lumbre.scene.RenderSettings}
 * holds the settings of a render.
 */
@NullMarked
package io.github.lumbre.scene;

import org.jspecify.annotations.NullMarked;
