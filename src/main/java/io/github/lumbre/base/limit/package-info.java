/**
 * Limits for scenes, models and pictures from people who are not trusted, such as uploads.
 *
 * <p>{@link io.github.lumbre.base.limit.Limits#heap} is the memory that reading may use, and {@link
 * io.github.lumbre.base.limit.Limits#excess} words what exceeds a limit. Readers count what they
 * are about to allocate, and compare it with these.
 */
@NullMarked
package io.github.lumbre.base.limit;

import org.jspecify.annotations.NullMarked;
