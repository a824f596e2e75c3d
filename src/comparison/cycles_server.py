"""Renders Lumbre's scenes with Cycles (bpy) on command, in one thread: python cycles_server.py FOLDER

Commands and answers are those of RenderServer.java. FOLDER gets pictures. Knows matte surfaces, mirrors, glass and
microfacets with a gray specular colour. Paths have as many bounces as Lumbre's, pixels are boxes, nothing is clamped.
"""

import json
import os
import sys
import time

import bpy
import mathutils
import numpy as np

import plain
from nodes import colour


def image(name, picture):
    """A picture of Blender's with these linear values; rows from the top."""
    height, width = picture.shape[:2]
    result = bpy.data.images.new(name, width, height, float_buffer=True, is_data=True)
    rgba = np.concatenate([picture, np.ones((height, width, 1))], axis=-1)
    result.pixels.foreach_set(rgba[::-1].astype(np.float32).ravel())
    result.pack()
    return result


class Tree:
    """The nodes of a material or of the world."""

    def __init__(self, owner, output):
        owner.use_nodes = True
        self.tree = owner.node_tree
        self.tree.nodes.clear()
        self.output = self.node(output)

    def node(self, kind, **attributes):
        result = self.tree.nodes.new("ShaderNode" + kind)
        for name, value in attributes.items():
            setattr(result, name, value)
        return result

    def link(self, source, target):
        self.tree.links.new(source, target)

    def finish(self, source):
        self.link(source.outputs[0], self.output.inputs["Surface"])


class Converter:
    def __init__(self, path):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.plain = plain.PlainScene(path)
        self.materials = {}
        self.camera()
        self.sky()
        for i, surface in enumerate(self.plain.surfaces):
            self.surface("s%d" % i, surface)

    def camera(self):
        node, view = self.plain.camera, self.plain.view
        kind = node.get("cameraType", "Pinhole")
        if kind not in ("Pinhole", "ThinLens"):
            plain.refuse(node)
        camera = bpy.data.cameras.new("camera")
        camera.sensor_fit, camera.angle_y = "VERTICAL", np.radians(node["fieldOfView"])
        camera.clip_start, camera.clip_end = 1e-3, 1e5
        if kind == "ThinLens":
            camera.dof.use_dof = True
            camera.dof.focus_distance = node["focusDistance"]
            camera.dof.aperture_fstop = camera.lens * 1e-3 / (2 * node["aperture"])
        item = bpy.data.objects.new("camera", camera)
        # Blender's cameras look along -z, so that their x axis turns, too.
        item.matrix_world = mathutils.Matrix((view @ np.diag([-1, 1, -1, 1])).tolist())
        bpy.context.scene.collection.objects.link(item)
        bpy.context.scene.camera = item

    def sky(self):
        environment = self.plain.environment
        if environment is None:
            return
        world = bpy.data.worlds.new("sky")
        bpy.context.scene.world = world
        tree = Tree(world, "OutputWorld")
        background = tree.node("Background")
        if environment.ndim == 1:
            background.inputs["Color"].default_value = [*environment, 1]
        else:
            # Blender's up is z, and the middle of its map a quarter turn away.
            rolled = np.roll(environment, environment.shape[1] // 4, axis=1)
            texture = tree.node("TexEnvironment", image=image("sky", rolled))
            turn = tree.node("Mapping", vector_type="POINT")
            turn.inputs["Rotation"].default_value = [np.pi / 2, 0, 0]
            tree.link(tree.node("TexCoord").outputs["Generated"], turn.inputs["Vector"])
            tree.link(turn.outputs[0], texture.inputs["Vector"])
            tree.link(texture.outputs[0], background.inputs["Color"])
        tree.finish(background)

    def surface(self, name, surface):
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(surface.positions.tolist(), [], surface.triangles.tolist())
        if surface.uv is not None:
            layer = mesh.uv_layers.new(name="uv")
            layer.data.foreach_set("uv", surface.uv[surface.triangles.ravel()].ravel())
        if surface.normals is not None:
            mesh.polygons.foreach_set("use_smooth", [True] * len(surface.triangles))
            mesh.normals_split_custom_set_from_vertices(surface.normals.tolist())
        if surface.radiance is not None:
            mesh.materials.append(self.lamp(name, surface.radiance))
        else:
            mesh.materials.append(self.material(surface.material))
        bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, mesh))

    def lamp(self, name, radiance):
        """Light from the front alone; the back is black."""
        material = bpy.data.materials.new(name)
        tree = Tree(material, "OutputMaterial")
        emission, side = tree.node("Emission"), tree.node("NewGeometry")
        front = tree.node("Math", operation="MULTIPLY_ADD")
        most = max(radiance)
        emission.inputs["Color"].default_value = [*(radiance / most), 1]
        front.inputs[1].default_value, front.inputs[2].default_value = -most, most
        tree.link(side.outputs["Backfacing"], front.inputs[0])
        tree.link(front.outputs[0], emission.inputs["Strength"])
        tree.finish(emission)
        return material

    def material(self, asset):
        if asset["id"] not in self.materials:
            material = bpy.data.materials.new("m%d" % asset["id"])
            self.materials[asset["id"]] = material
            tree = Tree(material, "OutputMaterial")
            tree.finish(self.bsdf(tree, asset))
        return self.materials[asset["id"]]

    def bsdf(self, tree, asset):
        kind = asset["materialType"]
        if kind == "Diffuse":
            result = self.diffuse(tree, asset, None)
        elif kind == "CookTorrance":
            result = self.cook_torrance(tree, asset)
        elif kind == "Reflective":
            result = tree.node("BsdfGlossy")
            result.inputs["Roughness"].default_value = 0
            self.channel(tree, asset, "reflectivityColor", result.inputs["Color"])
        elif kind == "Refractive" and not {"roughness", "refractionColor"} & asset.keys():
            result = tree.node("BsdfGlass")
            result.inputs["Color"].default_value = [1, 1, 1, 1]
            result.inputs["Roughness"].default_value = 0
            result.inputs["IOR"].default_value = asset["ior"]
        else:
            plain.refuse(asset)
        return result

    def diffuse(self, tree, asset, normal):
        result = tree.node("BsdfDiffuse")
        result.inputs["Roughness"].default_value = 0
        self.channel(tree, asset, "color", result.inputs["Color"])
        if normal is not None:
            tree.link(normal, result.inputs["Normal"])
        return result

    def cook_torrance(self, tree, asset):
        """Lambert's reflection plus that of microfacets, which black takes a part of."""
        specular = colour(asset.get("specularColor"))
        if specular.min() != specular.max() or "specularColorTextureId" in asset:
            plain.refuse(asset)
        normal = self.normal(tree, asset)
        facets = tree.node("BsdfMetallic", fresnel_type="PHYSICAL_CONDUCTOR", distribution="BECKMANN")
        if asset.get("distribution", "beckmann") != "beckmann":
            plain.refuse(asset)
        facets.inputs["Roughness"].default_value = asset.get("roughness", 1) ** 0.5
        facets.inputs["IOR"].default_value = [asset.get("ior", 3.0504)] * 3
        facets.inputs["Extinction"].default_value = [0, 0, 0]
        if normal is not None:
            tree.link(normal, facets.inputs["Normal"])
        black = tree.node("BsdfDiffuse")
        black.inputs["Color"].default_value = [0, 0, 0, 1]
        dimmed = tree.node("MixShader")
        dimmed.inputs[0].default_value = specular[0]
        tree.link(black.outputs[0], dimmed.inputs[1])
        tree.link(facets.outputs[0], dimmed.inputs[2])
        result = tree.node("AddShader")
        tree.link(self.diffuse(tree, asset, normal).outputs[0], result.inputs[0])
        tree.link(dimmed.outputs[0], result.inputs[1])
        return result

    def normal(self, tree, asset):
        relief = self.plain.relief(asset)
        if relief is None:
            return None
        texture = tree.node("TexImage", image=image("n%d" % asset["id"], relief), interpolation="Linear")
        bump = tree.node("NormalMap")
        tree.link(texture.outputs[0], bump.inputs["Color"])
        return bump.outputs[0]

    def channel(self, tree, asset, name, target):
        constant, texture = self.plain.channel(asset, name)
        if texture is None:
            target.default_value = [*constant, 1]
            return
        picture, smooth, factors = texture
        node = tree.node("TexImage", image=image("t%d" % asset["id"], picture))
        node.interpolation = "Linear" if smooth else "Closest"
        mapping = tree.node("Mapping", vector_type="POINT")
        mapping.inputs["Scale"].default_value = [*factors, 1]
        tree.link(tree.node("UVMap").outputs[0], mapping.inputs["Vector"])
        tree.link(mapping.outputs[0], node.inputs["Vector"])
        tree.link(node.outputs[0], target)


