package org.jbox2d.collision.shapes;

/** Kinds of shapes; programs switch on the ordinals, so the order stays. */
public enum ShapeType {
  CIRCLE,
  EDGE,
  POLYGON,
  CHAIN
}
