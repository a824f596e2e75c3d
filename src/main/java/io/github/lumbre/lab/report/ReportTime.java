package io.github.lumbre.lab.report;

/** Formats times as the 2016 report does. */
public final class ReportTime {
  private ReportTime() {}

  /**
   * Returns a time as text: {@code 1h 26m 32s 336ms}. Leading zero units are omitted; hours are not
   * limited to a day.
   *
   * @param seconds finite, at least 0
   */
  public static String of(double seconds) {
    long millis = Math.round(seconds * 1000);
    long s = millis / 1000;
    StringBuilder text = new StringBuilder();
    if (s >= 3600) {
      text.append(s / 3600).append("h ");
    }
    if (s >= 60) {
      text.append(s / 60 % 60).append("m ");
    }
    if (s >= 1) {
      text.append(s % 60).append("s ");
    }
    return text.append(millis % 1000).append("ms").toString();
  }
}
