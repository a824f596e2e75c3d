/**
 * What the formats of model files have in common. {@link
 * io.github.lumbre.model.internal.ModelReader} chooses the reader and returns a {@link
 * io.github.lumbre.model.internal.Model}, which does not depend on the format.
 */
package io.github.lumbre.model.internal;
