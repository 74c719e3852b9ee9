/** Bodies that shatter on impact. */
module org.jbox2d.fracture {
  requires transitive org.jbox2d.library;
  requires poly2tri.core;

  exports org.jbox2d.fracture;
  exports org.jbox2d.fracture.materials;
}
