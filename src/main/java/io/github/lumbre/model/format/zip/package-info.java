/**
 * ZIP archives: {@link ZipReader} reads the one model of an archive with the files that it names.
 * {@link ZipParts} are the parts of any archive, within limits.
 */
package io.github.lumbre.model.format.zip;

import io.github.lumbre.model.format.ZipParts;

