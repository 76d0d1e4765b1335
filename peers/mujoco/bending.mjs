// The smallest cases of README.md. Nothing is held, and nothing moves but by hand.
//   node bending.mjs         from build/peers/mujoco, after `peers/run mujoco`
import { fileURLToPath } from 'node:url';
import load from '@mujoco/mujoco';

const m = await load({ locateFile: (file) =>
  fileURLToPath(new URL(`../node_modules/@mujoco/mujoco/${file}`, import.meta.url)) });
const E = 1e5;

function compile(mesh, nu, h, elastic = 'bend') {
  const model = m.MjModel.from_xml_string(`<mujoco>
    <option gravity="0 0 0" integrator="discrete"/><worldbody>
    <flexcomp name="sheet" dim="2" radius="${h / 2}" mass="1" ${mesh}>
      <elasticity young="${E}" poisson="${nu}" thickness="${h}" damping="0" elastic2d="${elastic}"/>
      <contact selfcollide="none" internal="false" contype="0" conaffinity="0"/>
    </flexcomp></worldbody></mujoco>`);
  const data = new m.MjData(model);
  m.mj_forward(model, data);
  return [model, data];
}

// A square of N x N cells is bent to w = k shape / 2, and the work of MuJoCo's own forces on it,
// -F.w / 2 for so small a w, is held against a plate's, D = E h^3 / (12 (1 - nu^2)).
const SHAPES = [['cylinder, x^2', (x) => x * x, 1, 0, 0],
  ['saddle, x^2 - y^2', (x, y) => x * x - y * y, 1, -1, 0], ['saddle, 2 x y', (x, y) => 2 * x * y, 0, 0, 1]];

function ratio(n, nu, [, shape, xx, yy, xy]) {
  const h = 1e-3, curvature = 1e-2;
  const [model, data] = compile(
    `type="grid" count="${n + 1} ${n + 1} 1" spacing="${1 / n} ${1 / n} 1"`, nu, h);
  const rest = Array.from(data.flexvert_xpos);
  const w = Array.from({ length: rest.length / 3 }, (_, v) =>
    curvature / 2 * shape(rest[3 * v], rest[3 * v + 1]));
  w.forEach((z, v) => { data.qpos[3 * v + 2] = z; }); // a slide of its own in x, y and z each
  m.mj_forward(model, data);
  const work = w.reduce((sum, z, v) => sum - data.qfrc_passive[3 * v + 2] * z / 2, 0);
  model.delete();
  data.delete();
  const plate = E * h ** 3 / 12 / (1 - nu * nu) * curvature ** 2 / 2 *
    (xx * xx + yy * yy + 2 * nu * xx * yy + 2 * (1 - nu) * xy * xy);
  return work / plate;
}

// The same square stretched by 1e-4 along x: the work of MuJoCo's forces over a plate's at nu = 0,
// E h strain^2 / 2.
function stretched(n, h) {
  const strain = 1e-4;
  const [model, data] = compile(
    `type="grid" count="${n + 1} ${n + 1} 1" spacing="${1 / n} ${1 / n} 1"`, 0, h, 'stretch');
  const u = Array.from({ length: (n + 1) ** 2 }, (_, v) => strain * data.flexvert_xpos[3 * v]);
  u.forEach((x, v) => { data.qpos[3 * v] = x; });
  m.mj_forward(model, data);
  const work = u.reduce((sum, x, v) => sum - data.qfrc_passive[3 * v] * x / 2, 0);
  return work / (E * h * strain ** 2 / 2);
}

// The largest force of bending on 2 x 2 cells of 1 m as they lie, flat and undeformed.
function restForce(alternating, h) {
  const xy = [0, 1, 2].flatMap((j) => [0, 1, 2].map((i) => `${i} ${j} 0`));
  const triangles = [0, 1, 3, 4].flatMap((a, cell) => {
    const [b, c, d] = [a + 1, a + 4, a + 3];
    return alternating && (cell === 1 || cell === 2) ? [a, b, d, b, c, d] : [a, b, c, a, c, d];
  });
  const [, data] = compile(
    `type="direct" point="${xy.join(' ')}" element="${triangles.join(' ')}"`, 0, h);
  return Math.max(...Array.from(data.qfrc_passive, Math.abs));
}

console.log(`MuJoCo ${m.mj_versionString()}: work over a plate's`);
for (const shape of SHAPES)
  for (const nu of [0, 0.3, 0.49])
    console.log(`${shape[0].padEnd(18)} nu ${nu.toFixed(2)}  ` + [8, 16, 32].map((n) =>
      `N ${n}: ${ratio(n, nu, shape).toFixed(3)}`).join('  '));
for (const h of [1e-3, 1e-2])
  console.log(`stretched, nu 0, h ${h}  ` + [2, 8, 32].map((n) =>
    `N ${n}: ${stretched(n, h).toFixed(3)}`).join('  '));
console.log('largest force on flat cells at rest, over E h^3');
for (const h of [0.01, 0.02])
  for (const alternating of [false, true])
    console.log(`h ${h}, diagonals ${alternating ? 'alternate' : 'alike    '}: ` +
      (restForce(alternating, h) / (E * h ** 3)).toPrecision(3));
