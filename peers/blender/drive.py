"""Blender's cloth modifier (Debian blender), without a window:
    blender -b --factory-startup --python-exit-code 1 -P drive.py -- FOLDER FRAMES step=... substeps=10

It counts time in frames of 1/sqrt(1000) s whatever the scene's frames a second (its gravity is
multiplied by 0.001), and its numbers turn into forces so:
    tension, compression and shear   k = stiffness / mean length of all springs
    bending (angular)                k = 0.1 stiffness x length of the edge
so stiffnesses are those that make k the exported spring (warp's and weft's mean), and D for bending
(a fabric's isotropic mean's): its bending force has no lever arm, which no number makes good on every net. All vertices weigh the same, those of the
rim too: the exported mass of one inside. Vertices outside the sheet are pinned: a clamp. Mass
damping is its air damping, a force of 0.01 air_damping times velocity. A ball is a mesh of quads;
contact is at its least distance, 1 mm, where h/2 is less.
"""
import math
import pathlib
import sys
import time

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import scene as export  # noqa: E402

FRAME = math.sqrt(1e-3)  # s
MASS = 0.3               # of a vertex in Blender's presets; the unit of mass is free
AIR_MOST = 10            # of air_damping
RINGS = 64               # of a ball's mesh; twice as many segments


def quads(scene):
    """Cells of the net, and those between the held row and the vertices outside."""
    n, m = scene.columns, scene.count // scene.columns
    cells = [(j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i)
             for j in range(m - 1) for i in range(n - 1)]
    outside = {vertex: beyond for beyond, vertex in scene.beside.items()}
    clamp = [(a, outside[a], outside[b], b) for a in outside for b in (a + 1, a + n)
             if b in outside and (b == a + n or b % n)]
    return cells + clamp


def make_sheet(scene):
    mesh = bpy.data.meshes.new("sheet")
    mesh.from_pydata([tuple(x) for x in scene.x], [], quads(scene))
    sheet = bpy.data.objects.new("sheet", mesh)
    bpy.context.scene.collection.objects.link(sheet)
    if scene.held:
        sheet.vertex_groups.new(name="held").add(sorted(scene.held), 1, "REPLACE")
    return sheet


def set_cloth(scene, cloth, settings):
    s = cloth.settings
    s.quality = int(settings["substeps"])
    s.time_scale = settings["step"] / FRAME
    if scene.held:
        s.vertex_group_mass, s.pin_stiffness = "held", 1
    s.tension_damping = s.compression_damping = 0
    s.shear_damping = s.bending_damping = 0
    drag = scene.damping * FRAME / 0.01  # of a unit of mass
    s.mass = min(MASS, AIR_MOST / drag) if drag else MASS
    s.air_damping = drag * s.mass
    unit = s.mass / max(scene.mass) * FRAME ** 2
    lengths = [length for _, _, _, length, _ in scene.springs]
    mean = sum(lengths) / len(lengths)
    s.tension_stiffness = s.compression_stiffness = scene.stretch * mean * unit
    s.shear_stiffness = scene.shear * mean * unit
    s.bending_model = "ANGULAR"
    s.bending_stiffness = scene.D / (0.1 * min(lengths)) * unit
    c = cloth.collision_settings
    c.use_collision = bool(scene.ball)
    c.use_self_collision = False
    c.distance_min = scene.h / 2


def make_ball(x, y, z, radius, friction):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=2 * RINGS, ring_count=RINGS, radius=radius,
                                         location=(x, y, z))
    ball = bpy.context.object
    ball.modifiers.new("collision", "COLLISION")
    ball.collision.cloth_friction = friction
    ball.collision.thickness_outer = 1e-3  # its least


def main():
    scene, out, settings = export.words(sys.argv[sys.argv.index("--") + 1:])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    world, step = bpy.context.scene, settings["step"]
    world.gravity = scene.gravity
    sheet = make_sheet(scene)
    cloth = sheet.modifiers.new("cloth", "CLOTH")
    set_cloth(scene, cloth, settings)
    for ball in scene.ball:
        make_ball(*ball)
    wanted = {round(t / step): t for t in scene.times}
    for range_of in world, cloth.point_cache:
        range_of.frame_start, range_of.frame_end = 1, max(wanted) + 1
    frames, seconds, died = {}, 0, {}
    for k in range(max(wanted) + 1):
        start = time.process_time()
        world.frame_set(k + 1)
        moved = sheet.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices
        seconds += time.process_time() - start
        x = [tuple(v.co) for v in moved[:scene.count]]
        if export.is_lost(scene, k * step, x):
            died = {"died": k * step}
            break
        if k in wanted:
            frames[wanted[k]] = x
    export.finish(out, frames, bpy.app.version_string, seconds, **died)


if __name__ == "__main__":
    main()
