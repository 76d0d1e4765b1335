// The smallest case of README.md: a free square of N x N cells is bent by hand, w = k x^2 / 2, and
// the work of MuJoCo's own forces on it, -F.w / 2 for so small a w, is held against the plate's,
// D k^2 / 2 a unit of area, D = E h^3 / (12 (1 - nu^2)). Nothing moves and nothing is held.
//   node bending.mjs         from build/peers/mujoco, after `peers/run mujoco`
import { fileURLToPath } from 'node:url';
import load from '@mujoco/mujoco';

const m = await load({ locateFile: (file) =>
  fileURLToPath(new URL(`../node_modules/@mujoco/mujoco/${file}`, import.meta.url)) });
const E = 1e5, h = 1e-3, curvature = 1e-2;
const shapes = { 'cylinder, x^2': (x, y) => x * x, 'saddle, x^2 - y^2': (x, y) => x * x - y * y,
  'twist, 2 x y': (x, y) => 2 * x * y };

function ratio(n, nu, shape) {
  const model = m.MjModel.from_xml_string(`<mujoco><option gravity="0 0 0" integrator="discrete"/>
    <worldbody><flexcomp name="sheet" type="grid" dim="2" count="${n + 1} ${n + 1} 1"
      spacing="${1 / n} ${1 / n} 1" radius="${h / 2}" mass="1">
      <elasticity young="${E}" poisson="${nu}" thickness="${h}" damping="0" elastic2d="bend"/>
      <contact selfcollide="none" internal="false" contype="0" conaffinity="0"/>
    </flexcomp></worldbody></mujoco>`);
  const data = new m.MjData(model);
  m.mj_forward(model, data);
  const rest = Array.from(data.flexvert_xpos);
  const w = Array.from({ length: rest.length / 3 }, (_, v) =>
    curvature / 2 * shape(rest[3 * v], rest[3 * v + 1]));
  w.forEach((z, v) => { data.qpos[3 * v + 2] = z; }); // a slide of its own in x, y and z each
  m.mj_forward(model, data);
  const work = w.reduce((sum, z, v) => sum - data.qfrc_passive[3 * v + 2] * z / 2, 0);
  model.delete(); data.delete();
  // |w_xx|^2 + |w_yy|^2 + 2 nu w_xx w_yy + 2 (1 - nu) w_xy^2 of w = k shape / 2, over k^2
  const [xx, yy, xy] = [[1, 0, 0], [1, -1, 0], [0, 0, 1]][Object.values(shapes).indexOf(shape)];
  const plate = E * h ** 3 / 12 / (1 - nu * nu) * curvature ** 2 / 2 *
    (xx * xx + yy * yy + 2 * nu * xx * yy + 2 * (1 - nu) * xy * xy);
  return work / plate;
}

console.log(`MuJoCo ${m.mj_versionString()}: work over the plate's`);
for (const [name, shape] of Object.entries(shapes))
  for (const nu of [0, 0.3, 0.49])
    console.log(`${name.padEnd(18)} nu ${nu.toFixed(2)}  ` + [8, 16, 32].map((n) =>
      `N ${n}: ${ratio(n, nu, shape).toFixed(3)}`).join('  '));
