/** What a program implements to hear from a world, or to draw it. */
package org.jbox2d.callbacks;
