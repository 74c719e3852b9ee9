/** The materials that come with the library. */
package org.jbox2d.fracture.materials;
