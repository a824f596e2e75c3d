/** How a model is framed, what is drawn on its pictures, and the frames of its animations. */
package io.github.lumbre.stage.internal;
