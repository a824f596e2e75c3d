/**
 * The immutable world that is rendered.
 *
 * <p>{@link io.github.lumbre.scene.SceneBuilder} collects a camera, {@linkplain
 * io.github.lumbre.scene.Primitive primitives} and lights; the {@link io.github.lumbre.scene.Scene}
 * it builds is complete and answers rays. {@link io.github.lumbre.scene.RenderSettings} say how the
 * picture is to be made.
 */
package io.github.lumbre.scene;

