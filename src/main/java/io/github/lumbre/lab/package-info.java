/** Classes shared by all measurements of the lab: scene folders, text files, and task errors. */
package io.github.lumbre.lab;
