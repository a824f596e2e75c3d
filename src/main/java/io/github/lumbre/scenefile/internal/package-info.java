/** What reports, audits and checkpoint files state of a scene file. */
package io.github.lumbre.scenefile.internal;
