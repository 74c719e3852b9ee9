package org.jbox2d.testbed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jbox2d.testbed.paint.Layer;
import org.jbox2d.testbed.scenes.Scenes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** The page on the testbed: its commands are run, in order; its numbers are counted. */
class GuideTest {
  private static final Path GUIDE = Path.of("../docs/testbed.md");
  private static final String START = "java -jar jbox2d-testbed/target/jbox2d-testbed.jar ";

  @TempDir Path directory;

  @Test
  void commandsDoWhatTheySay() throws IOException {
    List<String> commands =
        Files.readAllLines(GUIDE).stream().filter(line -> line.startsWith(START)).toList();
    assertEquals(6, commands.size());
    for (String command : commands) {
      String[] args = command.substring(START.length()).split(" ");
      for (int i = 0; i < args.length; i++) {
        if (args[i].matches("\\w+\\.(png|csv|gif|rec)")) {
          args[i] = directory.resolve(args[i]).toString();
        }
      }
      StringWriter out = new StringWriter();
      StringWriter err = new StringWriter();
      CommandLine line = TestbedCommand.commandLine();
      line.setOut(new PrintWriter(out, true));
      line.setErr(new PrintWriter(err, true));
      assertEquals(0, line.execute(args), command + ": " + err);
      assertTrue(out.toString().length() > 10, command);
    }
    for (String file : List.of("main.png", "main.csv", "run.rec", "run.gif")) {
      assertTrue(Files.size(directory.resolve(file)) > 1000, file);
    }
  }

  @Test
  void numbersAreThoseOfTheProgram() throws IOException {
    String guide = Files.readString(GUIDE);
    assertTrue(guide.contains(Scenes.all().size() + " scenes"));
    assertTrue(guide.contains("`1` to `" + Layer.values().length + "`"));
    String help = TestbedCommand.commandLine().getUsageMessage();
    for (int code = 0; code <= 3; code++) {
      String number = Integer.toString(code);
      String row =
          guide.lines().filter(line -> line.startsWith("| " + number + " |")).findFirst().get();
      String meaning = row.split("\\|")[2].trim();
      assertTrue(help.replaceAll("\\s+", " ").contains(number + " " + meaning), meaning);
    }
  }
}
