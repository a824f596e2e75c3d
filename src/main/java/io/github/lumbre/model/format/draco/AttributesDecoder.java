package io.github.lumbre.model.format.draco;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Decodes the attributes of a mesh: groups of attributes that have their values in one order.
 * Mutable.
 */
final class AttributesDecoder {
  private static final int VERTEX = 0;

  /** The fewest bytes that describe an attribute. */
  private static final int MIN_BYTES = 6;

  private final DracoInput input;
  private final Connectivity mesh;
  private final List<DracoAttribute> decoded = new ArrayList<>();

  /** The positions; empty before they are decoded, or if they are not integers. */
  private Optional<Positions> positions = Optional.empty();

  /**
   * Attributes with their values in one order.
   *
   * @param table the connectivity that is traversed
   * @param traversal its code in the stream
   */
  private record Group(
      Optional<CornerTable> table, int traversal, List<AttributeDecoder> attributes) {}

  AttributesDecoder(DracoInput input, Connectivity mesh) {
    this.input = input;
    this.mesh = mesh;
  }

  List<DracoAttribute> decode() throws ModelFormatException {
    List<Group> groups = new ArrayList<>();
    int count = input.unsignedByte();
    for (int i = 0; i < count; i++) {
      groups.add(group());
    }
    for (Group group : groups) {
      describe(group);
    }
    for (Group group : groups) {
      decode(group);
    }
    return List.copyOf(decoded);
  }

  private Group group() throws ModelFormatException {
    if (mesh.table().isEmpty()) {
      return new Group(Optional.empty(), 0, new ArrayList<>());
    }
    int connectivity = input.signedByte();
    int kind = input.unsignedByte();
    int traversal = input.unsignedByte();
    if (connectivity >= mesh.seams().size() || kind != VERTEX && connectivity < 0) {
      throw input.malformed(
          "expected one of " + mesh.seams().size() + " connectivities, found " + connectivity);
    }
    CornerTable table = kind == VERTEX ? mesh.table().get() : mesh.seams().get(connectivity);
    return new Group(Optional.of(table), traversal, new ArrayList<>());
  }

  private void describe(Group group) throws ModelFormatException {
    int count = input.count("attributes", input.remaining() / MIN_BYTES);
    for (int i = 0; i < count; i++) {
      group.attributes.add(new AttributeDecoder(input));
    }
    for (AttributeDecoder attribute : group.attributes) {
      attribute.readMethod();
    }
  }

  private void decode(Group group) throws ModelFormatException {
    Entries entries =
        group.table.isPresent()
            ? Traversal.entries(group.table.get(), group.traversal, input)
            : Entries.ofPoints(mesh.pointCount());
    int[] ofPoints = entries.toPoints(mesh, input);
    for (AttributeDecoder attribute : group.attributes) {
      Interrupts.check();
      attribute.decodeEntries(entries, positions);
      if (positions.isEmpty() && attribute.isPosition()) {
        positions = Optional.of(new Positions(attribute.entries(), ofPoints, mesh.points()));
      }
    }
    for (AttributeDecoder attribute : group.attributes) {
      attribute.readFormat();
    }
    for (AttributeDecoder attribute : group.attributes) {
      Interrupts.check();
      decoded.add(attribute.attribute(ofPoints));
    }
  }
}
