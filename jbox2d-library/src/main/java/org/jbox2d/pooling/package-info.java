/**
 * Supplies of temporary objects, kept for source compatibility with JBox2D; the engine itself keeps
 * its memory in flat arrays.
 */
package org.jbox2d.pooling;
