// cannon-es: particles of the exported masses, a distance constraint for every exported spring.
// E, nu and D map to nothing: it has no material for cloth, so constraints are made as stiff as
// its solver allows (1e12 N/m), and there is no bending. Vertices outside the sheet are not used.
// Mass damping c: linearDamping is the share of velocity lost in a second, 1 - exp(-c).
// A ball is larger by h/2, for particles have no size.
import * as cannon from 'cannon-es';
import { drive, versionOf } from '../lib.mjs';

const STIFF = 1e12; // N/m, a multiplier's ceiling of its solver rather than a law

const SHEET = 1, BALL = 2; // groups of what may touch: sheet and ball do

function addBall(world, { x, radius, friction }, h) {
  world.addBody(new cannon.Body({ mass: 0, shape: new cannon.Sphere(radius + h / 2),
    position: new cannon.Vec3(...x), collisionFilterGroup: BALL, collisionFilterMask: SHEET }));
  world.defaultContactMaterial.friction = friction;
  world.defaultContactMaterial.restitution = 0;
}

await drive((scene, set) => {
  const world = new cannon.World({ gravity: new cannon.Vec3(...scene.gravity) });
  world.solver.iterations = set.iterations;
  world.solver.tolerance = 0;
  const bodies = scene.x.slice(0, scene.count).map((x, v) => new cannon.Body({
    mass: scene.held.has(v) ? 0 : scene.mass[v], shape: new cannon.Particle(),
    position: new cannon.Vec3(...x), collisionFilterGroup: SHEET,
    collisionFilterMask: scene.ball ? BALL : 0, linearDamping: 1 - Math.exp(-scene.damping) }));
  bodies.forEach((b) => world.addBody(b));
  for (const { a, b } of scene.springs)
    if (!scene.held.has(a) || !scene.held.has(b))
      world.addConstraint(new cannon.DistanceConstraint(bodies[a], bodies[b], undefined, STIFF));
  if (scene.ball) addBall(world, scene.ball, scene.h);
  return { version: versionOf('cannon-es'), step: () => world.step(set.step),
    position: (v) => bodies[v].position.toArray() };
});
