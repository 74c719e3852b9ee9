/** The testbed: scenes, a window that shows them, and a runner that needs no display. */
package org.jbox2d.testbed;
