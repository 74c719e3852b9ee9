/** The adapter for JBox2D's API. Its classes are loaded once for each engine that has that API. */
package org.jbox2d.benchmarks.accuracy.box2d;
