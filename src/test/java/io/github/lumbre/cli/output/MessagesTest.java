package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the escaping of unprintable characters in messages. */
class MessagesTest {
  @ParameterizedTest
  @ValueSource(ints = {0, 7, '\n', '\r', 0x1b, 0x7f, 0x9b, 0x202e, 0x2028, 0xd800, 0xfeff})
  void unprintableCharactersAreWrittenAsEscapes(int codePoint) {
    String text = "a" + Character.toString(codePoint) + "b";
    assertThat(Messages.printable(text)).isEqualTo(String.format("a\\u%04xb", codePoint));
  }

  @Test
  void lettersOfAllScriptsStay() {
    String text = "lumbre ñ Ω 光 😀 $.objects[0] \\ \"";
    assertThat(Messages.printable(text)).isEqualTo(text);
  }
}
