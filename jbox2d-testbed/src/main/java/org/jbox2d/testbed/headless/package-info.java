/** Runs a scene without a window and writes figures and pictures of it. */
package org.jbox2d.testbed.headless;
