package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.HeapNeed;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelFiles;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLight;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMotions;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Reads glTF 2.0, as .gltf or .glb. Not reusable.
 *
 * <p>A transform with a negative determinant reverses the winding of triangles (glTF 2.0, section
 * 3.7.4). That agrees with {@link ModelGeometry}: triangles are counterclockwise, seen from
 * outside, in local space, and outside stays outside in a mirroring {@link Transform}. So indices
 * change in skinned meshes only, which are in world space.
 */
public final class GltfReader {
  private static final Pattern ASSET = Pattern.compile("\"asset\"\\s*:\\s*\\{");

  private final GltfDocument document;
  private final GltfAccessors accessors;
  private final GltfInfluences influences;
  private final GltfMeshes meshes;
  private final GltfFronts fronts;
  private final GltfMaterials materials;
  private final GltfVariants variants;
  private final GltfAnimations animations;
  private final GltfLights lights;
  private final GltfCameras cameras;
  private final GltfNodes nodes;
  private final GltfInstances instances;
  private final Optional<ModelOptions.Pose> motion;
  private final boolean mayLackFiles;
  private GltfPose pose = new GltfPose();
  private Optional<ModelFormatException> unreadable = Optional.empty();
  private final Map<Integer, GltfSkin> skins = new HashMap<>();
  private final List<ModelPart> parts = new ArrayList<>();
  private final List<ModelCamera> placedCameras = new ArrayList<>();
  private final List<ModelLight> placedLights = new ArrayList<>();

  /** A node with a mesh, and the weights of its morph targets. */
  private record Placement(GltfNode node, ModelNode part, GltfMatrix matrix, double[] weights) {}

  private GltfReader(GltfDocument document, GltfBuffers buffers, ModelOptions options)
      throws ModelFormatException, IOException {
    this.document = document;
    mayLackFiles = options.mayLackFiles();
    accessors = new GltfAccessors(document, buffers);
    GltfAttributes attributes = new GltfAttributes(document, accessors);
    influences = new GltfInfluences(document, accessors, attributes);
    GltfDraco draco = new GltfDraco(document, accessors, buffers);
    fronts = new GltfFronts(document);
    meshes = new GltfMeshes(document, accessors, attributes, draco);
    GltfTextures textures = new GltfTextures(document, buffers, options.mayLackFiles());
    materials = new GltfMaterials(document, textures);
    variants = new GltfVariants(document, options.find(ModelOption.VARIANT));
    animations = new GltfAnimations(document, accessors);
    lights = new GltfLights(document);
    cameras = new GltfCameras(document);
    nodes = new GltfNodes(document, lights.size());
    instances = new GltfInstances(document, accessors);
    motion = options.find(ModelOption.POSE);
  }

  /** Returns whether a file begins like a GLB file, or like a JSON text with an asset. */
  public static boolean startsIn(byte[] start, long size) {
    String found = FileContent.describe(start).orElse("");
    return found.equals("GLB")
        || found.equals("JSON") && ASSET.matcher(FileContent.text(start)).find();
  }

  /** Returns the triangles and points of all meshes that a file states. */
  public static HeapNeed need(byte[] start, long size) {
    return GltfCensus.need(start, size);
  }

  /**
   * Returns the content of a file.
   *
   * @throws ModelFormatException if the file is damaged, unsupported or too large
   * @throws IOException if the folder fails
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static Model read(byte[] content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    return read(content, folder, options, new GltfBudget(options.limits()));
  }

  public static Model read(
      byte[] content, ModelFolder folder, ModelOptions options, GltfBudget budget)
      throws ModelFormatException, IOException {
    return reader(content, folder, options, budget).read();
  }

  /** Returns what a file states of its motion; {@code read} explains the arguments. */
  public static ModelMotions motions(byte[] content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    GltfReader reader = reader(content, folder, options, new GltfBudget(options.limits()));
    List<String> deformations = new ArrayList<>();
    if (reader.document.size("skins") > 0) {
      deformations.add("skins");
    }
    for (GltfJson mesh : reader.document.section("meshes")) {
      for (GltfJson primitive : mesh.objects("primitives")) {
        if (primitive.has("targets") && !deformations.contains("morph targets")) {
          deformations.add("morph targets");
        }
      }
    }
    return new ModelMotions(reader.animations.keys(), deformations);
  }

