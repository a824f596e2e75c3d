/** Limits for scenes, models and pictures from people who are not trusted, such as uploads. */
package io.github.lumbre.limit;
