package io.github.lumbre.model.format.threemf;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.PlainModel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Properties to which the corners of triangles refer by the group's id and an index. Mutable. */
final class PropertyGroup {
  /** What the properties of a group are. */
  enum Kind {
    /** Materials with a name and a linear color with alpha; a triangle has one. */
    MATERIAL(4),
    /** Linear colors with alpha; each corner has one. */
    COLOR(4),
    /** Texture coordinates; each corner has a pair. */
    TEXTURE(2);

    private final int size;

    Kind(int size) {
      this.size = size;
    }
  }

  private final Kind kind;
  private final String location;
  private final ModelMaterial textured;
  private final List<String> names = new ArrayList<>();
  private final List<ModelMaterial> materials = new ArrayList<>();
  private double[] values = new double[16];
  private int count;

  /**
   * @param location of the group, for messages
   * @param textured the material of a {@link Kind#TEXTURE}
   */
  PropertyGroup(Kind kind, String location, ModelMaterial textured) {
    this.kind = kind;
    this.location = location;
    this.textured = textured;
  }

  /** Returns an empty group of the same kind. */
  PropertyGroup like() {
    return new PropertyGroup(kind, location, textured);
  }

  /**
   * Adds a property.
   *
   * @param name of a material; empty for other properties
   */
  void add(String name, double... numbers) {
    int end = kind.size * count;
    if (end + kind.size > values.length) {
      values = Arrays.copyOf(values, Math.multiplyExact(2, values.length));
    }
    System.arraycopy(numbers, 0, values, end, kind.size);
    count++;
    if (kind == Kind.MATERIAL) {
      names.add(name);
    }
  }

  /** Adds a property of a group of the same kind. */
  void addFrom(PropertyGroup other, int index) {
    add(kind == Kind.MATERIAL ? other.names.get(index) : "", other.numbers(index));
  }

  /** Returns the numbers of a property: four of a color, two of texture coordinates. */
  double[] numbers(int index) {
    return Arrays.copyOfRange(values, kind.size * index, kind.size * (index + 1));
  }

  Kind kind() {
    return kind;
  }

  /** Returns the number of properties. */
  int count() {
    return count;
  }

  /** Returns the numbers of all properties; those after the last one have no meaning. */
  double[] values() {
    return values;
  }

  /** Returns the material of a property that is no color. */
  ModelMaterial material(int index) {
    if (kind == Kind.TEXTURE) {
      return textured;
    }
    while (materials.size() <= index) {
      materials.add(made(materials.size()));
    }
    return materials.get(index);
  }

  private ModelMaterial made(int index) {
    double[] color = numbers(index);
    return PlainModel.matte(names.get(index), location + "[" + index + "]")
        .set(MaterialParameter.BASE_COLOR, new Rgb(color[0], color[1], color[2]))
        .set(MaterialParameter.OPACITY, color[3])
        .alphaMode(color[3] < 1 ? AlphaMode.BLEND : AlphaMode.OPAQUE)
        .build();
  }
}
