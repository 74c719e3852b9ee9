package org.jbox2d.api;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The check of signatures finds what would break a client, on classes made for it. */
class ApiCheckTest {
  @SuppressWarnings("unused")
  static class Base {
    public int inherited;

    public float ratio(int[] values) {
      return 0;
    }
  }

  @SuppressWarnings("unused")
  public abstract static class Sample extends Base implements Comparable<Sample> {
    public static final int LIMIT = 8;
    public final int fixed = 1;
    protected int guarded;
    int hidden;

    protected Sample(int value) {}

    public static void utility() {}

    public final void closed() {}

    public abstract void open();

    @Override
    public int compareTo(Sample other) {
      return 0;
    }
  }

  public enum Kind {
    ONE
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "Sample  TYPE public static abstract class implements java.lang.Comparable; ''",
        "Sample  TYPE public static class; is abstract",
        "Sample  TYPE public abstract interface; is of another kind, differs in static",
        "Sample  TYPE public static abstract class extends java.lang.Thread; is no java.lang.Thread",
        "Base  TYPE public static class; is less visible",
        "Kind  TYPE public static final enum; ''",
        "Kind  TYPE public static final class; is of another kind",
        "Lost  TYPE public static class; type is missing",
        "Lost#f : int  public; type is missing",
        "Sample#LIMIT : int = 8  public static final; ''",
        "Sample#LIMIT : int = 9  public static final; has the value 8 instead of 9",
        "Sample#LIMIT : float = 8  public static final; is missing",
        "Sample#LIMIT : int  public static; is final",
        "Sample#fixed : int  public; is final",
        "Sample#fixed : int  public static final; differs in static",
        "Sample#guarded : int  protected; ''",
        "Sample#guarded : int  public; is less visible",
        "Sample#hidden : int  protected; is less visible",
        "Sample#inherited : int  public; ''",
        "Sample#ratio(int[]) : float  public; ''",
        "Sample#ratio(int) : float  public; is missing",
        "Sample#ratio(int[]) : double  public; is missing",
        "Sample#Sample(int)  protected; ''",
        "Sample#Sample(int)  public; is less visible",
        "Sample#Sample()  protected; is missing",
        "Sample#utility() : void  public static; ''",
        "Sample#utility() : void  public; differs in static",
        "Sample#closed() : void  public; is final",
        "Sample#closed() : void  public final; ''",
        "Sample#open() : void  public; is abstract",
        "Sample#open() : void  public abstract; ''",
        "Sample#toString() : java.lang.String  public; is missing",
      })
  void findsWhatWouldBreakAClient(String line, String problem) {
    ApiEntry entry = ApiEntry.parse(ApiCheckTest.class.getName() + "." + line);
    assertEquals(Optional.of(problem).filter(text -> !text.isEmpty()), ApiCheck.problem(entry));
  }
}
