// Rapier (WebAssembly, single precision): a soft body of the exported springs and of a dihedral
// for each pair of triangles, those about a clamp among them. Its stiffness is a natural frequency:
// material=own     what it comes with (30 Hz); E maps to nothing
// material=matched f = sqrt(k/m)/(2 pi) of each spring, 1/m = 1/m1 + 1/m2. Hinges can but share a
//                  frequency: that by which the sum of their stiffnesses is the sum of the
//                  k of the exported hinges, of free triangles. The damping ratio, which may not be
//                  nought, is RATIO.
// Mass damping is its linear damping [1/s]. Against a ball the triangles are a surface of particles
// of radius h/2; friction of a pair is the mean of both.
import RAPIER from '@dimforge/rapier3d-compat';
import { drive } from '../lib.mjs';

const RATIO = 1e-3; // of critical damping
const hertz = (stiffness, inverseMass) => Math.sqrt(stiffness * inverseMass) / (2 * Math.PI);
const softness = (frequency) => ({ naturalFrequency: frequency, dampingRatio: RATIO });

await RAPIER.init();
await drive((scene, set) => {
  const [gx, gy, gz] = scene.gravity;
  const world = new RAPIER.World({ x: gx, y: gy, z: gz });
  world.timestep = set.step;
  world.numSolverIterations = set.iterations;
  const w = scene.inverseMass, free = (...all) => all.some((v) => w[v] > 0);
  const springs = scene.springs.filter(({ a, b }) => free(a, b));
  const hinges = scene.hinges.filter(({ a, b, c, d }) => free(a, b, c, d));
  // A vertex outside the sheet is pinned, so its mass is of no account; it must have one.
  const desc = new RAPIER.SoftBodyDesc(scene.x.flat())
    .setEdges(springs.flatMap(({ a, b }) => [a, b]))
    .setDihedrals(hinges.flatMap(({ a, b, c, d }) => [a, b, c, d]))
    .setMasses(scene.mass.map((m) => m || scene.mass[0]))
    .setPinnedParticles([...scene.held])
    .setLinearDamping(scene.damping).setSelfContacts(false).setCanSleep(false);
  const { ball } = scene;
  if (!ball) desc.setNoSurfaceCollider();
  else {
    desc.setSurface(scene.triangles.flat()).setParticleRadius(scene.h / 2)
      .setSurfaceCollider(RAPIER.ColliderDesc.ball(1).setFriction(ball.friction));
    world.createCollider(RAPIER.ColliderDesc.ball(ball.radius).setFriction(ball.friction)
      .setTranslation(...ball.x));
  }
  if (set.material === 'matched') {
    const material = new RAPIER.SoftBodyMaterial();
    const sum = (of) => hinges.reduce((total, k) => total + of(k), 0);
    material.bendSoftness = softness(
      hertz(sum((k) => k.stiffness), 1 / sum((k) => 1 / k.inverseMass)));
    desc.setMaterial(material).setEdgeSoftness(springs.map((_, index) => index),
      springs.map(({ a, b, stiffness }) => softness(hertz(stiffness, w[a] + w[b]))));
  }
  const body = world.createSoftBody(desc);
  let x = body.particlePositions();
  return { version: RAPIER.version(),
    step: () => { world.step(); x = null; },
    position: (v) => {
      x ??= body.particlePositions();
      return [x[3 * v], x[3 * v + 1], x[3 * v + 2]];
    } };
});
