/**
 * Pictures of a render while it runs. A {@link io.github.lumbre.preview.PreviewRenderer} wraps the
 * renderer of passes and hands developed pictures to a {@link
 * io.github.lumbre.preview.PreviewListener}, for example a window. Previews
 * take at most about one hundredth of the rendering time, and none if nobody is watching.
 */
package io.github.lumbre.preview;
