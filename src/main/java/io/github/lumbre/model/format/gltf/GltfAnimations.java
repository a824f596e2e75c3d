package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.ModelAnimation;
import io.github.lumbre.model.internal.ModelNames;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;

/** The animations of a glTF file (glTF 2.0, section 3.11). */
record GltfAnimations(GltfDocument document, GltfAccessors accessors) {
  List<ModelAnimation> all() throws ModelFormatException {
    List<ModelAnimation> all = new ArrayList<>();
    for (GltfJson json : document.section("animations")) {
      String name = json.text("name", Integer.toString(all.size()));
      all.add(new ModelAnimation(name, seconds(json)));
    }
    return all;
  }

  /**
   * Returns a text for each animation that identifies its keys. The order of channels and nodes
   * does not matter where nodes have names.
   */
  List<String> keys() throws ModelFormatException, IOException {
    List<String> all = new ArrayList<>();
    for (GltfJson animation : document.section("animations")) {
      List<String> channels = new ArrayList<>();
      try {
        List<GltfJson> samplers = animation.objects("samplers");
        for (GltfJson channel : animation.objects("channels")) {
          int sampler = channel.requireIndex("sampler", samplers.size());
          channels.add(target(channel) + hash(samplers.get(sampler)));
        }
      } catch (ModelFormatException e) {
        channels.add(e.getMessage());
      }
      channels.sort(Comparator.naturalOrder());
      all.add(Sha256.of(String.join("\n", channels).getBytes(StandardCharsets.UTF_8)));
    }
    return all;
  }

  private String target(GltfJson channel) throws ModelFormatException {
    GltfJson target = channel.requireObject("target");
    OptionalInt node = target.index("node", document.size("nodes"));
    String number = node.isPresent() ? Integer.toString(node.getAsInt()) : "";
    String name =
        node.isPresent()
            ? document.section("nodes").get(node.getAsInt()).text("name", number)
            : number;
    return name + " " + target.text("path", "") + " ";
  }

  private String hash(GltfJson sampler) throws ModelFormatException, IOException {
    MessageDigest digest = Sha256.digest();
    for (String member : List.of("input", "output")) {
      double[] numbers = accessors.fractions(accessors.require(sampler, member));
      ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * numbers.length);
      for (double number : numbers) {
        // The sum with 0 replaces -0 by 0.
        bytes.putFloat((float) number + 0f);
      }
      digest.update(bytes.array());
    }
    String hash = HexFormat.of().formatHex(digest.digest());
    return sampler.text("interpolation", "LINEAR") + " " + hash;
  }

  private List<String> names() throws ModelFormatException {
    return all().stream().map(ModelAnimation::name).toList();
  }

  /** Returns the largest time that the accessors of times state; empty if one states none. */
  private OptionalDouble seconds(GltfJson animation) {
    double end = 0;
    try {
      for (GltfJson sampler : animation.objects("samplers")) {
        int input = sampler.requireIndex("input", document.size("accessors"));
        double[] max = document.section("accessors").get(input).numbers("max");
        if (max.length != 1 || !Double.isFinite(max[0])) {
          return OptionalDouble.empty();
        }
        end = Math.max(end, max[0]);
      }
    } catch (ModelFormatException e) {
      // What is wrong with an animation matters to its pose alone.
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(end);
  }

  /**
   * Returns the values of animated properties at a time. Warns if the animation ends before.
   *
   * @param wanted the animation, and the time that the warning is about
   * @param seconds the time
   * @throws ModelFormatException if the file has no such animation
   */
  GltfPose pose(ModelOptions.Pose wanted, double seconds, GltfNodes nodes)
      throws ModelFormatException, IOException {
    GltfJson json = document.section("animations").get(find(wanted.animation()));
    List<GltfJson> samplers = json.objects("samplers");
    GltfPose pose = new GltfPose();
    for (GltfJson channel : json.objects("channels")) {
      GltfJson target = channel.requireObject("target");
      OptionalInt node = target.index("node", nodes.size());
      if (node.isPresent()) {
        GltfJson sampler = samplers.get(channel.requireIndex("sampler", samplers.size()));
        set(pose, nodes.get(node.getAsInt()), node.getAsInt(), target, sampler, seconds);
      }
    }
    double end = pose.end();
    if (wanted.seconds() > end) {
      document
          .warnings()
          .add(
              json.location(),
              "expected a time from 0 to %s s, found %s s; the last pose is used"
                  .formatted(shown(end), shown(wanted.seconds())));
    }
    return pose;
  }

  /** Returns a time as the file has it, in single precision. */
  private static String shown(double seconds) {
    return Float.toString((float) seconds).replaceFirst("[.]0$", "");
  }

  private int find(String wanted) throws ModelFormatException {
    List<String> names = names();
    for (int i = 0; i < names.size() && !names.contains(wanted); i++) {
      if (wanted.equals(Integer.toString(i))) {
        return i;
      }
    }
    return ModelNames.index("animations", "an animation", names, wanted);
  }

  private void set(
      GltfPose pose, GltfNode node, int index, GltfJson target, GltfJson sampler, double seconds)
      throws ModelFormatException, IOException {
    String path = target.text("path", "");
    if (node.matrix().isPresent() && !path.equals("weights")) {
      document
          .warnings()
          .add(target.location("node"), "a node with a matrix is not animated; left at rest");
      return;
    }
    switch (path) {
      case "translation" -> pose.translate(index, sampler(pose, sampler, 3).at(seconds));
      case "rotation" -> pose.rotate(index, sampler(pose, sampler, 4).rotationAt(seconds));
      case "scale" -> pose.scale(index, sampler(pose, sampler, 3).at(seconds));
      case "weights" -> {
        int width = node.mesh().isPresent() ? targets(node.mesh().getAsInt()) : 0;
        if (width > 0) {
          pose.weigh(index, sampler(pose, sampler, width).at(seconds));
        }
      }
      default ->
          document
              .warnings()
              .add(
                  "an animation of an unknown property",
                  target.location("path"),
                  "expected translation, rotation, scale or weights, found "
                      + PrintableText.quoted(path)
                      + "; left at rest");
    }
  }

  private GltfSampler sampler(GltfPose pose, GltfJson json, int width)
      throws ModelFormatException, IOException {
    GltfSampler sampler = new GltfSampler(json, accessors, width);
    pose.extendTo(sampler.end());
    return sampler;
  }

  /** Returns the number of morph targets of a mesh. */
  private int targets(int mesh) throws ModelFormatException {
    int most = 0;
    for (GltfJson primitive : document.section("meshes").get(mesh).objects("primitives")) {
      most = Math.max(most, primitive.objects("targets").size());
    }
    return most;
  }
}
