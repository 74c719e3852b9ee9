/** Arrays handed out by length; kept for source compatibility. */
package org.jbox2d.pooling.arrays;
