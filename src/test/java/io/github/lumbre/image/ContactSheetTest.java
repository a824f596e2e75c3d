package io.github.lumbre.image;

import static org.assertj.core.api.Assertions.assertThat;

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
    Image sheet = ContactSheet.of(Collections.nCopies(3, black(0)), 2);
    assertThat(sheet.rgb()).startsWith(new float[18]).endsWith(1, 1, 1, 1, 1, 1);
    assertThat(ContactSheet.of(Collections.nCopies(4, black(0)), 2).rgb()).containsOnly(0);
    assertThat(ContactSheet.of(List.of(black(0)), 3).rgb()[6]).isEqualTo(1);
  }

  @Test
  void freeCellsAreTransparentIfPicturesHaveAlpha() {
    Image sheet = ContactSheet.of(Collections.nCopies(3, black(2)), 2);
    assertThat(sheet.rgb()).containsOnly(0);
    assertThat(sheet.alpha(2, 1)).isZero();
  }
}
