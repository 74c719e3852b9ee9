package org.jbox2d.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * Programs compiled against JBox2D 2.2.1.1 or 2.3.1 run on our classes: each signature of
 * jbox2d-api.txt, particles aside, has its counterpart. Where it has not, exceptions.txt gives the
 * reason; what is still to be built stands in not-yet.txt, which may only shrink.
 */
class ApiCompatibilityTest {
  /** More would mean that the contract is not kept. */
  private static final int MOST_EXCEPTIONS = 30;

  private final List<ApiEntry> entries =
      lines("jbox2d-api.txt").stream()
          .map(ApiEntry::parse)
          .filter(entry -> !entry.isOfParticles())
          .toList();
  private final Map<String, String> exceptions = exceptions();
  private final List<String> notYet = lines("not-yet.txt");

  @Test
  void eachSignatureHasItsCounterpart() throws IOException {
    List<String> problems = new ArrayList<>();
    int covered = 0;
    int internal = 0;
    int pending = 0;
    for (ApiEntry entry : entries) {
      Optional<String> problem = ApiCheck.problem(entry);
      if (problem.isEmpty()) {
        covered++;
      } else if (isPending(entry)) {
        pending++;
      } else if (entry.exposesInternalType() && ApiCheck.find(entry.owner()) != null) {
        internal++;
      } else if (!exceptions.containsKey(entry.signature())) {
        problems.add(entry.signature() + "  " + problem.get());
      }
    }
    writeReport(
        List.of(
            entries.size() + " signatures listed, particles aside",
            covered + " covered",
            internal + " dropped, naming internal types",
            exceptions.size() + " exceptions",
            pending + " not yet built"));
    assertEquals("", String.join("\n", problems));
  }

  /** The figures of the contract, for whoever wants to quote them. */
  private static void writeReport(List<String> lines) throws IOException {
    Files.createDirectories(Path.of("target"));
    Files.write(Path.of("target", "api-coverage.txt"), lines);
  }

  private boolean isPending(ApiEntry entry) {
    return notYet.contains(entry.signature()) || notYet.contains(entry.owner());
  }

  @Test
  void whatIsNotYetBuiltIsListedOnlyUntilItIs() {
    List<String> built = new ArrayList<>();
    for (ApiEntry entry : entries) {
      boolean exists =
          entry.isType() ? ApiCheck.find(entry.owner()) != null : ApiCheck.problem(entry).isEmpty();
      if (exists && notYet.contains(entry.signature())) {
        built.add(entry.signature());
      }
    }
    assertEquals("", String.join("\n", built), "take these out of not-yet.txt");
  }

  @Test
  void exceptionsAreFewAndNeededAndHaveReasons() {
    assertTrue(exceptions.size() <= MOST_EXCEPTIONS, () -> "" + exceptions.size());
    exceptions.forEach((signature, reason) -> assertTrue(reason.length() > 20, signature));
    List<String> needless = new ArrayList<>();
    for (ApiEntry entry : entries) {
      if (exceptions.containsKey(entry.signature()) && ApiCheck.problem(entry).isEmpty()) {
        needless.add(entry.signature());
      }
    }
    assertEquals("", String.join("\n", needless), "take these out of exceptions.txt");
  }

  /** A slip of the pen in one of the lists would otherwise excuse nothing, or stay for ever. */
  @Test
  void listsNameListedSignaturesOnly() {
    TreeSet<String> unknown = new TreeSet<>(exceptions.keySet());
    unknown.addAll(notYet);
    entries.forEach(entry -> unknown.remove(entry.signature()));
    assertEquals("", String.join("\n", unknown));
  }

  @Test
  void listIsReadInFull() {
    assertEquals(1801, lines("jbox2d-api.txt").size());
    ApiEntry method =
        ApiEntry.parse(
            "org.jbox2d.A.B#f(int, org.jbox2d.C[]) : float[]  protected static [2.2.1.1] refs=1");
    assertEquals(List.of("int", "org.jbox2d.C[]"), method.parameters());
    assertEquals("float[]", method.type());
    assertTrue(method.has("protected") && method.has("static") && !method.has("final"));
    ApiEntry constant =
        ApiEntry.parse("org.jbox2d.A#c : int = -1  public static final [2.2.1.1: const was 4]");
    assertEquals("-1", constant.constant());
    assertEquals("org.jbox2d.A#c : int", constant.signature());
    ApiEntry type =
        ApiEntry.parse(
            "org.jbox2d.A  TYPE public class extends org.jbox2d.S implements org.jbox2d.I,"
                + " org.jbox2d.J  [new] <core>");
    assertEquals(List.of("org.jbox2d.S", "org.jbox2d.I", "org.jbox2d.J"), type.supertypes());
    assertTrue(type.isType() && type.has("public"));
  }

  /** Lines of the form {@code signature -- reason}. */
  private static Map<String, String> exceptions() {
    Map<String, String> exceptions = new LinkedHashMap<>();
    for (String line : lines("exceptions.txt")) {
      String[] parts = line.split(" -- ", 2);
      exceptions.put(parts[0], parts.length < 2 ? "" : parts[1]);
    }
    return exceptions;
  }

  private static List<String> lines(String resource) {
    try (InputStream in = ApiCompatibilityTest.class.getResourceAsStream(resource)) {
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return text.lines().filter(line -> !line.isBlank() && !line.startsWith("#")).toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
