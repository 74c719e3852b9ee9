/** Files that window and headless runner write: figures and animations. */
package org.jbox2d.testbed.export;
