/**
 * Parts of materials that the module does not export: microfacets, the Fresnel equations, rough
 * glass, and the channels of {@link io.github.lumbre.material.MetallicRoughness}.
 */
package io.github.lumbre.material.internal;
