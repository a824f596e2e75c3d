/**
 * From a point of the film to a ray of the world.
 *
 * <p>A film point (u, v) lies in [0,1)², u to the right and v <b>down</b>. A {@link
 * io.github.lumbre.camera.Camera} looks along its local +z, with +x to the right and +y up; its
 * pose in the world is a position and a rotation. The lens of {@link
 * io.github.lumbre.camera.ThinLensCamera} is a disc, or has the form of a mask, from which {@link
 * io.github.lumbre.camera.BokehCache} draws.
 */
package io.github.lumbre.camera;

