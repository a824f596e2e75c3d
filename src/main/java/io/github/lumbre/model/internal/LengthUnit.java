package io.github.lumbre.model.internal;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The units of length that files state (3MF core specification 1.3, section 3.4). */
public enum LengthUnit {
  MICRON(1e-6),
  MILLIMETER(.001),
  CENTIMETER(.01),
  INCH(.0254),
  FOOT(.3048),
  METER(1);

  private final double meters;

  LengthUnit(double meters) {
    this.meters = meters;
  }

  /** Returns the unit of a name, without regard to case; empty if there is none. */
  public static Optional<LengthUnit> named(String name) {
    return Arrays.stream(values()).filter(unit -> unit.name().equalsIgnoreCase(name)).findFirst();
  }

  /** Returns the name of the unit of a length in meters; empty if none is as long. */
  public static String nameOf(double meters) {
    return Arrays.stream(values())
        .filter(unit -> unit.meters == meters)
        .map(LengthUnit::title)
        .findFirst()
        .orElse("");
  }

  /** Returns the name, such as {@code millimeter}. */
  public String title() {
    return name().toLowerCase(Locale.ROOT);
  }

  public double meters() {
    return meters;
  }
}
