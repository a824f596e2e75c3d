package io.github.lumbre.scenefile.internal;

import java.util.List;

/** The names of the keys by which a camera of a scene file is found and placed. */
public final class CameraKeys {
  public static final String MAIN_CAMERA = "mainCameraId";
  public static final String OBJECTS = "objects";
  public static final String CHILDREN = "children";
  public static final String TYPE = "type";
  public static final String ID = "id";
  public static final String POSITION = "localPosition";
  public static final String ROTATION = "localRotation";
  public static final String SCALE = "localScale";
  public static final String LOOK_AT = "lookAt";
  public static final String LOOK_AT_UP = "lookAtUp";
  public static final String MATRIX = "matrix";

  /** The vertical angle of a perspective camera. */
  public static final String FIELD_OF_VIEW = "fieldOfView";

  /** The height of the film of a parallel camera. */
  public static final String HEIGHT = "height";

  /** The keys that a position and a rotation replace. */
  public static final List<String> OTHER_PLACES = List.of(SCALE, LOOK_AT, LOOK_AT_UP, MATRIX);

  private CameraKeys() {}
}
