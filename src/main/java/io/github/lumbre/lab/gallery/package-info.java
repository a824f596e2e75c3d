/** Renders every scene of a folder in about the same time, and the page that shows the pictures. */
package io.github.lumbre.lab.gallery;
