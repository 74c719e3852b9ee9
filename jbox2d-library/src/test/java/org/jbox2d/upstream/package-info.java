/**
 * JBox2D's own test programs on our classes, and scenes that run on our engine and on the released
 * one side by side.
 */
package org.jbox2d.upstream;
