package io.github.lumbre.cli;

import io.github.lumbre.model.format.gltf.GltfFile;
import java.util.List;

/** Two glTF files that have nearly all numbers that a glTF file can have. */
final class ExtremeModels {
  private ExtremeModels() {}

  static List<GltfFile> all() {
    return List.of(surfaces(), lights());
  }

  /** Returns materials, skins, morph targets, copies and an animation. */
  private static GltfFile surfaces() {
    GltfFile file = new GltfFile();
    addMeshes(file);
    addMaterials(file);
    addNodes(file);
    int times = file.floats("SCALAR", 0, 1);
    int turns = file.floats("VEC4", 0, 0, 0, 1, 0, 0, 1, 0);
    int spline = file.floats("VEC3", 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 2, 2, 2, 0, 0, 0);
    int weights = file.floats("SCALAR", 0, 1);
    file.add(
        "animations",
        """
        {'name': 'a', 'channels': [{'sampler': 0, 'target': {'node': 1, 'path': 'rotation'}},
            {'sampler': 1, 'target': {'node': 0, 'path': 'scale'}},
            {'sampler': 2, 'target': {'node': 1, 'path': 'weights'}}],
         'samplers': [{'input': %1$d, 'output': %2$d},
            {'input': %1$d, 'output': %3$d, 'interpolation': 'CUBICSPLINE'},
            {'input': %1$d, 'output': %4$d}]}
        """
            .formatted(times, turns, spline, weights));
    return file;
  }

  private static void addMeshes(GltfFile file) {
    int positions = file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
    int normals = file.floats("VEC3", 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 1);
    int tangents = file.floats("VEC4", 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1);
    int uvs = file.floats("VEC2", 0, 0, 1, 0, 0, 1, 1, 1);
    int colors = file.floats("VEC3", 1, .5, .5, 1, 1, 1, 1, .5, 1, .5, 1, 1);
    int indices = file.ints("SCALAR", 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3);
    int joints = file.bytes(5121, "VEC4", "", 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0);
    int weights = file.floats("VEC4", .5, .5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0);
    int target = file.floats("VEC3", 0, 0, 0, .1, 0, 0, 0, .1, 0, 0, 0, .1);
    file.mesh(
        "'POSITION': %d, 'NORMAL': %d, 'TANGENT': %d, 'TEXCOORD_0': %d, 'COLOR_0': %d"
            .formatted(positions, normals, tangents, uvs, colors),
        ", 'indices': %d, 'material': 0, 'targets': [{'POSITION': %d}]"
            .formatted(indices, target));
    file.mesh(
        "'POSITION': %d, 'JOINTS_0': %d, 'WEIGHTS_0': %d".formatted(positions, joints, weights),
        ", 'indices': %d, 'material': 1".formatted(indices));
  }

  private static void addMaterials(GltfFile file) {
    file.add(
        "materials",
        """
        {'pbrMetallicRoughness': {'baseColorFactor': [1, 0.5, 0.25, 1], 'metallicFactor': 0.5,
          'roughnessFactor': 0.5, 'baseColorTexture': {'index': 0, 'extensions':
            {'KHR_texture_transform': {'offset': [0, 1], 'rotation': 1, 'scale': [0.5, 0.5]}}}},
         'alphaMode': 'MASK', 'alphaCutoff': 0.5, 'doubleSided': true,
         'emissiveFactor': [0, 0.5, 1], 'normalTexture': {'index': 0, 'scale': 2},
         'occlusionTexture': {'index': 0, 'strength': 0.5}, 'extensions':
          {'KHR_materials_emissive_strength': {'emissiveStrength': 2},
           'KHR_materials_anisotropy': {'anisotropyStrength': 0.5, 'anisotropyRotation': 1},
           'KHR_materials_iridescence': {'iridescenceFactor': 0.5, 'iridescenceIor': 1.5,
             'iridescenceThicknessMinimum': 200, 'iridescenceThicknessMaximum': 600},
           'KHR_materials_clearcoat': {'clearcoatFactor': 0.5, 'clearcoatRoughnessFactor': 0.5},
           'KHR_materials_sheen': {'sheenColorFactor': [1, 0, 0.5],
             'sheenRoughnessFactor': 0.5}}}
        """);
    file.add(
        "materials",
        """
        {'pbrMetallicRoughness': {'metallicFactor': 0, 'roughnessFactor': 0.25}, 'extensions':
          {'KHR_materials_ior': {'ior': 1.3}, 'KHR_materials_specular': {'specularFactor': 0.5,
             'specularColorFactor': [1, 1, 0.5]},
           'KHR_materials_transmission': {'transmissionFactor': 0.9},
           'KHR_materials_diffuse_transmission': {'diffuseTransmissionFactor': 0.25,
             'diffuseTransmissionColorFactor': [1, 0.5, 0]},
           'KHR_materials_volume': {'thicknessFactor': 1, 'attenuationDistance': 3,
             'attenuationColor': [0.5, 1, 1]},
           'KHR_materials_dispersion': {'dispersion': 0.5}}}
        """);
    file.add("textures", "{'source': 0, 'sampler': 0}");
    file.add("samplers", "{'wrapS': 33071, 'wrapT': 33648, 'magFilter': 9728}");
    file.add("images", "{'uri': 'a.png'}");
  }

