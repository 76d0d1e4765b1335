"""Writes scene.usda beside what `clothbench export` left in a folder: the sheet as a surface
deformable of the AOUSD proposal "Deformable Body Physics in USD" (OpenUSD-proposals, pull request
111, at 584939b6), in SI units."""
import math
import pathlib
import re

import numpy

from .exported import Exported

HEAD = """#usda 1.0
(
    defaultPrim = "World"
    metersPerUnit = 1
    kilogramsPerUnit = 1
    upAxis = "Z"
    timeCodesPerSecond = 1
    startTimeCode = 0
    endTimeCode = {end:.9g}
)

def Xform "World"
{{
    def PhysicsScene "Physics"
    {{
        vector3f physics:gravityDirection = {down}
        float physics:gravityMagnitude = {gravity:.9g}
    }}

    def Material "Cloth" (
        prepend apiSchemas = ["PhysicsSurfaceDeformableMaterialAPI"]
    )
    {{
        float physics:density = {rho:.9g}
        float physics:youngsModulus = {E:.9g}
        float physics:poissonsRatio = {nu:.9g}
        float physics:surfaceStretchStiffness = {stretch:.9g}
        float physics:surfaceShearStiffness = {shear:.9g}
        float physics:surfaceBendStiffness = {bend:.9g}
    }}

    def Mesh "Sheet" (
        prepend apiSchemas = ["PhysicsDeformableBodyAPI", "PhysicsSurfaceDeformableSimAPI",
            {collides}"MaterialBindingAPI"]
    )
    {{
        rel material:binding:physics = </World/Cloth>
        uniform token subdivisionScheme = "none"
        float[] physics:thicknesses = [{h:.9g}]
        uniform token physics:thicknesses:elementType = "constant"
        uniform token physics:restBendAnglesDefault = "{bends}"
        int[] faceVertexCounts = [{counts}]
        int[] faceVertexIndices = [{indices}]
        point3f[] points = [{points}]
        texCoord2f[] primvars:st = [{uv}] (interpolation = "vertex")
{velocities}        custom int clothbench:sheetVertices = {sheet}
        custom int[] clothbench:held = [{held}]
        custom token[] clothbench:held:fix = [{fix}]
    }}
"""
BODY = """
    def Xform "Path{path}"
    {{
        double3 xformOp:translate.timeSamples = {{
{samples}        }}
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }}
"""
HELD = """
    def PhysicsAttachment "Held{body}"
    {{
        rel physics:src0 = </World/Sheet>
        rel physics:src1 = </World{slash}{body}>
        uniform token physics:type0 = "point"
        uniform token physics:type1 = "xform"
        int[] physics:indices0 = [{which}]
        vector3f[] physics:coords1 = [{where}]
    }}
"""

def tuple_of(numbers):
    return "(" + ", ".join(f"{value + 0.0:.9g}" for value in numbers) + ")"

def array(words):
    """The elements of an array, eight in a line."""
    words = list(map(str, words))
    return "".join("\n            " + ", ".join(words[n:n + 8]) + ("," if n + 8 < len(words) else "")
                   for n in range(0, len(words), 8))

def clamps(scene):
    """Triangles with vertices outside: of a mesh those of its hinges there, of a grid those of the
    cells between two that stand beside neighbours."""
    if len(scene.hinges):
        seen = {(t[k - 1], t[k]) for t in scene.triangles.tolist() for k in range(3)}
        return numpy.array([(b, a, out) if (a, b) in seen else (a, b, out)
                            for a, b, _, out, _ in scene.hinges.tolist() if out >= len(scene.uv)],
                           dtype=int).reshape(-1, 3)
    step = {}  # (vertex, axis): the next one of the sheet along that axis
    for a, b in numpy.concatenate([scene.triangles[:, [j, k]] for j in range(3) for k in range(3) if j != k]):
        along = scene.uv[b] - scene.uv[a]
        for axis in (0, 1):
            if along[axis] > 1e-9 and abs(along[1 - axis]) < 1e-9:
                step[a, axis] = b
    outside = {}  # (held vertex, axis, whether after it): the vertex outside that stands beside it there
    for vertex, beside in scene.beside.items():
        away = scene.outside_uv[vertex - len(scene.uv)] - scene.uv[beside]
        axis = int(abs(away).argmax())
        outside[beside, axis, away[axis] > 0] = vertex
    made = []
    for (p, axis, after), a in outside.items():
        q = step.get((p, 1 - axis))
        b = outside.get((q, axis, after))
        if b is not None:
            ring = [p, q, b, a] if (axis == 1) == after else [p, a, b, q]
            made += [ring[:3], [p, *ring[2:]]]
    return numpy.array(made, dtype=int).reshape(-1, 3)

def text_of(folder):
    """The file's text, from the folder's other files."""
    folder, scene = pathlib.Path(folder), Exported(folder)
    told, m = (folder / "scene.yaml").read_text(), scene.material
    membrane, pull = m["E"] * m["h"], math.hypot(*scene.gravity)
    corners = numpy.concatenate([scene.triangles, clamps(scene)])
    moving = scene.velocities and scene.velocities + [[0, 0, 0]] * len(scene.beside)
    velocities = f"        vector3f[] velocities = [{array(map(tuple_of, moving))}]\n" if moving else ""
    text = HEAD.format(
        end=scene.end, gravity=pull, down=tuple_of(scene.gravity / (pull or 1)), **m | {
            "stretch": membrane / (1 - m["nu"] ** 2), "shear": membrane / 2 / (1 + m["nu"]),
            "bend": membrane * m["h"] ** 2 / 12 / (1 - m["nu"] ** 2)},
        collides='"PhysicsCollisionAPI", ' * bool(re.search(r"^obstacles:|self: true", told, re.M)),
        bends="restShape" if re.search("^  kind: (?!flat)", told, re.M) else "flat",
        counts=", ".join(["3"] * len(corners)), points=array(map(tuple_of, scene.x)),
        indices=array(", ".join(map(str, c)) for c in corners),
        uv=array(map(tuple_of, [*scene.uv, *scene.outside_uv])), velocities=velocities,
        sheet=len(scene.uv), held=array(scene.held), fix=array(f'"{f}"' for f in scene.held.values()))
    whole = [vertex for vertex, fix in scene.held.items() if fix == "xyz"]
    for path in sorted({scene.path.get(vertex, -1) for vertex in whole}):
        held, body = [v for v in whole if scene.path.get(v, -1) == path], ""
        if path >= 0:
            body = f"Path{path}"
            text += BODY.format(path=path, samples="".join(
                f"            {t:.9g}: {tuple_of(shift)},\n" for t, *shift in scene.paths[path]))
        text += HELD.format(body=body, slash="/" * bool(body), which=array(held),
                            where=array(tuple_of(scene.x[v]) for v in held))
    return text + "}\n"
