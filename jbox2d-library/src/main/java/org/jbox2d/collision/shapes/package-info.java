/** Shapes in the coordinates of their body. */
package org.jbox2d.collision.shapes;
