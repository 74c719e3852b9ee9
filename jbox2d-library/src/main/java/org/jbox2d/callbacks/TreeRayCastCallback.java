package org.jbox2d.callbacks;

import org.jbox2d.collision.RayCastInput;

/** Hears of the nodes of a dynamic tree whose boxes a ray meets. */
public interface TreeRayCastCallback {

  /**
   * The ray meets a box.
   *
   * @param input the ray as it has been clipped so far; read it only during the call
   * @param nodeId the node
   * @return 0 to end the ray cast, a positive fraction to clip the ray there, a negative number to
   *     ignore the node
   */
  float raycastCallback(RayCastInput input, int nodeId);
}
