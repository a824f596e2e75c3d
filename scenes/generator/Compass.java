package generator;

/** Points of the compass, by their heading in degrees: north is +z, east is +x. */
enum Compass {
  NORTH(0),
  EAST(90),
  SOUTH(180),
  WEST(270);

  final double heading;

  Compass(double heading) {
    this.heading = heading;
  }
}
