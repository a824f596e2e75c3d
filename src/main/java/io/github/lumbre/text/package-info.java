/** Texts for people: corrections of misspelled words. */
package io.github.lumbre.text;
