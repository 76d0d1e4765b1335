// What the drivers in JavaScript share: reading a folder of `clothbench export`, stepping,
// writing frames. A driver is run as
//   node NAME/drive.mjs FOLDER FRAMES.csv step=0.005 until=0.5 [KEY=VALUE]...
// and prints a line of JSON, {"version", "seconds"}; seconds are the processor's, of
// stepping alone.
import { readFileSync, writeFileSync } from 'node:fs';

const sub = (a, b) => a.map((c, i) => c - b[i]);
const dot = (a, b) => a.reduce((sum, c, i) => sum + c * b[i], 0);

function rows(path) {
  const [head, ...lines] = readFileSync(path, 'utf8').trim().split('\n').map((l) => l.split(','));
  return lines.map((line) => Object.fromEntries(line.map((cell, i) => [head[i], cell])));
}

const place = (row) => [row.x, row.y, row.z].map(Number);

// Triangles of the sheet, and those between vertices outside of it and the held row beside, whose
// cells have the diagonal (+u,+v).
function readTriangles(folder, held, uv) {
  const faces = readFileSync(`${folder}/rest.obj`, 'utf8').split('\n')
    .filter((line) => line.startsWith('f '))
    .map((line) => line.slice(2).split(' ').map((corner) => parseInt(corner) - 1));
  const outside = new Map(held.filter((r) => r.beside).map((r) => [+r.beside, +r.vertex]));
  const clamp = [];
  for (const [a, b, c] of faces)
    for (const [p, q] of [[a, b], [b, c], [c, a]])
      if (outside.has(p) && outside.has(q)) {
        const [s, t] = [outside.get(p), outside.get(q)];
        clamp.push(...(uv[p][0] === uv[q][0] ? [[q, p, t], [p, s, t]] : [[q, p, s], [q, s, t]]));
      }
  return [faces, clamp];
}

// Where two triangles meet: edge a b, corners c and d off it, k of k theta^2 / 2, and the inverse
// mass of theta, sum over vertices of |d theta / d x|^2 / m, of the flat sheet.
function findHinges(triangles, x, inverseMass, D) {
  const met = new Map(), hinges = [];
  for (const t of triangles)
    for (const i of [0, 1, 2]) {
      const [a, b, c] = [t[i], t[(i + 1) % 3], t[(i + 2) % 3]];
      const other = met.get(`${b},${a}`);
      if (other === undefined) { met.set(`${a},${b}`, c); continue; }
      const e = sub(x[b], x[a]), e2 = dot(e, e);
      const side = (v) => {
        const w = sub(x[v], x[a]), s = dot(w, e) / e2;
        return { s, height: Math.sqrt(Math.max(0, dot(w, w) - s * s * e2)) };
      };
      const [p, q] = [side(c), side(other)];
      const slopes = [[a, (1 - p.s) / p.height + (1 - q.s) / q.height],
        [b, p.s / p.height + q.s / q.height], [c, 1 / p.height], [other, 1 / q.height]];
      hinges.push({ a, b, c, d: other,
        stiffness: D * e2 / (Math.sqrt(e2) * (p.height + q.height) / 2),
        inverseMass: slopes.reduce((sum, [v, g]) => sum + g * g * inverseMass[v], 0) });
    }
  return hinges;
}

// Vertices from `count` on are those outside the sheet; a held vertex has inverse mass 0.
export function readScene(folder) {
  const rest = rows(`${folder}/rest.csv`), held = rows(`${folder}/held.csv`);
  const material = rows(`${folder}/materials.csv`), times = rows(`${folder}/times.csv`);
  const value = (name) => Number(material.find((r) => r.quantity === name).value);
  const yaml = readFileSync(`${folder}/scene.yaml`, 'utf8');
  const scene = { count: rest.length, E: value('E'), nu: value('nu'), rho: value('rho'),
    h: value('h'), D: value('D'),
    gravity: JSON.parse(yaml.match(/^gravity: (.*)$/m)[1]),
    uv: rest.map((r) => [r.u, r.v]), columns: new Set(rest.map((r) => r.u)).size,
    x: rest.map(place),
    mass: material.filter((r) => r.quantity === 'mass').map((r) => +r.value),
    springs: material.filter((r) => r.quantity.startsWith('spring')).map((r) => (
      { a: +r.a, b: +r.b, stiffness: +r.value, length: +r.rest_length })),
    times: times.filter((r) => r.what === 'truth').map((r) => +r.time) };
  for (const r of held.filter((row) => row.beside)) { scene.x.push(place(r)); scene.mass.push(0); }
  scene.held = new Set(held.map((r) => +r.vertex));
  scene.inverseMass = scene.mass.map((m, v) => (scene.held.has(v) ? 0 : 1 / m));
  const [faces, clamp] = readTriangles(folder, held, scene.uv);
  scene.clamp = clamp;
  scene.triangles = faces.concat(clamp);
  scene.hinges = findHinges(scene.triangles, scene.x, scene.inverseMass, scene.D);
  return scene;
}

// make(scene, set) gives { version, step(), position(vertex) }; set has the words KEY=VALUE.
export async function drive(make) {
  const [folder, out, ...words] = process.argv.slice(2);
  const set = Object.fromEntries(words.map((w) => w.split('=')));
  for (const key of ['step', 'until', 'iterations']) if (key in set) set[key] = Number(set[key]);
  const scene = readScene(folder), simulator = await make(scene, set);
  let text = 't,u,v,x,y,z\n', done = 0, seconds = 0;
  for (const t of scene.times.filter((time) => time <= set.until + 1e-9)) {
    const steps = Math.round(t / set.step);
    if (Math.abs(steps * set.step - t) > 1e-9) throw new Error(`steps of ${set.step} s miss ${t} s`);
    const start = process.cpuUsage();
    for (; done < steps; done++) simulator.step();
    const used = process.cpuUsage(start);
    seconds += (used.user + used.system) / 1e6;
    for (let v = 0; v < scene.count; v++)
      text += [t, ...scene.uv[v], ...simulator.position(v)].join() + '\n';
  }
  writeFileSync(out, text);
  console.log(JSON.stringify({ version: simulator.version, seconds }));
}
