// MuJoCo (WebAssembly, double precision): a flex of dimension 2 on the exported vertices, those
// outside the sheet among them: a clamp. Every cell has the same diagonal, as in flexcomp's own
// grid: with alternating ones it has forces at rest (README.md, cut=alternating). E, nu and h are
// its own parameters, so E maps to itself; those of a fabric are its isotropic mean's.
// Mass damping c: dof_damping of c m for each of a vertex's three slides. Friction of a pair is the
// larger; contacts are as soft as they come.
// flexcomp gives all vertices the same mass; the exported ones are set after compiling. Elasticity
// of a flex is refused under the integrators implicit and implicitfast, hence `discrete`.
import { fileURLToPath } from 'node:url';
import load from '@mujoco/mujoco';
import { drive } from '../lib.mjs';

function cutAlike({ columns: n, count }) {
  const cells = Array.from({ length: count - n }, (_, v) => v).filter((v) => (v + 1) % n);
  return cells.flatMap((v) => [[v, v + 1, v + n + 1], [v, v + n + 1, v + n]]);
}

function describe(scene, set) {
  const triangles = set.cut === 'alternating' ? scene.triangles
    : cutAlike(scene).concat(scene.clamp);
  const area = scene.mass.reduce((sum, m) => sum + m, 0);
  const cell = Math.hypot(...scene.x[1].map((c, i) => c - scene.x[0][i]));
  const thin = Math.min(scene.h / 2, cell / 5); // of no account without a ball
  const { ball } = scene;
  return `<mujoco><option timestep="${set.step}" gravity="${scene.gravity.join(' ')}"
    integrator="discrete"/><worldbody>
    ${ball ? `<geom type="sphere" size="${ball.radius}" pos="${ball.x.join(' ')}"
      friction="${ball.friction}"/>` : ''}
    <flexcomp name="sheet" type="direct" dim="2" radius="${thin}" mass="${area}"
      point="${scene.x.flat().join(' ')}" element="${triangles.flat().join(' ')}">
      <elasticity young="${scene.E}" poisson="${scene.nu}"
        thickness="${scene.h}" damping="0" elastic2d="both"/>
      <contact selfcollide="none" internal="false" contype="${+!!ball}" conaffinity="${+!!ball}"
        friction="${ball?.friction ?? 0}"/>
      ${scene.held.size ? `<pin id="${[...scene.held].join(' ')}"/>` : ''}
    </flexcomp></worldbody></mujoco>`;
}

const m = await load({ locateFile: (file) =>
  fileURLToPath(new URL(`../node_modules/@mujoco/mujoco/${file}`, import.meta.url)) });
await drive((scene, set) => {
  const model = m.MjModel.from_xml_string(describe(scene, set)), data = new m.MjData(model);
  for (let v = 0; v < scene.count; v++) {
    const b = model.flex_vertbodyid[v];
    if (!b) continue; // held: the world's
    for (let i = 0; i < 3; i++) model.body_inertia[3 * b + i] *= scene.mass[v] / model.body_mass[b];
    model.body_mass[b] = scene.mass[v];
    for (let i = 0; i < 3; i++)
      model.dof_damping[model.body_dofadr[b] + i] = scene.damping * scene.mass[v];
  }
  let fresh = false;
  m.mj_setConst(model, data);
  m.mj_forward(model, data);
  return { version: m.mj_versionString(),
    step: () => { m.mj_step(model, data); fresh = false; },
    position: (v) => {
      if (!fresh) { m.mj_kinematics(model, data); m.mj_flex?.(model, data); }
      fresh = true;
      return data.flexvert_xpos.slice(3 * v, 3 * v + 3);
    } };
});
