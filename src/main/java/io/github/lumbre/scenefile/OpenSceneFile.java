package io.github.lumbre.scenefile;

import io.github.lumbre.scenefile.internal.SceneFileInside;

/** Shows a {@link SceneFile} to this program, with types that the exported type lacks. */
interface OpenSceneFile extends SceneFileInside {}
