/** The window: everything of Swing, and the thread on which the simulation runs beside it. */
package org.jbox2d.testbed.ui;
