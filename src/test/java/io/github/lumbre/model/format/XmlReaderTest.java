package io.github.lumbre.model.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.model.ModelFormatException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the reading of XML. */
class XmlReaderTest {
  private static XmlReader reader(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    CRC32 crc = new CRC32();
    crc.update(bytes);
    return new XmlReader(
        new ZipInput("a.xml", false, ByteBuffer.wrap(bytes), bytes.length, crc.getValue()));
  }

  /** Returns the names of all elements, with the names of their children in brackets. */
  private static List<Object> names(XmlReader xml, int depth) throws ModelFormatException {
    List<Object> all = new ArrayList<>();
    while (xml.nextWithin(depth)) {
      all.add(xml.name());
      List<Object> children = names(xml, depth + 1);
      if (!children.isEmpty()) {
        all.add(children);
      }
    }
    return all;
  }

  private static String refusal(String text) {
    ModelFormatException thrown =
        catchThrowableOfType(ModelFormatException.class, () -> names(reader(text), 0));
    return thrown.getMessage();
  }

  @Test
  void elementsAreNested() throws ModelFormatException {
    String text = "<?xml version='1.0'?><!-- <x> --><a ><b/>text > <c><d /><e></e></c\n><f/></a>";
    assertThat(names(reader(text), 0)).hasToString("[a, [b, c, [d, e], f]]");
  }

  @Test
  void whatIsNotVisitedIsSkipped() throws ModelFormatException {
    XmlReader xml =
        reader("<a><b><c/><d><e/></d></b><!-- a - -- > --><f><![CDATA[</f> ]] >]]></f></a>");
    assertThat(xml.nextWithin(0)).isTrue();
    assertThat(xml.nextWithin(1)).isTrue();
    assertThat(xml.nextWithin(1)).isTrue();
    assertThat(xml.name()).isEqualTo("f");
    assertThat(xml.nextWithin(2)).isFalse();
    assertThat(xml.nextWithin(1)).isFalse();
    assertThat(xml.nextWithin(0)).isFalse();
  }

  @Test
  void attributesHaveEntitiesAndQuotes() throws ModelFormatException {
    XmlReader xml =
        reader("<a b = '\"&lt;&gt;&amp;&quot;&apos;&#65;&#x42;&none;&#x110000;' c=\"'>\"\tbb=''/>");
    assertThat(xml.nextWithin(0)).isTrue();
    assertThat(xml.text("b")).contains("\"<>&\"'AB&none;&#x110000;");
    assertThat(xml.text("c")).contains("'>");
    assertThat(xml.text("bb")).contains("");
    assertThat(xml.text("d")).isEmpty();
  }

  @Test
  void prefixesMeanNamespacesWithinTheirElement() throws ModelFormatException {
    XmlReader xml =
        reader(
            "<p:a xmlns:p='1' xmlns='2'><b p:x='y' x='z'/><p:b xmlns:p='3'/><p:b xmlns=''/></p:a>");
    assertThat(xml.nextWithin(0) && xml.is("1", "a")).isTrue();
    assertThat(xml.nextWithin(1) && xml.is("2", "b")).isTrue();
    assertThat(xml.text("1", "x")).contains("y");
    assertThat(xml.text("2", "x")).isEmpty();
    assertThat(xml.text("x")).contains("z");
    assertThat(xml.nextWithin(1) && xml.is("3", "b")).isTrue();
    assertThat(xml.nextWithin(1) && xml.is("1", "b")).isTrue();
    assertThat(xml.namespace("")).isEmpty();
    assertThat(xml.nextWithin(1)).isFalse();
  }

  @Test
  void numbersAreReadAsInOtherTexts() throws ModelFormatException {
    XmlReader xml =
        reader("<a x='-1.5e3' y=' 0.1 ' z='inf' w='123456789012345678901e-5' i='007'/>");
    assertThat(xml.nextWithin(0)).isTrue();
    assertThat(xml.number("x")).isEqualTo(-1500);
    assertThat(xml.number("y")).isEqualTo(.1);
    assertThat(xml.number("z")).isNaN();
    assertThat(xml.number("w")).isEqualTo(123456789012345678901e-5);
    assertThat(xml.integer("i", 7)).isEqualTo(7);
    XmlReader list = reader("<a b='\n1 2\r\n3'/>");
    assertThat(list.nextWithin(0)).isTrue();
    assertThat(list.words("b").remainingWords()).isEqualTo("1 2 3");
  }

  @Test
  void textsAreReadBeforeTheFirstChild() throws ModelFormatException {
    XmlReader xml =
        reader(
            "<a> 1 &lt;<!-- <b> --><![CDATA[ <> ]] ]]]> 2<b>3</b>4<c/><d><![CDATA[5]]></d></a>");
    assertThat(xml.nextWithin(0)).isTrue();
    assertThat(xml.text()).isEqualTo(" 1 < <> ]] ] 2");
    assertThat(xml.nextWithin(1) && xml.nextWithin(1)).isTrue();
    assertThat(xml.name()).isEqualTo("c");
    assertThat(xml.text()).isEmpty();
    assertThat(xml.nextWithin(1)).isTrue();
    assertThat(xml.text()).isEqualTo("5");
    assertThat(xml.nextWithin(1)).isFalse();
    assertThat(xml.nextWithin(0)).isFalse();
  }

