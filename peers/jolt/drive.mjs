// Jolt Physics (WebAssembly, positions in single precision): its soft body is XPBD, a step split
// into `iterations` substeps. Its compliance is 1/k [m/N] of the exported springs; with bend=yes
// every pair of triangles is a dihedral of 1/k [1/(N m)], k of the exported hinges, the pairs
// about the held edge with those outside the sheet among them: a clamp.
// Mass damping is its mLinearDamping [1/s]; vertices are balls of radius h/2 against a ball.
import initJolt from 'jolt-physics';
import { drive, versionOf } from '../lib.mjs';

const J = await initJolt();

function makeWorld(gravity) {
  const s = new J.JoltSettings(), pairs = new J.ObjectLayerPairFilterTable(1);
  const layers = new J.BroadPhaseLayerInterfaceTable(1, 1);
  pairs.EnableCollision(0, 0);
  layers.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
  s.mObjectLayerPairFilter = pairs;
  s.mBroadPhaseLayerInterface = layers;
  s.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
  const world = new J.JoltInterface(s);
  world.GetPhysicsSystem().SetGravity(new J.Vec3(...gravity));
  return world;
}

function addBall(bodies, { x, radius, friction }) {
  const make = new J.BodyCreationSettings(new J.SphereShape(radius), new J.RVec3(...x),
    new J.Quat(0, 0, 0, 1), J.EMotionType_Static, 0);
  make.mFriction = friction;
  bodies.AddBody(bodies.CreateBody(make).GetID(), J.EActivation_DontActivate);
}

function makeSheet(scene, bend) {
  const sheet = new J.SoftBodySharedSettings();
  scene.x.forEach((x, i) => {
    const v = new J.SoftBodySharedSettingsVertex();
    v.mPosition = new J.Float3(...x);
    v.mVelocity = new J.Float3(0, 0, 0);
    v.mInvMass = scene.inverseMass[i];
    sheet.mVertices.push_back(v);
  });
  for (const { a, b, stiffness } of scene.springs)
    sheet.mEdgeConstraints.push_back(new J.SoftBodySharedSettingsEdge(a, b, 1 / stiffness));
  for (const [a, b, c] of scene.triangles)
    sheet.AddFace(new J.SoftBodySharedSettingsFace(a, b, c, 0));
  for (const { a, b, c, d, stiffness } of bend ? scene.hinges : [])
    sheet.mDihedralBendConstraints.push_back(
      new J.SoftBodySharedSettingsDihedralBend(a, b, c, d, 1 / stiffness));
  sheet.CalculateEdgeLengths();
  if (bend) sheet.CalculateBendConstraintConstants();
  sheet.Optimize();
  return sheet;
}

await drive((scene, set) => {
  const world = makeWorld(scene.gravity);
  const make = new J.SoftBodyCreationSettings(makeSheet(scene, set.bend === 'yes'),
    new J.RVec3(0, 0, 0), new J.Quat(0, 0, 0, 1), 0);
  make.mNumIterations = set.iterations;
  make.mLinearDamping = scene.damping;
  make.mVertexRadius = scene.h / 2;
  make.mFriction = scene.ball?.friction ?? 0; // of a pair: the root of both
  make.mUpdatePosition = false; // vertices stay where the world has them
  make.mAllowSleeping = false;
  make.mMaxLinearVelocity = 1e6;
  const bodies = world.GetPhysicsSystem().GetBodyInterface(), body = bodies.CreateSoftBody(make);
  if (scene.ball) addBall(bodies, scene.ball);
  bodies.AddBody(body.GetID(), J.EActivation_Activate);
  const motion = J.castObject(body.GetMotionProperties(), J.SoftBodyMotionProperties);
  return { version: versionOf('jolt-physics'), step: () => world.Step(set.step, 1),
    position: (v) => {
      const p = motion.GetVertex(v).mPosition;
      return [p.GetX(), p.GetY(), p.GetZ()];
    } };
});
