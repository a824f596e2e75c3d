/**
 * Reads 3MF files through {@link ThreeMfReader}. {@link io.github.lumbre.model.format.ZipParts} are
 * the parts of the archive, {@link XmlReader} reads the XML of a part element by element, and
 * {@link ModelDocument} the objects of a model.
 */
package io.github.lumbre.model.format.threemf;

import io.github.lumbre.model.format.XmlReader;

