package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** The points of the chart of errors stay few, and show the beginning as well as the end. */
class ErrorHistoryTest {
  private static ErrorPoint at(double seconds) {
    return new ErrorPoint(seconds, 10 * seconds, .1, .2, false);
  }

  @Test
  void hourOfPointsIsBoundedAndSpreadOverTheLogarithmOfTime() {
    ErrorHistory history = new ErrorHistory();
    int count = 5 * 3600;
    for (int i = 0; i < count; i++) {
      history.add(at(.2 * i));
    }
    List<ErrorPoint> points = history.points();
    assertThat(points).hasSize(ErrorHistory.MOST);
    assertThat(points.get(0).seconds()).isZero();
    assertThat(points.get(points.size() - 1)).isEqualTo(at(.2 * (count - 1)));
    for (int i = 2; i < points.size(); i++) {
      double ratio = points.get(i).seconds() / points.get(i - 1).seconds();
      // 256 points over four decades are 1.04 apart in the mean; the first ones are all there.
      assertThat(ratio).isBetween(1.0001, points.get(i).seconds() < 3 ? 2.01 : 1.12);
    }
  }

  @Test
  void fewPointsAreAllKept() {
    ErrorHistory history = new ErrorHistory();
    for (int i = 0; i < ErrorHistory.MOST; i++) {
      history.add(at(i));
    }
    assertThat(history.points()).hasSize(ErrorHistory.MOST).contains(at(17), at(255));
    history.clear();
    assertThat(history.points()).isEmpty();
  }
}
