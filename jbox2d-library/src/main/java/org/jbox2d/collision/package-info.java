/** Manifolds, boxes, rays, distance and time of impact of shapes. */
package org.jbox2d.collision;
