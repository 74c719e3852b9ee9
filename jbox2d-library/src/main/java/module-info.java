/** A 2D rigid-body engine with the API of JBox2D 2.3. */
module org.jbox2d.library {
  exports org.jbox2d.callbacks;
  exports org.jbox2d.collision;
  exports org.jbox2d.collision.broadphase;
  exports org.jbox2d.collision.shapes;
  exports org.jbox2d.common;
  exports org.jbox2d.dynamics;
  exports org.jbox2d.dynamics.contacts;
  exports org.jbox2d.dynamics.joints;
  exports org.jbox2d.pooling;
  exports org.jbox2d.pooling.arrays;
  exports org.jbox2d.pooling.normal;
}