  private static GltfReader reader(
      byte[] content, ModelFolder folder, ModelOptions options, GltfBudget budget)
      throws ModelFormatException, IOException {
    GltfContainer container = GltfContainer.of(content);
    // The text of the JSON is also kept as strings.
    budget.allocate("", (long) content.length + container.json().remaining());
    GltfJson root = GltfJson.read(container.json(), budget);
    GltfDocument document = new GltfDocument(root, budget);
    container.warnings().forEach(warning -> document.warnings().add("", warning));
    GltfExtensions.check(document);
    ModelFiles files = new ModelFiles(folder, options.limits(), document.warnings());
    GltfBuffers buffers = new GltfBuffers(document, container.binary(), files);
    return new GltfReader(document, buffers, options);
  }

  /** Returns the model in its pose, or in motion. */
  private Model read() throws ModelFormatException, IOException {
    if (motion.isEmpty()) {
      return posed();
    }
    List<Model> poses = new ArrayList<>();
    for (double seconds : motion.get().times()) {
      pose = animations.pose(motion.get(), seconds, nodes);
      poses.add(posed());
      document.budget().addPose(poses, motion.get().poses());
      parts.clear();
      placedCameras.clear();
      placedLights.clear();
      skins.clear();
    }
    return Model.inMotion(poses);
  }

  /** Returns the model in its present pose. */
  private Model posed() throws ModelFormatException, IOException {
    nodes.place(pose);
    for (int index : nodes.shown()) {
      GltfNode node = nodes.get(index);
      Interrupts.check();
      if (node.mesh().isPresent() || node.camera().isPresent() || node.light().isPresent()) {
        add(index, node, nodes.toWorld(index));
      }
    }
    if (parts.isEmpty() && unreadable.isPresent()) {
      throw unreadable.get();
    }
    if (parts.isEmpty()) {
      warnOfUnusedMeshes();
    }
    return new Model(
        Transform.IDENTITY,
        "meter",
        TriangleMesh.Front.WINDING,
        parts,
        1,
        placedCameras,
        placedLights,
        variants.names(),
        animations.all(),
        document.warnings().all(),
        List.of());
  }

  /** Adds a warning if the scene names none of the file's meshes. */
  private void warnOfUnusedMeshes() throws ModelFormatException {
    for (int index : nodes.shown()) {
      if (nodes.get(index).mesh().isPresent()) {
        return;
      }
    }
    if (document.size("meshes") > 0) {
      document
          .warnings()
          .add("", "no visible node of the scene has a mesh; all meshes are left out");
    }
  }

  private void add(int index, GltfNode node, GltfMatrix matrix)
      throws ModelFormatException, IOException {
    if (node.mesh().isPresent()) {
      addMeshes(index, node, matrix);
    }
    if (node.camera().isEmpty() && node.light().isEmpty()) {
      return;
    }
    GltfMatrix place = nodes.unscaled(index, pose);
    if (!place.isFinite()) {
      warnOfLoss(node);
      return;
    }
    if (node.camera().isPresent()) {
      cameras.camera(node, place).ifPresent(placedCameras::add);
    }
    if (node.light().isPresent()) {
      lights.light(node, place.toTransform()).ifPresent(placedLights::add);
    }
  }

  /** Returns whether a node's mesh can be shown; warns if not. */
  private boolean isPlaced(GltfNode node, GltfMatrix matrix) {
    boolean isPlaced = matrix.dimensions() == 2 || matrix.toTransform().isInvertible();
    if (!isPlaced) {
      warnOfLoss(node);
    }
    return isPlaced;
  }

