# Converts a STEP file into GLB, with the names and colors of its parts: step.py IN OUT.
# Needs the package cadquery-ocp. Surfaces become triangles with a deviation of a thousandth of the
# size of each part, at most 0.1 mm; z points up in the file, and its unit becomes meters.
import sys

try:
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.Message import Message_ProgressRange
    from OCP.RWGltf import RWGltf_CafWriter
    from OCP.RWMesh import RWMesh_CoordinateSystem
    from OCP.STEPCAFControl import STEPCAFControl_Reader
    from OCP.TCollection import TCollection_AsciiString, TCollection_ExtendedString
    from OCP.TDocStd import TDocStd_Document
    from OCP.XCAFApp import XCAFApp_Application
    from OCP.XCAFDoc import XCAFDoc_DocumentTool
except ImportError as failure:
    install = f"install it by: {sys.executable} -m pip install cadquery-ocp"
    sys.exit(f"needs the package cadquery-ocp ({failure}); {install}")

MOST_DEVIATION = 0.1
RELATIVE_DEVIATION = 1e-3
MOST_ANGLE = 0.3


def named(*names):
    """Returns the first class of the names: the package has moved them between versions."""
    import importlib

    for name in names:
        module, _, attribute = name.rpartition(".")
        try:
            return getattr(importlib.import_module(module), attribute)
        except (ImportError, AttributeError):
            continue
    sys.exit("cadquery-ocp lacks " + names[0])


def read(path):
    document = TDocStd_Document(TCollection_ExtendedString("XmlOcaf"))
    XCAFApp_Application.GetApplication_s().NewDocument(
        TCollection_ExtendedString("MDTV-XCAF"), document
    )
    reader = STEPCAFControl_Reader()
    reader.SetColorMode(True)
    reader.SetNameMode(True)
    if reader.ReadFile(path) != IFSelect_ReturnStatus.IFSelect_RetDone:
        sys.exit("not a STEP file that can be read")
    if not reader.Transfer(document):
        sys.exit("the STEP file has no shape that can be transferred")
    return document


def mesh(document):
    labels = named("OCP.TDF.TDF_LabelSequence", "OCP.OCP.collections.Sequence_TDF_Label")()
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    shapes.GetFreeShapes(labels)
    for i in range(1, labels.Length() + 1):
        shape = shapes.GetShape_s(labels.Value(i))
        box = Bnd_Box()
        BRepBndLib.Add_s(shape, box)
        size = 0 if box.IsVoid() else box.SquareExtent() ** 0.5
        deviation = min(MOST_DEVIATION, max(RELATIVE_DEVIATION * size, 1e-6))
        BRepMesh_IncrementalMesh(shape, deviation, False, MOST_ANGLE, True)


def write(document, path):
    writer = RWGltf_CafWriter(TCollection_AsciiString(path), True)
    converter = writer.ChangeCoordinateSystemConverter()
    converter.SetInputLengthUnit(0.001)
    converter.SetInputCoordinateSystem(RWMesh_CoordinateSystem.RWMesh_CoordinateSystem_Zup)
    info = named(
        "OCP.TColStd.TColStd_IndexedDataMapOfStringString",
        "OCP.OCP.collections.IndexedDataMap_TCollection_AsciiString_TCollection_AsciiString",
    )()
    if not writer.Perform(document, info, Message_ProgressRange()):
        sys.exit("the GLB cannot be written")


if __name__ == "__main__":
    assembly = read(sys.argv[1])
    mesh(assembly)
    write(assembly, sys.argv[2])
