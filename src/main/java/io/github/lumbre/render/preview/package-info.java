/**
 * Pictures of a render while it runs. {@link io.github.lumbre.render.preview.Previews} listens to
 * the passes of a render and hands developed pictures to a {@link
 * io.github.lumbre.render.preview.PreviewListener}, for example a window. Previews take at most
 * about one hundredth of the rendering time, and none if nobody is watching.
 */
@NullMarked
package io.github.lumbre.render.preview;

import org.jspecify.annotations.NullMarked;
