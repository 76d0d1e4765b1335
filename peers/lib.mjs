// What the drivers in JavaScript share: the scene that scene.py wrote, stepping, writing frames.
//   node NAME/drive.mjs FOLDER FRAMES step=0.005 [until=0.5] [KEY=VALUE]...
// How it is run, what it prints and what its frames are: scene.py. Seconds are of stepping alone.
import { readFileSync, writeFileSync } from 'node:fs';

// Vertices from `count` on are those outside the sheet; a held vertex has inverse mass 0.
export function readScene(folder) {
  const list = Object.fromEntries(readFileSync(`${folder}/plain.txt`, 'utf8').trim().split('\n')
    .map((line) => line.split(' ')).map(([name, ...numbers]) => [name, numbers.map(Number)]));
  const rows = (name, width) => Array.from({ length: list[name].length / width },
    (_, i) => list[name].slice(width * i, width * (i + 1)));
  const scene = { x: rows('x', 3), times: list.times, gravity: list.gravity, mass: list.mass,
    reach: list.reach, held: new Set(list.held), clamp: rows('clamp', 3),
    ball: rows('ball', 5).map(([x, y, z, radius, friction]) => ({ x: [x, y, z], radius, friction }))[0],
    springs: rows('springs', 5).map(([a, b, stiffness, length]) => ({ a, b, stiffness, length })),
    hinges: rows('hinges', 6).map(([a, b, c, d, stiffness, inverseMass]) => (
      { a, b, c, d, stiffness, inverseMass })) };
  for (const name of ['E', 'nu', 'h', 'count', 'columns', 'damping'])
    [scene[name]] = list[name];
  scene.triangles = rows('faces', 3).concat(scene.clamp);
  scene.inverseMass = scene.mass.map((m, v) => (scene.held.has(v) ? 0 : 1 / m));
  return scene;
}

export function versionOf(name) {
  return JSON.parse(readFileSync(new URL(`node_modules/${name}/package.json`, import.meta.url))).version;
}

// Whether a vertex is not finite, or further off than it can have come.
function isLost(scene, t, simulator) {
  const far = scene.reach[0] + scene.reach[1] * t * t;
  for (let v = 0; v < scene.count; v++) {
    const x = simulator.position(v);
    if (!(Math.hypot(...scene.x[v].map((c, i) => x[i] - c)) <= far)) return true;
  }
  return false;
}

// make(scene, set) gives { version, step(), position(vertex) }; set has the words KEY=VALUE.
export async function drive(make) {
  const [folder, out, ...words] = process.argv.slice(2);
  const set = Object.fromEntries(words.map((w) => w.split('=')));
  for (const key of ['step', 'until', 'iterations']) if (key in set) set[key] = Number(set[key]);
  const scene = readScene(folder), simulator = await make(scene, set);
  let text = '', done = 0;
  const told = { version: simulator.version, seconds: 0 };
  for (const t of scene.times.filter((time) => !(time > set.until + 1e-9))) {
    const steps = Math.round(t / set.step);
    if (Math.abs(steps * set.step - t) > 1e-9) throw new Error(`steps of ${set.step} s miss ${t} s`);
    for (; done < steps && !told.died; done++) {
      const start = process.cpuUsage();
      simulator.step();
      const used = process.cpuUsage(start);
      told.seconds += (used.user + used.system) / 1e6;
      if (isLost(scene, (done + 1) * set.step, simulator)) told.died = (done + 1) * set.step;
    }
    if (told.died) break;
    text += t;
    for (let v = 0; v < scene.count; v++) text += ' ' + Array.from(simulator.position(v)).join(' ');
    text += '\n';
  }
  writeFileSync(out, text);
  console.log(JSON.stringify(told));
}
