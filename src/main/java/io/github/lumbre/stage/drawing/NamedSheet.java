package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.internal.ContactSheet;
import io.github.lumbre.image.internal.ContactSheet.Grid;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * A contact sheet of pictures with their names below, about as many columns as rows. Its cells have
 * the size of the largest picture; smaller ones are in the middle. Mutable; for one thread.
 */
public final class NamedSheet {
  /** The gaps are narrower than a picture by this factor. */
  private static final int GAPS_PER_WIDTH = 32;

  private final List<String> names;
  private final List<Optional<Image>> pictures;
  private int width = 1;
  private int height = 1;

  /**
   * Creates a sheet of empty cells.
   *
   * @param names at least one
   */
  public NamedSheet(List<String> names) {
    this.names = List.copyOf(names);
    pictures = new ArrayList<>(Collections.nCopies(names.size(), Optional.empty()));
  }

  /**
   * Sets the picture of a cell.
   *
   * @param picture in linear light
   */
  public void put(int cell, Image picture) {
    width = Math.max(width, picture.width());
    height = Math.max(height, picture.height());
    pictures.set(cell, Optional.of(picture));
  }

  /** Returns whether a cell has a picture. */
  public boolean has(int cell) {
    return pictures.get(cell).isPresent();
  }

  /** Returns the number of cells with a picture. */
  public long count() {
    return pictures.stream().filter(Optional::isPresent).count();
  }

  /** Returns the places of the cells, their names included. */
  public Grid grid() {
    return gridWith(1, 1);
  }

  /** Returns the places of the cells if one of them has a picture of a size, too. */
  public Grid gridWith(int pictureWidth, int pictureHeight) {
    int columns = (int) Math.ceil(Math.sqrt(names.size()));
    int wide = Math.max(width, pictureWidth);
    int high = Math.max(height, pictureHeight);
    int gap = Math.max(1, wide / GAPS_PER_WIDTH);
    return new Grid(names.size(), columns, wide, high + Caption.height(wide), gap);
  }

  /** Returns the number of names that are cut so short that nobody can read them. */
  public long unreadable() {
    return names.stream().filter(name -> !Caption.hasRoom(name, width)).count();
  }

  /**
   * Returns the sheet, and forgets the pictures.
   *
   * @throws IllegalArgumentException if it has more than 2^28 pixels
   */
  public Image image() {
    boolean hasAlpha = pictures.stream().flatMap(Optional::stream).anyMatch(Image::hasAlpha);
    ContactSheet sheet = new ContactSheet(grid(), hasAlpha);
    for (int cell = 0; cell < names.size(); cell++) {
      if (has(cell)) {
        Image picture = pictures.get(cell).get();
        int x = (width - picture.width()) / 2;
        sheet.put(cell, x, (height - picture.height()) / 2, picture);
        pictures.set(cell, Optional.empty());
      }
      sheet.put(cell, 0, height, Caption.of(names.get(cell), width, hasAlpha));
    }
    return sheet.image();
  }
}
