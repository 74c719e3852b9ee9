package org.jbox2d.api;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A line of the list of JBox2D's signatures: a type or a member of it.
 *
 * @param signature what identifies the line: the type's name, or {@code Type#field : type}, {@code
 *     Type#method(parameters) : type}, {@code Type#Type(parameters)}
 * @param owner the type's name, nested types after a dot
 * @param member simple name of the member; null for a type
 * @param parameters canonical names of the parameters' types; null for types and fields
 * @param type canonical name of the field's or the result's type; null for types and constructors
 * @param constant text of the constant's value; null if there is none
 * @param modifiers Java's modifiers; for a type also its kind and supertypes
 * @param marks what stands in brackets, brackets included
 */
record ApiEntry(
    String signature,
    String owner,
    String member,
    List<String> parameters,
    String type,
    String constant,
    List<String> modifiers,
    String marks) {

  private static final Pattern LINE =
      Pattern.compile(
          "(?<owner>[\\w.]+)(?:#(?<member>[\\w.]+)(?<parameters>\\([^)]*\\))?)?"
              + "(?: : (?<type>[\\w.\\[\\]]+))?(?: = (?<constant>.*?))?"
              + "  (?:TYPE )?(?<modifiers>[^\\[]*?) *(?<marks>\\[.*)?");

  static ApiEntry parse(String line) {
    String text = line.replaceAll("( <core>| <advanced>| refs=\\d+| clients=\\d+)", "");
    Matcher matcher = LINE.matcher(text);
    if (!matcher.matches()) {
      throw new IllegalArgumentException("no signature: " + line);
    }
    String owner = matcher.group("owner");
    String member = matcher.group("member");
    String parameters = matcher.group("parameters");
    String type = matcher.group("type");
    String signature =
        member == null
            ? owner
            : owner
                + "#"
                + member
                + (parameters == null ? "" : parameters)
                + (type == null ? "" : " : " + type);
    return new ApiEntry(
        signature,
        owner,
        member,
        parameters == null ? null : split(parameters.substring(1, parameters.length() - 1)),
        type,
        matcher.group("constant"),
        List.of(matcher.group("modifiers").split(",? ")),
        matcher.group("marks") == null ? "" : matcher.group("marks"));
  }

  private static List<String> split(String parameters) {
    return parameters.isEmpty() ? List.of() : List.of(parameters.split(", "));
  }

  boolean isType() {
    return member == null;
  }

  boolean isField() {
    return member != null && parameters == null;
  }

  boolean isConstructor() {
    return member != null && parameters != null && type == null;
  }

  boolean has(String modifier) {
    return modifiers.contains(modifier);
  }

  /** Of particles, which are not part of the rigid-body engine. */
  boolean isOfParticles() {
    return signature.toLowerCase(java.util.Locale.ROOT).contains("particle");
  }

  /** Names a type that is internal to JBox2D, so that no client can have a use for it. */
  boolean exposesInternalType() {
    return marks.contains("[exposes ");
  }

  /** The listed supertypes of a type. */
  List<String> supertypes() {
    List<String> supertypes = new ArrayList<>();
    for (String modifier : modifiers) {
      if (modifier.contains(".")) {
        supertypes.add(modifier);
      }
    }
    return supertypes;
  }
}
