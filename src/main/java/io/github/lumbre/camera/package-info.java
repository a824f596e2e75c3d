/**
 * Cameras, which turn film points into world-space rays.
 *
 * <p>A film point (u, v) lies in [0,1)², u to the right and v <b>down</b>. A {@link
 * io.github.lumbre.camera.Camera} looks along its local +z, with +x to the right and +y up; its
 * pose in world space is a position and a rotation. The aperture of a {@link
 * io.github.lumbre.camera.ThinLensCamera} is a disk, a mask or a shape of your own: {@link
 * io.github.lumbre.camera.Aperture}.
 */
@NullMarked
package io.github.lumbre.camera;

import org.jspecify.annotations.NullMarked;