  @Test
  void numbersOfTextsAreStreamed() throws ModelFormatException {
    XmlReader xml =
        reader("<a>\n 1 -2.5e1<!-- 9 -->3,5\r\n<![CDATA[4 5]]> nan 1e151 1e150 0x1<b/>7</a>");
    assertThat(xml.nextWithin(0)).isTrue();
    double[] expected = {1, -25, 3.5, 4, 5, Double.NaN, Double.NaN, 1e150, Double.NaN};
    for (double number : expected) {
      assertThat(xml.firstComma()).isEqualTo(number < 4 ? "" : "a.xml line 2");
      assertThat(xml.nextWord()).isTrue();
      assertThat(Double.valueOf(xml.wordNumber())).isEqualTo(Double.valueOf(number));
    }
    assertThat(xml.wordLocation()).isEqualTo("a.xml line 3");
    assertThat(xml.nextWord()).isFalse();
    assertThat(xml.nextWord()).isFalse();
    assertThat(xml.nextWithin(1)).isTrue();
    assertThat(xml.nextWord()).isFalse();
    assertThat(xml.nextWithin(1)).isFalse();
  }

  @Test
  void indicesOfTextsAreNotNegative() throws ModelFormatException {
    XmlReader xml = reader("<a>0 007 2147483647 2147483648 -1 1.0 x 99999999999999999999</a>");
    assertThat(xml.nextWithin(0)).isTrue();
    for (int index : new int[] {0, 7, Integer.MAX_VALUE, -1, -1, -1, -1, -1}) {
      assertThat(xml.nextWord()).isTrue();
      assertThat(xml.wordIndex()).isEqualTo(index);
    }
  }

  /** Blocks end anywhere in words, comments and tags. */
  @Test
  void textsMayBeLongerThanBlocks() throws ModelFormatException {
    for (int shift = 0; shift < 12; shift++) {
      String text = " ".repeat(shift) + "<a>" + "1234567 <!--8--> ".repeat(5000) + "</a>";
      XmlReader xml = reader(text);
      assertThat(xml.nextWithin(0)).isTrue();
      int count = 0;
      while (xml.nextWord()) {
        assertThat(xml.wordNumber()).isEqualTo(1234567);
        count++;
      }
      assertThat(count).isEqualTo(5000);
      assertThat(xml.nextWithin(0)).isFalse();
    }
    assertThat(refusalOfText("<a>" + "x".repeat((1 << 20) + 1) + "</a>"))
        .isEqualTo("a.xml line 1: expected a text of at most 1048576 bytes");
  }

  private static String refusalOfText(String text) {
    XmlReader xml = reader(text);
    return catchThrowableOfType(
            ModelFormatException.class,
            () -> {
              xml.nextWithin(0);
              xml.text();
            })
        .getMessage();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<a>;<b></a>|line 2: expected </b>, found </a>",
        "<a>;</a></a>|line 2: expected an element, found its end",
        "<a>|line 1: expected </a>, found the end of the file",
        "<a;b='1'|line 1: expected the end of a tag, found the end of the file",
        "<a b='>|line 1: expected the end of a tag, found the end of the file",
        "<a b>|line 1: expected an attribute with a value in quotes, found something else",
        "<a b=1>|line 1: expected an attribute with a value in quotes, found something else",
        "<a 'b'>|line 1: expected an attribute with a value in quotes, found something else",
        "< >|line 1: expected the name of an element, found none",
        "</>|line 1: expected an element, found its end",
        "<!DOCTYPE a [<!ENTITY b 'c'>]><a/>|line 1: expected XML without a document type, found"
            + " \"<!\"",
        "<a><!-- |line 1: expected \"-->\", found the end of the file",
        "<?xml |line 1: expected \"?>\", found the end of the file"
      })
  void errorsNameTheLine(String text, String message) {
    assertThat(refusal(text.replace(';', '\n'))).isEqualTo("a.xml " + message);
  }

  @Test
  void sizesAreLimited() {
    assertThat(refusal("<a>".repeat(101)))
        .isEqualTo("a.xml line 1: expected at most 100 elements within each other, found more");
    assertThat(refusal("<a b='" + "x".repeat(1 << 20) + "'/>"))
        .isEqualTo("a.xml line 1: expected a tag of at most 1048576 bytes");
    assertThat(refusal("<a " + "b='' ".repeat(101) + "/>"))
        .isEqualTo("a.xml line 1: expected at most 100 attributes");
    String names = "<a xmlns='1' xmlns:p='2' " + "xmlns:p='3' ".repeat(60) + ">";
    assertThat(refusal(names.repeat(20)))
        .isEqualTo("a.xml line 1: expected at most 1000 namespaces, found 1001");
  }
}
