/**
 * Texts for people: corrections of misspelled words, numbers, and texts of files that are safe to
 * print.
 */
package io.github.lumbre.base.text;
