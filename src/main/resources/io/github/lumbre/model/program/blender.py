# Converts a model into GLB inside Blender: blender --background --python blender.py -- IN OUT.
# Operators of importers have changed their names between versions: the first that exists is used.
import os
import sys

import bpy

IMPORTERS = {
    "fbx": ["wm.fbx_import", "import_scene.fbx"],
    "dae": ["wm.collada_import"],
    "x3d": ["import_scene.x3d"],
    "wrl": ["import_scene.x3d"],
    "obj": ["wm.obj_import", "import_scene.obj"],
    "ply": ["wm.ply_import", "import_mesh.ply"],
    "stl": ["wm.stl_import", "import_mesh.stl"],
    "abc": ["wm.alembic_import"],
    "usd": ["wm.usd_import"],
    "usda": ["wm.usd_import"],
    "usdc": ["wm.usd_import"],
    "usdz": ["wm.usd_import"],
    "glb": ["import_scene.gltf"],
    "gltf": ["import_scene.gltf"],
}


def operator(name):
    """Returns an operator; None if this Blender lacks it."""
    group, _, action = name.partition(".")
    found = getattr(getattr(bpy.ops, group), action)
    try:
        found.get_rna_type()
    except (KeyError, RuntimeError):
        return None
    return found


def order():
    """Orders objects by their names: importers leave them in another order each time."""
    for collection in [bpy.context.scene.collection, *bpy.data.collections]:
        objects = sorted(collection.objects, key=lambda each: each.name)
        for each in objects:
            collection.objects.unlink(each)
        for each in objects:
            collection.objects.link(each)


def load(path):
    ending = os.path.splitext(path)[1][1:].lower()
    if ending == "blend":
        # Scripts in the file do not run.
        bpy.ops.wm.open_mainfile(filepath=path, use_scripts=False)
        return
    for kept in list(bpy.data.objects):
        bpy.data.objects.remove(kept)
    for name in IMPORTERS.get(ending, []):
        importer = operator(name)
        if importer is not None:
            importer(filepath=path)
            order()
            return
    raise ValueError("this Blender has no importer for ." + ending)


def main():
    source, target = sys.argv[sys.argv.index("--") + 1 :]
    load(source)
    bpy.ops.export_scene.gltf(filepath=target, export_format="GLB", export_yup=True)


main()
