/**
 * From requests to bodies: plans a fracture, as a pure function, and carries it out by replacing
 * the body by its pieces.
 */
package org.jbox2d.fracture.assembly;
