"""The Open Dynamics Engine (Debian: libode8), springs as soft joints: ode.py FOLDER N SCENE..."""
import ctypes
import sys
import clothbench

P, D, STEP = ctypes.c_void_p, ctypes.c_double, 0.005  # s
ode = ctypes.CDLL("libode.so.8")
for call in ode.dWorldCreate, ode.dBodyCreate, ode.dJointCreateDBall:
    call.restype = P
ode.dBodyGetPosition.restype = ctypes.POINTER(D)

def run(scene):
    world, mass = P(ode.dWorldCreate()), (D * 17)()
    ode.dWorldSetGravity(world, *map(D, scene.gravity))
    ode.dWorldSetLinearDamping(world, D(STEP * scene.damping.get("value", 0)))
    bodies = [P(ode.dBodyCreate(world)) for _ in scene.mass]
    for v, body in enumerate(bodies):
        ode.dMassSetSphereTotal(mass, D(scene.mass[v]), D(0.01))
        ode.dBodySetMass(body, mass)
        ode.dBodySetPosition(body, *map(D, scene.x[v]))
        if v in scene.held:
            ode.dBodySetKinematic(body)
    for a, b, stiffness, _ in scene.springs:
        joint = P(ode.dJointCreateDBall(world, None))
        ode.dJointAttach(joint, bodies[a], bodies[b])  # as long as the two are apart
        ode.dJointSetDBallParam(joint, 13, D(1))  # ERP: with CFM a spring by implicit Euler
        ode.dJointSetDBallParam(joint, 8, D(1 / (STEP * stiffness)))  # CFM
    for k in range(1, round(scene.times[-1] / STEP) + 1):
        ode.dWorldStep(world, D(STEP))
        yield k * STEP, [ode.dBodyGetPosition(body)[:3] for body in bodies]

ode.dInitODE()
folder, n, *names = sys.argv[1:]
for name in names:
    t, xyz = zip(*run(scene := clothbench.export(name, n, n)))
    clothbench.frames.write(f"{folder}/{name}/{n}x{n}.npz", t, scene.uv, xyz)
print(clothbench.run("score", "--protocol", folder))
