/**
 * Where the bodies of an assembly go in an exploded view, by their boxes alone. The module does not
 * export it. The entry is {@link io.github.lumbre.model.explosion.Assembly}, a tree of bodies. A
 * {@link io.github.lumbre.model.explosion.Spread} moves the bodies of one level apart, along {@link
 * io.github.lumbre.model.explosion.Direction}s.
 */
package io.github.lumbre.model.explosion;
