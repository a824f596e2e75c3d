/** Renders each scene of a folder in about the same time, and writes a page of the pictures. */
package io.github.lumbre.lab.gallery;
