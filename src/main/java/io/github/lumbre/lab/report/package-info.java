/**
 * The table of the 2016 report: its rows, their times on this machine, and the hashes of pictures.
 */
package io.github.lumbre.lab.report;
