/** The default pool. */
package org.jbox2d.pooling.normal;
