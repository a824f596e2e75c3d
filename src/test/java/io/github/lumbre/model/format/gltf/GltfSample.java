package io.github.lumbre.model.format.gltf;

/** A small glTF file that uses every feature that is read. */
final class GltfSample {
  private GltfSample() {}

  /** Returns the file, as .glb. */
  static byte[] file() {
    GltfFile file = new GltfFile();
    addMeshes(file);
    addMaterials(file);
    addScene(file);
    addAnimation(file);
    file.set("extensionsUsed", "['KHR_lights_punctual', 'KHR_texture_transform']");
    file.set(
        "extensions",
        """
        {'KHR_materials_variants': {'variants': [{'name': 'red'}]}, 'KHR_lights_punctual':
          {'lights': [{'type': 'spot', 'color': [1, 0, 0], 'intensity': 5, 'range': 9,
            'spot': {'innerConeAngle': 0.1, 'outerConeAngle': 0.2}}]}}
        """);
    return file.glb();
  }

  private static void addMeshes(GltfFile file) {
    int positions = file.floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
    int normals = file.floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1);
    int tangents = file.floats("VEC4", 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1);
    int uvs = file.shorts(5123, "VEC2", ", 'normalized': true", 0, 0, 1, 0, 0, 1, 1, 1);
    int colors =
        file.bytes(5121, "VEC3", ", 'normalized': true", 1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 2, 3);
    int indices = file.shorts(5123, "SCALAR", "", 0, 1, 2, 2, 1, 3);
    int joints = file.bytes(5121, "VEC4", "", 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0);
    int weights = file.floats("VEC4", .5, .5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0);
    int places = file.view(new byte[] {1, 3}, "");
    int values = file.view(new byte[24], "");
    int delta =
        file.add(
            "accessors",
            """
            {'componentType': 5126, 'type': 'VEC3', 'count': 4, 'sparse': {'count': 2,
              'indices': {'bufferView': %d, 'componentType': 5121},
              'values': {'bufferView': %d}}}
            """
                .formatted(places, values));
    String attributes =
        "'POSITION': %d, 'NORMAL': %d, 'TANGENT': %d, 'TEXCOORD_0': %d, 'COLOR_0': %d"
            .formatted(positions, normals, tangents, uvs, colors);
    file.mesh(
        attributes,
        """
        , 'indices': %d, 'mode': 4, 'material': 0, 'targets': [{'POSITION': %d, 'NORMAL': %d}],
        'extensions': {'KHR_materials_variants': {'mappings':
          [{'material': 1, 'variants': [0]}]}}
        """
            .formatted(indices, delta, delta));
    file.mesh(
        attributes + ", 'JOINTS_0': %d, 'WEIGHTS_0': %d".formatted(joints, weights),
        ", 'mode': 5, 'material': 2");
  }

  private static void addMaterials(GltfFile file) {
    file.add(
        "materials",
        """
        {'pbrMetallicRoughness': {'baseColorFactor': [1, 0.5, 0.25, 1], 'metallicFactor': 0,
          'baseColorTexture': {'index': 0, 'texCoord': 0, 'extensions': {'KHR_texture_transform':
            {'offset': [0, 1], 'rotation': 1, 'scale': [0.5, 0.5], 'texCoord': 0}}}},
         'alphaMode': 'BLEND', 'doubleSided': true}
        """);
    file.add(
        "materials",
        """
        {'emissiveFactor': [1, 1, 1], 'normalTexture': {'index': 0, 'scale': 2}, 'extensions':
          {'KHR_materials_emissive_strength': {'emissiveStrength': 2},
           'KHR_materials_ior': {'ior': 1.3}, 'KHR_materials_unlit': {},
           'KHR_materials_specular': {'specularFactor': 0.5},
           'KHR_materials_transmission': {'transmissionFactor': 1},
           'KHR_materials_diffuse_transmission': {'diffuseTransmissionFactor': 0.5,
             'diffuseTransmissionTexture': {'index': 0}, 'diffuseTransmissionColorFactor':
             [1, 0.5, 0], 'diffuseTransmissionColorTexture': {'index': 0}},
           'KHR_materials_volume': {'thicknessFactor': 1, 'attenuationDistance': 3},
           'KHR_materials_dispersion': {'dispersion': 0.5},
           'KHR_materials_iridescence': {'iridescenceFactor': 0.5, 'iridescenceIor': 1.5,
             'iridescenceThicknessMinimum': 200, 'iridescenceThicknessMaximum': 600,
             'iridescenceThicknessTexture': {'index': 0}},
           'KHR_materials_clearcoat': {'clearcoatFactor': 1, 'clearcoatTexture': {'index': 0}},
           'KHR_materials_sheen': {'sheenColorFactor': [1, 0, 0]}}}
        """);
    file.add(
        "materials",
        """
        {'extensions': {'KHR_materials_pbrSpecularGlossiness': {'diffuseFactor': [1, 0.5, 0.25, 1],
          'diffuseTexture': {'index': 0}, 'specularFactor': [0.5, 1, 1], 'glossinessFactor': 0.5,
          'specularGlossinessTexture': {'index': 0}}}}
        """);
    file.add("textures", "{'source': 0, 'sampler': 0}");
    file.add("samplers", "{'wrapS': 33071, 'wrapT': 33648, 'magFilter': 9728}");
    file.add("images", "{'bufferView': " + file.view(new byte[8], "") + "}");
  }

  private static void addScene(GltfFile file) {
    double[] identities = new double[32];
    for (int i = 0; i < 32; i++) {
      identities[i] = i % 16 % 5 == 0 ? 1 : 0;
    }
    int matrices = file.floats("MAT4", identities);
    file.add("nodes", "{'children': [1, 2, 3], 'scale': [1, 2, 3], 'name': 'root'}");
    file.add("nodes", "{'mesh': 0, 'weights': [0.5], 'rotation': [0, 0, 1, 0]}");
    file.add("nodes", "{'mesh': 0, 'translation': [1, 2, 3], 'camera': 0}");
    file.add(
        "nodes", "{'mesh': 1, 'skin': 0, 'extensions': {'KHR_lights_punctual': {'light': 0}}}");
    file.add("nodes", "{'matrix': [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]}");
    file.add("skins", "{'joints': [4, 0], 'inverseBindMatrices': " + matrices + "}");
    file.add(
        "cameras",
        "{'type': 'perspective', 'perspective': {'yfov': 1, 'aspectRatio': 2, 'znear': 0.1}}");
    file.add("scenes", "{'nodes': [0, 4]}");
    file.set("scene", "0");
  }

  private static void addAnimation(GltfFile file) {
    int times = file.floats("SCALAR", 0, 1);
    int rotations = file.floats("VEC4", 0, 0, 0, 1, 0, 0, 1, 0);
    int spline = file.floats("VEC3", 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 2, 2, 2, 0, 0, 0);
    int weights = file.floats("SCALAR", 0, 1);
    file.add(
        "animations",
        """
        {'channels': [{'sampler': 0, 'target': {'node': 1, 'path': 'rotation'}},
            {'sampler': 1, 'target': {'node': 0, 'path': 'scale'}},
            {'sampler': 2, 'target': {'node': 1, 'path': 'weights'}}],
         'samplers': [{'input': %1$d, 'output': %2$d},
            {'input': %1$d, 'output': %3$d, 'interpolation': 'CUBICSPLINE'},
            {'input': %1$d, 'output': %4$d, 'interpolation': 'STEP'}]}
        """
            .formatted(times, rotations, spline, weights));
  }
}
