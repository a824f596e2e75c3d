/** The limit of time, which the module does not export. */
package io.github.lumbre.base.limit.internal;
