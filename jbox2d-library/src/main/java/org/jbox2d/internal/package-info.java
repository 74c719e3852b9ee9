/** Growable primitive collections of the engine. Not exported: free to change. */
package org.jbox2d.internal;
