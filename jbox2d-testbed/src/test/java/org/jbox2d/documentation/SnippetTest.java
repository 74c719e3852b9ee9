package org.jbox2d.documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jbox2d.documentation.Document.Block;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/**
 * Each snippet of Java in the documents compiles and runs. One that is said to be a file is that
 * file of one of the programs that the build of {@code consumers} compiles and tests.
 */
class SnippetTest {
  private static final Path PROGRAMS = Document.REPOSITORY.resolve("consumers/src/it");

  @TestFactory
  List<DynamicTest> snippetsCompileAndRun() {
    List<Block> blocks =
        Document.blocksIn("java").stream()
            .filter(b -> b.file() == null)
            .collect(Collectors.toList());
    assertTrue(blocks.size() >= 3, blocks.toString());
    return blocks.stream()
        .map(b -> DynamicTest.dynamicTest(b.toString(), () -> Snippet.compile(b.code()).run()))
        .collect(Collectors.toList());
  }

  @TestFactory
  List<DynamicTest> filesAreThoseOfThePrograms() {
    List<Block> blocks =
        Document.all().stream()
            .flatMap(d -> d.blocks.stream())
            .filter(b -> b.file() != null)
            .collect(Collectors.toList());
    assertTrue(blocks.size() >= 6, blocks.toString());
    return blocks.stream()
        .map(
            b ->
                DynamicTest.dynamicTest(
                    b + " " + b.file(), () -> assertEquals(programFile(b.file()), b.code())))
        .collect(Collectors.toList());
  }

  /** Whoever follows the first steps gets the whole program that is tested. */
  @Test
  void firstStepsHaveAllFilesOfTheProgram() throws IOException {
    Path program = PROGRAMS.resolve("breaking-glass");
    Document steps = Document.of(Document.REPOSITORY.resolve("docs/getting-started.md"));
    List<String> told =
        steps.blocks.stream()
            .map(Block::file)
            .filter(f -> f != null)
            .sorted()
            .collect(Collectors.toList());
    try (Stream<Path> files = Files.walk(program)) {
      List<String> there =
          files
              .filter(Files::isRegularFile)
              .map(f -> program.relativize(f).toString().replace('\\', '/'))
              .filter(f -> f.endsWith(".java") || f.equals("pom.xml"))
              .sorted()
              .collect(Collectors.toList());
      assertEquals(there, told);
    }
  }

  @Test
  void exampleOfTheReadmeBreaks() throws ReflectiveOperationException {
    Document readme = Document.of(Document.REPOSITORY.resolve("README.md"));
    Block example =
        readme.blocks.stream().filter(b -> b.language().equals("java")).findFirst().orElseThrow();
    int bodies = Snippet.compile(example.code()).run().getBodyCount();
    assertTrue(bodies > 10, bodies + " bodies");
  }

  @Test
  void snippetThatIsWrongIsTold() {
    AssertionError e =
        assertThrows(AssertionError.class, () -> Snippet.compile("world.stepp(1f / 60, 8, 3);\n"));
    assertTrue(e.getMessage().contains("stepp"), e.getMessage());
  }

  private static String programFile(String name) throws IOException {
    try (Stream<Path> programs = Files.list(PROGRAMS)) {
      List<Path> found =
          programs
              .map(p -> p.resolve(name))
              .filter(Files::isRegularFile)
              .sorted()
              .collect(Collectors.toList());
      assertTrue(!found.isEmpty(), "no program has the file " + name);
      // The first steps come first; what both have, as the project's file, is told there alone.
      return Files.readString(
          found.stream()
              .filter(p -> p.toString().contains("breaking"))
              .findFirst()
              .orElse(found.get(0)));
    }
  }
}