def set_up(width, height, depth, threads=1):
    """Chooses Cycles and its options; 0 threads for one per processor."""
    render, cycles = bpy.context.scene.render, bpy.context.scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
    if threads:
        render.threads_mode, render.threads = "FIXED", threads
    render.use_persistent_data = True
    render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    bounces = ("max", "diffuse", "glossy", "transmission", "transparent_max")
    for kind in bounces:
        setattr(cycles, kind + "_bounces", depth - 1)
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0


def render(samples, seed, path):
    cycles = bpy.context.scene.cycles
    cycles.samples, cycles.seed = samples, seed
    start = time.process_time()
    bpy.ops.render.render(write_still=False)
    cpu = time.process_time() - start
    if path != "-":
        bpy.data.images["Render Result"].save_render(path + ".exr")
        saved = bpy.data.images.load(path + ".exr", check_existing=False)
        width, height = saved.size
        values = np.empty(width * height * 4, np.float32)
        saved.pixels.foreach_get(values)
        bpy.data.images.remove(saved)
        os.remove(path + ".exr")
        values.reshape(height, width, 4)[::-1, :, :3].astype("<f4").tofile(path)
    return cpu


def main(folder):
    # Blender speaks on standard output.
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    pixels = 0
    for line in sys.stdin:
        words = line.split()
        start = time.perf_counter()
        if words[0] == "load":
            width, height, depth = map(int, words[2:5])
            Converter(words[1])
            set_up(width, height, depth)
            pixels = width * height
            answer = {}
        else:
            samples = int(words[1])
            answer = {"samples": samples * pixels, "cpu": render(samples, int(words[2]), words[4])}
        answer["seconds"] = time.perf_counter() - start
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
