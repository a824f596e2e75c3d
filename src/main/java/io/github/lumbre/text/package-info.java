/** Texts for people: corrections of misspelled words, and names of mistakes in JSON. */
package io.github.lumbre.text;
