/**
 * Reads 3MF files through {@link ThreeMfReader}: {@link ZipParts} are the parts of the archive,
 * {@link XmlReader} reads their XML element by element, {@link ModelDocument} the objects of a part.
 */
package io.github.lumbre.model.threemf;
