/** Reads photometric files of lamps (IES LM-63) through {@link IesReader}. */
package io.github.lumbre.model.format.ies;
