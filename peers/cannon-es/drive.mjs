// cannon-es: particles of the exported masses, a distance constraint for every exported spring.
// E, nu and D map to nothing: it has no material for cloth, so constraints are made as stiff as
// its solver allows (1e12 N/m), and there is no bending. Vertices outside the sheet are not used.
import { readFileSync } from 'node:fs';
import * as cannon from 'cannon-es';
import { drive } from '../lib.mjs';

const STIFF = 1e12; // N/m, a multiplier's ceiling of its solver rather than a law

await drive((scene, set) => {
  const world = new cannon.World({ gravity: new cannon.Vec3(...scene.gravity) });
  world.solver.iterations = set.iterations;
  world.solver.tolerance = 0;
  const bodies = scene.x.slice(0, scene.count).map((x, v) => new cannon.Body({
    mass: scene.held.has(v) ? 0 : scene.mass[v], shape: new cannon.Particle(),
    position: new cannon.Vec3(...x), linearDamping: 0, collisionFilterMask: 0 }));
  bodies.forEach((b) => world.addBody(b));
  for (const { a, b } of scene.springs)
    if (!scene.held.has(a) || !scene.held.has(b))
      world.addConstraint(new cannon.DistanceConstraint(bodies[a], bodies[b], undefined, STIFF));
  const { version } = JSON.parse(readFileSync(
    new URL('../node_modules/cannon-es/package.json', import.meta.url)));
  return { version, step: () => world.step(set.step),
    position: (v) => bodies[v].position.toArray() };
});
