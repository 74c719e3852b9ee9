package org.jbox2d.documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.jbox2d.documentation.Document.Block;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

/** What the documents tell to put into a build is there, in the version of this build. */
class CoordinatesTest {
  private static final List<String> PUBLISHED = List.of("jbox2d-library", "jbox2d-fracture");

  private final Element project = parse(read("pom.xml"));
  private final String group = text(project, "groupId");
  private final String version = text(project, "version");

  @TestFactory
  List<DynamicTest> xmlIsWellFormedAndOfThisVersion() {
    List<Block> blocks = Document.blocksIn("xml");
    assertTrue(blocks.size() >= 3, blocks.toString());
    return blocks.stream()
        .map(b -> DynamicTest.dynamicTest(b.toString(), () -> checkXml(b.code())))
        .collect(Collectors.toList());
  }

  private void checkXml(String xml) {
    String declaration = xml.startsWith("<?") ? xml.substring(0, xml.indexOf("?>") + 2) : "";
    String rest = xml.substring(declaration.length());
    Element root = parse("<snippet>" + rest + "</snippet>");
    NodeList dependencies = root.getElementsByTagName("dependency");
    for (int i = 0; i < dependencies.getLength(); i++) {
      Element dependency = (Element) dependencies.item(i);
      if (text(dependency, "groupId").equals(group)) {
        assertTrue(PUBLISHED.contains(text(dependency, "artifactId")), xml);
        assertEquals(version, text(dependency, "version"));
      }
    }
  }

  /** In each language there may be: Gradle's own, commands, text. */
  @Test
  void coordinatesInOneWordAreOfThisVersion() {
    Pattern word = Pattern.compile(Pattern.quote(group) + ":([\\w-]+):([\\w.-]*\\w)");
    int found = 0;
    for (Document document : Document.all()) {
      Matcher matcher = word.matcher(document.text);
      while (matcher.find()) {
        found++;
        assertTrue(PUBLISHED.contains(matcher.group(1)), document + ": " + matcher.group());
        assertEquals(version, matcher.group(2), document.toString());
      }
    }
    assertTrue(found >= 2, found + " found");
  }

  private static String read(String file) {
    try {
      return Files.readString(Document.REPOSITORY.resolve(file));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static Element parse(String xml) {
    try {
      DocumentBuilder builder = DocumentBuilderFactory.newInstance().newDocumentBuilder();
      return builder.parse(new InputSource(new StringReader(xml))).getDocumentElement();
    } catch (ParserConfigurationException | SAXException | IOException e) {
      throw new AssertionError(xml, e);
    }
  }

  /** The text of the first child with a name, or nothing. */
  private static String text(Element parent, String name) {
    for (int i = 0; i < parent.getChildNodes().getLength(); i++) {
      if (parent.getChildNodes().item(i).getNodeName().equals(name)) {
        return parent.getChildNodes().item(i).getTextContent().trim();
      }
    }
    return "";
  }
}
