package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Image;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests what is in the free cells of a contact sheet. */
class ContactSheetTest {
  private static Image black(int alphas) {
    return new Image(2, 1, new float[6], new float[alphas]);
  }

  @Test
  void freeCellsAreWhite() {
    Image sheet = ContactSheet.of(Collections.nCopies(3, black(0)), 2, 0);
    assertThat(sheet.rgb()).startsWith(new float[18]).endsWith(1, 1, 1, 1, 1, 1);
    assertThat(ContactSheet.of(Collections.nCopies(4, black(0)), 2, 0).rgb()).containsOnly(0);
    assertThat(ContactSheet.of(List.of(black(0)), 3, 0).rgb()[6]).isEqualTo(1);
  }

  /** Pictures of 2x1 pixels in two rows, with a gap of 1 pixel, which is white. */
  @Test
  void gapsAreWhite() {
    Image sheet = ContactSheet.of(Collections.nCopies(4, black(0)), 2, 1);
    assertThat(sheet.width()).isEqualTo(5);
    assertThat(sheet.height()).isEqualTo(3);
    float[] reds = new float[15];
    for (int i = 0; i < 15; i++) {
      reds[i] = sheet.rgb()[3 * i];
    }
    assertThat(reds).containsExactly(0, 0, 1, 0, 0, 1, 1, 1, 1, 1, 0, 0, 1, 0, 0);
  }

  @Test
  void gapsAreTransparentIfPicturesHaveAlpha() {
    Image covered = new Image(1, 1, new float[] {.5f, .5f, .5f}, new float[] {1});
    Image sheet = ContactSheet.of(List.of(covered, covered), 2, 1);
    assertThat(List.of(sheet.alpha(0, 0), sheet.alpha(1, 0), sheet.alpha(2, 0)))
        .containsExactly(1f, 0f, 1f);
    assertThat(sheet.rgb()).containsExactly(.5f, .5f, .5f, 0, 0, 0, .5f, .5f, .5f);
  }

  @Test
  void freeCellsAreTransparentIfPicturesHaveAlpha() {
    Image sheet = ContactSheet.of(Collections.nCopies(3, black(2)), 2, 0);
    assertThat(sheet.rgb()).containsOnly(0);
    assertThat(sheet.alpha(2, 1)).isZero();
  }

  @Test
  void picturesStayInTheirCells() {
    ContactSheet sheet = new ContactSheet(new ContactSheet.Grid(3, 2, 3, 2, 1), false);
    sheet.put(1, 1, 1, black(0));
    Image image = sheet.image();
    for (int i = 0; i < 35; i++) {
      boolean isCovered = i == 12 || i == 13;
      assertThat(image.pixel(i % 7, i / 7).r()).as("pixel " + i).isEqualTo(isCovered ? 0 : 1);
    }
    for (int[] at : new int[][] {{-1, 0}, {0, -1}, {2, 0}, {0, 2}}) {
      assertThatThrownBy(() -> sheet.put(0, at[0], at[1], black(0)))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("picture: expected one inside of 3x2, found 2x1 at");
    }
    assertThatThrownBy(() -> sheet.put(0, 0, 0, black(2)))
        .hasMessage("picture: expected one without alpha");
  }

  @Test
  void sheetsThatAreTooLargeAreRefused() {
    assertThatThrownBy(
            () -> new ContactSheet(new ContactSheet.Grid(400, 20, 65535, 65535, 9), false))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("at most 2^28 pixels");
    assertThatThrownBy(() -> new ContactSheet.Grid(0, 1, 1, 1, 0))
        .hasMessageContaining("found 0, 1, 1, 1, 0");
  }
}