  private static void addNodes(GltfFile file) {
    double[] identities = new double[32];
    for (int i = 0; i < 32; i++) {
      identities[i] = i % 16 % 5 == 0 ? 1 : 0;
    }
    int matrices = file.floats("MAT4", identities);
    file.add("nodes", "{'children': [1, 2, 3], 'scale': [1, 2, 3], 'name': 'root'}");
    file.add("nodes", "{'mesh': 0, 'weights': [0.5], 'rotation': [0, 0, 1, 0]}");
    file.add("nodes", "{'mesh': 0, 'translation': [1, 2, 3]}");
    file.add("nodes", "{'mesh': 1, 'skin': 0}");
    file.add("nodes", "{'matrix': [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]}");
    file.add("skins", "{'joints': [4, 0], 'inverseBindMatrices': " + matrices + "}");
    file.add("scenes", "{'nodes': [0, 4, 5]}");
    int moves = file.floats("VEC3", 0, 0, 0, 1, 0, 0);
    int turns = file.floats("VEC4", 0, 0, 0, 1, 0, 0, 1, 0);
    int sizes = file.floats("VEC3", 1, 1, 1, 2, 2, 2);
    file.add(
        "nodes",
        """
        {'mesh': 0, 'extensions': {'EXT_mesh_gpu_instancing': {'attributes':
          {'TRANSLATION': %d, 'ROTATION': %d, 'SCALE': %d}}}}
        """
            .formatted(moves, turns, sizes));
  }

  /** Returns cameras, lights and a specular-glossiness material. */
  private static GltfFile lights() {
    GltfFile file = new GltfFile();
    int positions = file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
    file.mesh(
        "'POSITION': " + positions,
        ", 'material': 0, 'indices': " + file.ints("SCALAR", 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3));
    file.add(
        "materials",
        """
        {'extensions': {'KHR_materials_pbrSpecularGlossiness': {'diffuseFactor': [1, 0.5, 0.25, 1],
          'specularFactor': [0.5, 1, 1], 'glossinessFactor': 0.5}}}
        """);
    file.add("nodes", "{'mesh': 0}");
    file.add("nodes", "{'camera': 0, 'translation': [0, 0.5, 5]}");
    file.add("nodes", "{'camera': 1, 'translation': [0, 0.5, 5]}");
    for (int light = 0; light < 3; light++) {
      file.add(
          "nodes",
          "{'extensions': {'KHR_lights_punctual': {'light': %d}}, 'translation': [0, 2, 1]}"
              .formatted(light));
    }
    file.add(
        "cameras",
        """
        {'type': 'perspective', 'perspective':
          {'yfov': 1, 'aspectRatio': 2, 'znear': 0.1, 'zfar': 100}}
        """);
    file.add(
        "cameras",
        """
        {'type': 'orthographic', 'orthographic': {'xmag': 1, 'ymag': 1, 'znear': 0.1, 'zfar': 9}}
        """);
    file.add("scenes", "{'nodes': [0, 1, 2, 3, 4, 5]}");
    file.set(
        "extensions",
        """
        {'KHR_lights_punctual': {'lights': [{'type': 'spot', 'color': [1, 0, 0], 'intensity': 5,
            'range': 9, 'spot': {'innerConeAngle': 0.1, 'outerConeAngle': 0.2}},
          {'type': 'point', 'intensity': 3, 'range': 4, 'color': [1, 1, 1]},
          {'type': 'directional', 'intensity': 2}]}}
        """);
    int times = file.floats("SCALAR", 0, 1);
    int moves = file.floats("VEC3", 0, 0, 0, 1, 1, 1);
    file.add(
        "animations",
        """
        {'name': 'a', 'channels': [{'sampler': 0, 'target': {'node': 0, 'path': 'translation'}}],
         'samplers': [{'input': %d, 'output': %d}]}
        """
            .formatted(times, moves));
    return file;
  }
}
