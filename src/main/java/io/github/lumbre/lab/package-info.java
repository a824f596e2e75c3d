/** What all measurements of the lab share: reading scenes, files of text, and errors of a task. */
package io.github.lumbre.lab;