  private void warnOfLoss(GltfNode node) {
    document
        .warnings()
        .add(node.location(), "its transform is not invertible; its content is left out");
  }

  /** Adds all copies of a node's mesh; skins place it in world space, once. */
  private void addMeshes(int index, GltfNode node, GltfMatrix matrix)
      throws ModelFormatException, IOException {
    GltfJson mesh = document.section("meshes").get(node.mesh().getAsInt());
    ModelNode part = nodes.part(index, mesh.text("name", ""));
    double[] weights = weights(index, node, mesh);
    List<GltfMatrix> copies =
        node.skin().isPresent() ? List.of(GltfMatrix.IDENTITY) : instances.ofNode(index);
    for (GltfMatrix copy : copies) {
      Interrupts.check();
      addMesh(new Placement(node, part, matrix.times(copy), weights), mesh);
    }
  }

  private void addMesh(Placement placement, GltfJson mesh)
      throws ModelFormatException, IOException {
    List<GltfJson> primitives = mesh.objects("primitives");
    for (int i = 0; i < primitives.size(); i++) {
      String location = placement.node.location() + ".mesh.primitives[" + i + "]";
      try {
        addPrimitive(placement, primitives.get(i), location);
      } catch (ModelFormatException e) {
        if (!mayLackFiles || e.kind() != Kind.ASSET) {
          throw e;
        }
        unreadable = unreadable.or(() -> Optional.of(e));
        document
            .warnings()
            .add("a mesh is left out", location, e.getMessage() + "; the mesh is left out");
      }
    }
  }

  private void addPrimitive(Placement placement, GltfJson primitive, String location)
      throws ModelFormatException, IOException {
    document.budget().addPart(location);
    GltfNode node = placement.node;
    Transform toWorld = placement.matrix.toTransform();
    boolean isSkinned =
        node.skin().isPresent() && primitive.requireObject("attributes").has("JOINTS_0");
    if (!isSkinned && !isPlaced(node, placement.matrix)) {
      return;
    }
    Optional<ModelGeometry> found = meshes.geometry(primitive, placement.weights);
    if (found.isEmpty()) {
      return;
    }
    ModelMaterial material = materials.get(variants.material(primitive), found.get().isPoints());
    ModelGeometry geometry =
        material.doubleSided()
            ? found.get()
            : fronts.kept(primitive, meshes.geometry(primitive).orElseThrow(), found.get());
    document.budget().addItems(location, geometry);
    if (isSkinned) {
      GltfSkin skin = skin(node.skin().getAsInt());
      geometry = skin.applied(primitive, geometry, toWorld.isMirroring());
      toWorld = Transform.IDENTITY;
    } else if (placement.matrix.dimensions() == 2
        || geometry.isPoints() && GltfPoints.isUneven(toWorld)) {
      geometry = meshes.flattened(primitive, geometry, toWorld);
      toWorld = Transform.IDENTITY;
      if (!geometry.isVisible()) {
        document.warnings().add(location, "is flattened to a line and left out");
        return;
      }
    }
    geometry = meshes.shown(primitive, geometry);
    parts.add(new ModelPart(placement.part, location, geometry, material, toWorld));
  }

  private GltfSkin skin(int index) throws ModelFormatException, IOException {
    GltfSkin skin = skins.get(index);
    if (skin == null) {
      GltfJson json = document.section("skins").get(index);
      skin = new GltfSkin(json, document, accessors, influences, nodes);
      skins.put(index, skin);
    }
    return skin;
  }

  private double[] weights(int index, GltfNode node, GltfJson mesh) throws ModelFormatException {
    Optional<double[]> animated = pose.weights(index);
    if (animated.isPresent()) {
      return animated.get();
    }
    return node.weights().length > 0 ? node.weights() : mesh.numbers("weights");
  }
}
