/**
 * The local page of {@code lumbre view}, a listener of {@link
 * io.github.lumbre.render.preview.Previews}.
 *
 * <p>A {@link io.github.lumbre.cli.view.ViewServer} answers requests that {@link
 * io.github.lumbre.cli.view.RequestGuard} accepts. A {@link io.github.lumbre.cli.view.ViewSession}
 * holds what is shown, and renders in a thread of its own.
 */
package io.github.lumbre.cli.view;
