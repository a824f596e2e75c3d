/**
 * Where the bodies of an assembly go in an exploded view, by their boxes alone. The module does not
 * export it. An {@link io.github.lumbre.model.explosion.Assembly} is the entry: a tree of bodies,
 * each level of which a {@link io.github.lumbre.model.explosion.Spread} moves apart along {@link
 * io.github.lumbre.model.explosion.Direction}s.
 */
package io.github.lumbre.model.explosion;
