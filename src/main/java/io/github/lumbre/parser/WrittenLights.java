package io.github.lumbre.parser;

import com.google.gson.JsonObject;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.SpotLight;
import io.github.lumbre.light.internal.Directions;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.internal.SceneNode;

/** Writes lights without surfaces. */
record WrittenLights(WrittenTextures textures) {
  JsonObject light(SceneNode.Lamp lamp) {
    JsonObject object = WrittenObjects.object("Light", "");
    if (!lamp.lightGroup().isEmpty()) {
      object.addProperty("lightGroup", lamp.lightGroup());
    }
    Light light = lamp.light();
    if (light instanceof PointLight point) {
      object.addProperty("lightType", "Point");
      point(object, point);
      WrittenObjects.place(object, Transform.translation(point.position()));
    } else if (light instanceof DirectionalLight distant) {
      object.addProperty("lightType", "Directional");
      strength(object, distant.irradiance());
      WrittenObjects.matrix(object, Directions.pointing(Vec3.ZERO, distant.direction()));
    } else if (light instanceof SpotLight spot) {
      object.addProperty("lightType", "Spot");
      point(object, spot.source());
      object.addProperty("spotAngle", spot.halfAngleDegrees());
      object.addProperty("penumbra", spot.penumbraDegrees());
      WrittenObjects.matrix(object, Directions.pointing(spot.source().position(), spot.axis()));
    } else if (light instanceof EnvironmentLight sky) {
      object.addProperty("lightType", "Dome");
      sky(object, sky);
    } else if (light.isDelta()) {
      throw new Unwritable("a light without a profile", "the profile of a lamp");
    } else {
      throw new Unwritable("addAreaLight for an area light", "add(Light)");
    }
    return object;
  }

  static JsonObject ambient(Rgb irradiance) {
    JsonObject object = WrittenObjects.object("Light", "");
    object.addProperty("lightType", "Ambient");
    strength(object, irradiance);
    return object;
  }

  private static void strength(JsonObject to, Rgb color) {
    to.addProperty("intensity", 1);
    to.add("color", Written.color(color));
  }

  private static void point(JsonObject to, PointLight point) {
    strength(to, point.intensity());
    to.addProperty("falloff", point.falloff() == Falloff.NONE ? "none" : "inverseSquare");
  }

  private void sky(JsonObject to, EnvironmentLight sky) {
    if (sky.grid().isEmpty()) {
      strength(to, sky.radiance().at(0, 0));
      return;
    }
    if (sky.choiceShare() != 1) {
      throw new Unwritable("an environment light without besideSun", "one with it");
    }
    strength(to, textures.sky(to, sky.radiance()));
    WrittenObjects.matrix(to, Transform.ofFrame(sky.axes(), Vec3.ZERO));
  }
}
