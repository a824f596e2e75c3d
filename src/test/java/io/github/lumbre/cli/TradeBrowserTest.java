package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * In a browser, the page of {@code lumbre trade} is complete, free of console messages, and
 * readable on wide and narrow, light and dark screens. Screenshots are in {@code target/browser}.
 */
@Tag("browser")
class TradeBrowserTest {
  private static final Path FOLDER = Path.of("target", "browser");
  private static final Path PAGE = FOLDER.resolve("trade.html");

  /** Returns the names of the faulty elements, one per line. */
  private static final String NAMES =
      """
      const name = e => e.tagName + ' ' + (e.textContent || '').trim().slice(0, 60);
      const named = (all, isWrong) => [...all].filter(isWrong).map(name).join('\\n');
      const box = e => e.getBoundingClientRect();
      """;

  /**
   * Elements that scroll by themselves may be wider than the screen; the page may not. On a narrow
   * screen, innerWidth is the page width if that is larger, so the screen's own width is used.
   */
  private static final String OUTSIDE =
      """
      named(document.querySelectorAll('h1,h2,p,.scroll,table.facts'),
        e => box(e).left < 0 || box(e).right > screen.width || box(e).width < 8)
        + (document.documentElement.scrollWidth > screen.width ? 'the page' : '')
      """;

  /** Tables wider than a narrow screen that lack a note above them. */
  private static final String HIDDEN_COLUMNS =
"""
named([...document.querySelectorAll('.scroll')].filter(s => s.scrollWidth > s.clientWidth + 1),
  s => !s.previousElementSibling.matches('.hint') || box(s.previousElementSibling).height < 8)
""";

  /**
   * Contrast by WCAG 2.1, which requires 4.5 for texts. Deliberately gray elements are excluded.
   */
  private static final String FAINT =
"""
(() => {
  const paper = getComputedStyle(document.body).backgroundColor;
  const luminance = color => color.match(/[\\d.]+/g).slice(0, 3)
    .map(v => v / 255).map(v => v <= .03928 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4)
    .reduce((sum, v, i) => sum + v * [.2126, .7152, .0722][i], 0);
  const contrast = (a, b) => (Math.max(a, b) + .05) / (Math.min(a, b) + .05);
  return named(document.querySelectorAll('h1,h2,p,th,tr:not(.dominated) td'),
    e => contrast(luminance(getComputedStyle(e).color), luminance(paper)) < 4.5);
})()
""";

  private static final String EMPTY_TABLES =
      """
      named(document.querySelectorAll('table'), t => t.querySelectorAll('tbody tr').length < 3
        || [...t.querySelectorAll('tbody td:first-child')].some(cell => !cell.textContent.trim()))
      """;

  private static Browser browser;

  @BeforeAll
  static void makePage() throws Exception {
    Files.createDirectories(FOLDER);
    browser = Browser.start();
    String[] study = {
      "trade",
      "scenes/glass-and-mirror.json",
      "--size",
      "72x48",
      "-s",
      "64",
      "--seeds",
      "3",
      "-o",
      PAGE.toString()
    };
    assertThat(Outcome.of(study).exitCode()).isZero();
  }

  @AfterAll
  static void closeBrowser() throws Exception {
    if (browser != null) {
      browser.close();
    }
  }

  @ParameterizedTest(name = "{0}")
  @CsvSource({"wide, 1440, 900, false", "narrow, 360, 740, false", "dark, 1024, 768, true"})
  void pageIsCompleteAndReadable(String name, int width, int height, boolean isDark)
      throws Exception {
    URI address = PAGE.toUri();
    browser.open(address, width, height, isDark);
    browser.photograph(FOLDER.resolve("trade-" + name + ".png"));

    assertThat(browser.complaints()).isEmpty();
    assertThat(browser.requests())
        .allMatch(url -> URI.create(url).getPath().equals(address.getPath()));
    // The advice, noise, bias, denoised pictures, exact settings, all measurements, and the facts.
    assertThat(count("table")).isEqualTo(7);
    assertThat(wrong(OUTSIDE)).as("beyond the screen's sides").isEmpty();
    if (width < 640) {
      assertThat(wrong(HIDDEN_COLUMNS)).as("columns beyond the screen without a hint").isEmpty();
    }
    assertThat(wrong(FAINT)).as("texts of low contrast").isEmpty();
    assertThat(wrong(EMPTY_TABLES)).isEmpty();
    assertThat(browser.evaluate("document.body.innerText")).doesNotContain("NaN", "Infinity");
  }

  private static int count(String elements) {
    return Integer.parseInt(
        browser.evaluate("String(document.querySelectorAll('" + elements + "').length)"));
  }

  private static String wrong(String expression) {
    return browser.evaluate("(() => {" + NAMES + "return " + expression.strip() + "})()");
  }
}
