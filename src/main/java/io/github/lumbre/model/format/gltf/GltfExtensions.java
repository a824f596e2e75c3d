package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** Checks the version and the extensions of a glTF file against those that are supported. */
final class GltfExtensions {
  /** Supported extensions, besides those with parameters of materials. */
  private static final Set<String> SUPPORTED =
      Set.of(
          "EXT_meshopt_compression",
          GltfInstances.EXTENSION,
          GltfDraco.EXTENSION,
          GltfNodes.VISIBILITY,
          "KHR_lights_punctual",
          "KHR_materials_emissive_strength",
          GltfMaterials.GLOSSY,
          GltfMaterials.UNLIT,
          "KHR_materials_variants",
          "KHR_mesh_quantization",
          "KHR_meshopt_compression",
          "KHR_texture_transform");

  /**
   * Extensions without an effect on a picture: metadata, features, collisions, physics, sound, and
   * how polygons were divided. They are ignored, also if a file requires them.
   */
  private static final Set<String> INVISIBLE =
      Set.of(
          "AGI_articulations",
          "AGI_stk_metadata",
          "EXT_feature_metadata",
          "EXT_instance_features",
          "EXT_manifold",
          "EXT_mesh_features",
          "EXT_mesh_manifold",
          "EXT_structural_metadata",
          "FB_geometry_metadata",
          "FB_ngon_encoding",
          "GODOT_single_root",
          "GRIFFEL_bim_data",
          "KHR_audio",
          "KHR_audio_emitter",
          "KHR_audio_graph",
          "KHR_collision_shapes",
          "KHR_implicit_shapes",
          "KHR_interactivity",
          "KHR_node_hoverability",
          "KHR_node_selectability",
          "KHR_physics_rigid_bodies",
          "KHR_xmp",
          "KHR_xmp_json_ld",
          "MSFT_audio_emitter",
          "MSFT_lod",
          "MSFT_physics",
          "MSFT_screencoverage",
          "OMI_audio_emitter",
          "OMI_collider",
          "OMI_link",
          "OMI_personality",
          "OMI_physics_body",
          "OMI_physics_shape",
          "OMI_seat",
          "OMI_spawn_point",
          "VRMC_springBone",
          "VRMC_springBone_extended_collider",
          "VRMC_springBone_limit",
          "VRMC_vrm");

  private static final Map<String, String> ADVICE =
      Map.of("EXT_texture_avif", "convert its textures to PNG or JPEG");

  private static final String NO_SCATTERING = "volumes absorb light and do not scatter it";

  /** What a picture lacks without some extensions. */
  private static final Map<String, String> LACKING =
      Map.of(
          "KHR_materials_scatter", NO_SCATTERING,
          "KHR_materials_subsurface", NO_SCATTERING,
          "KHR_materials_volume_scatter", NO_SCATTERING);

  private GltfExtensions() {}

  /**
   * Checks the version and the extensions of a file; warns of extensions that are ignored.
   *
   * @throws ModelFormatException if the file requires what is not supported
   */
  static void check(GltfDocument document) throws ModelFormatException {
    GltfJson root = document.root();
    checkVersion(root.requireObject("asset"));
    List<String> required = root.texts("extensionsRequired");
    for (String name : required) {
      if (!isSupported(name)) {
        throw Kind.UNSUPPORTED.at(
            "extensionsRequired",
            PrintableText.shortened(name)
                + " is required; "
                + ADVICE.getOrDefault(name, "export the model without it"));
      }
    }
    for (String name : new TreeSet<>(root.texts("extensionsUsed"))) {
      if (!isSupported(name)) {
        document
            .warnings()
            .add(
                "extensionsUsed",
                PrintableText.shortened(name)
                    + " is not supported; "
                    + LACKING.getOrDefault(name, "the model may look different"));
      }
    }
  }

  private static boolean isSupported(String name) {
    return SUPPORTED.contains(name)
        || GltfTextures.PICTURES.contains(name)
        || INVISIBLE.contains(name)
        || MaterialParameter.gltfExtensions().contains(name);
  }

  private static void checkVersion(GltfJson asset) throws ModelFormatException {
    String version = asset.text("version", "");
    if (!version.matches("[0-9]{1,9}\\.[0-9]{1,9}")) {
      throw asset.expected("version", "a version such as 2.0");
    }
    String min = asset.text("minVersion", "2.0");
    String member = min.equals("2.0") ? "version" : "minVersion";
    if (!version.startsWith("2.") || !min.equals("2.0")) {
      throw Kind.UNSUPPORTED.at(
          asset.location(member),
          "expected 2.0, found " + PrintableText.quoted(asset.text(member, "")));
    }
  }
}
