package org.jbox2d.api;

import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Whether a program compiled against a listed signature links and runs with our classes: members
 * are looked up as the JVM resolves them (JVMS 5.4.3), by name and whole descriptor, in the class,
 * its superclasses and its interfaces.
 */
final class ApiCheck {
  private ApiCheck() {}

  /** What is wrong with our counterpart of a listed signature; empty if nothing is. */
  static Optional<String> problem(ApiEntry entry) {
    Class<?> owner = find(entry.owner());
    if (owner == null) {
      return Optional.of("type is missing");
    }
    if (entry.isType()) {
      return problemOfType(entry, owner);
    }
    if (entry.isField()) {
      return problemOfField(entry, owner);
    }
    return entry.isConstructor()
        ? problemOfConstructor(entry, owner)
        : problemOfMethod(entry, owner);
  }

  /** The class of a name in which a dot may precede a nested class. */
  static Class<?> find(String name) {
    try {
      return Class.forName(name, false, ApiCheck.class.getClassLoader());
    } catch (ClassNotFoundException e) {
      int dot = name.lastIndexOf('.');
      boolean nested =
          dot > 0 && Character.isUpperCase(simpleName(name.substring(0, dot)).charAt(0));
      return nested ? find(name.substring(0, dot) + "$" + name.substring(dot + 1)) : null;
    }
  }

  private static String simpleName(String name) {
    return name.substring(name.lastIndexOf('.') + 1);
  }

  private static Optional<String> problemOfType(ApiEntry entry, Class<?> type) {
    List<String> problems = new ArrayList<>();
    compareVisibility(entry, type.getModifiers(), problems);
    if (entry.has("interface") != type.isInterface() || entry.has("enum") != type.isEnum()) {
      problems.add("is of another kind");
    }
    boolean nested = type.getDeclaringClass() != null;
    if (nested && entry.has("static") != Modifier.isStatic(type.getModifiers())) {
      problems.add("differs in static");
    }
    forbid(entry, "abstract", Modifier.isAbstract(type.getModifiers()), problems);
    forbid(entry, "final", Modifier.isFinal(type.getModifiers()), problems);
    for (String name : entry.supertypes()) {
      Class<?> supertype = find(name);
      if (supertype == null || !supertype.isAssignableFrom(type)) {
        problems.add("is no " + name);
      }
    }
    return join(problems);
  }

  private static Optional<String> problemOfField(ApiEntry entry, Class<?> owner) {
    for (Class<?> type : lineage(owner)) {
      for (Field field : type.getDeclaredFields()) {
        if (field.getName().equals(entry.member()) && isType(field.getType(), entry.type())) {
          List<String> problems = compareMember(entry, field);
          forbid(entry, "final", Modifier.isFinal(field.getModifiers()), problems);
          compareConstant(entry, field, problems);
          return join(problems);
        }
      }
    }
    return Optional.of("is missing");
  }

  /** Clients have the value of a listed constant compiled in; ours must be the same. */
  private static void compareConstant(ApiEntry entry, Field field, List<String> problems) {
    if (entry.constant() == null || !entry.has("final")) {
      return;
    }
    if (!field.trySetAccessible()) {
      problems.add("cannot be read");
      return;
    }
    try {
      String value = String.valueOf(field.get(null));
      if (!value.equals(entry.constant())) {
        problems.add("has the value " + value + " instead of " + entry.constant());
      }
    } catch (IllegalAccessException e) {
      problems.add("cannot be read");
    }
  }

  private static Optional<String> problemOfConstructor(ApiEntry entry, Class<?> owner) {
    for (Constructor<?> constructor : owner.getDeclaredConstructors()) {
      if (hasParameters(constructor, entry)) {
        return join(compareMember(entry, constructor));
      }
    }
    return Optional.of("is missing");
  }

  private static Optional<String> problemOfMethod(ApiEntry entry, Class<?> owner) {
    for (Class<?> type : lineage(owner)) {
      for (Method method : type.getDeclaredMethods()) {
        boolean same =
            method.getName().equals(entry.member())
                && hasParameters(method, entry)
                && isType(method.getReturnType(), entry.type());
        if (same) {
          List<String> problems = compareMember(entry, method);
          forbid(entry, "abstract", Modifier.isAbstract(method.getModifiers()), problems);
          boolean overridable = !entry.has("static") && !Modifier.isFinal(owner.getModifiers());
          forbid(entry, "final", overridable && Modifier.isFinal(method.getModifiers()), problems);
          return join(problems);
        }
      }
    }
    return Optional.of("is missing");
  }

  private static List<String> compareMember(ApiEntry entry, Member member) {
    List<String> problems = new ArrayList<>();
    compareVisibility(entry, member.getModifiers(), problems);
    if (entry.has("static") != Modifier.isStatic(member.getModifiers())) {
      problems.add("differs in static");
    }
    return problems;
  }

  private static void compareVisibility(ApiEntry entry, int modifiers, List<String> problems) {
    boolean visible =
        Modifier.isPublic(modifiers) || (entry.has("protected") && Modifier.isProtected(modifiers));
    if (!visible) {
      problems.add("is less visible");
    }
  }

  private static void forbid(ApiEntry entry, String modifier, boolean ours, List<String> problems) {
    if (ours && !entry.has(modifier)) {
      problems.add("is " + modifier);
    }
  }

  /**
   * The classes and interfaces that members are inherited from; those of the JDK prove nothing and
   * are left out.
   */
  private static List<Class<?>> lineage(Class<?> type) {
    List<Class<?>> lineage = new ArrayList<>();
    for (Class<?> c = type; c != null; c = c.getSuperclass()) {
      if (isOurs(c)) {
        lineage.add(c);
      }
    }
    for (int i = 0; i < lineage.size(); i++) {
      for (Class<?> c : lineage.get(i).getInterfaces()) {
        if (isOurs(c) && !lineage.contains(c)) {
          lineage.add(c);
        }
      }
    }
    return lineage;
  }

  private static boolean isOurs(Class<?> type) {
    return type.getName().startsWith("org.jbox2d.");
  }

  private static boolean hasParameters(Executable executable, ApiEntry entry) {
    List<String> ours =
        Arrays.stream(executable.getParameterTypes()).map(Class::getCanonicalName).toList();
    return ours.equals(entry.parameters());
  }

  private static boolean isType(Class<?> type, String name) {
    return name.equals(type.getCanonicalName());
  }

  private static Optional<String> join(List<String> problems) {
    return problems.isEmpty() ? Optional.empty() : Optional.of(String.join(", ", problems));
  }
}
