// SPDX-License-Identifier: BSL-1.0
import initialize from '@mujoco/mujoco';

import { not_posed, serve_runs } from './serve_runs.mjs';

const silent = () => {};  // warnings would go to standard output, which carries the protocol
const mujoco = await initialize({ print: silent, printErr: silent });
const hardest = mujoco.mjMAXIMP;  // the impedance of the hardest contact that the engine has
const whole_state = mujoco.mjtState.mjSTATE_INTEGRATION.value;

function rotated([w, x, y, z], [a, b, c]) {
  const t = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * t[0] + y * t[2] - z * t[1], b + w * t[1] + z * t[0] - x * t[2], c + w * t[2] + x * t[1] - y * t[0]];
}

function body_xml({ shape, fixed, mass, principal_inertia, ...body }, i) {
  const place = `pos="${body.position.join(' ')}"`;
  if (shape === 'half_space') {
    return `<geom name="${i}" type="plane" size="0 0 1" zaxis="${body.half_space.join(' ')}" ${place}/>`;
  }
  const size = shape === 'sphere' ? body.sphere : body.box.map((x) => x / 2).join(' ');
  const free = fixed ? '' :
    `<freejoint/><inertial pos="0 0 0" mass="${mass}" diaginertia="${principal_inertia.join(' ')}"/>`;
  const geometry = `<geom name="${i}" type="${shape}" size="${size}"/>`;
  return `<body ${place} quat="${body.orientation.join(' ')}">${free}${geometry}</body>`;
}

// Contacts without stiffness, and with a damping that demands N·V⁺ = −ε N·V⁻ and N × V⁺ = 0 at the end of the step. The
// one-contact adapter says why the impedance is a factor.
function pairs_xml({ friction, restitution, bodies }, step) {
  const laws = `condim="${friction > 0 ? 3 : 1}" friction="${friction} ${friction} 0 0 0"
    solref="0 ${-(1 + restitution) / step}" solreffriction="0 ${-hardest / step}" solimp="${hardest} ${hardest} 0.001 0.5 2"`;
  return bodies.flatMap((a, i) => bodies.slice(0, i).map((b, k) =>
    a.fixed && b.fixed ? '' : `<pair geom1="${k}" geom2="${i}" ${laws}/>`)).join('');
}

function xml(scene, step, configured) {
  const { gravity, friction, bodies } = scene;
  const option = `timestep="${step}" gravity="${gravity.join(' ')}"`;
  return configured
    ? `<mujoco>
        <option ${option} cone="elliptic" impratio="100" integrator="implicit"><flag autoreset="disable"/></option>
        <default><geom contype="0" conaffinity="0"/></default>
        <worldbody>${bodies.map(body_xml).join('')}</worldbody><contact>${pairs_xml(scene, step)}</contact></mujoco>`
    : `<mujoco><option ${option}/><default><geom friction="${friction} 0 0" condim="${friction > 0 ? 3 : 1}"/></default>
        <worldbody>${bodies.map(body_xml).join('')}</worldbody></mujoco>`;
}

function make(scene, step, configured) {
  if (!configured && scene.restitution > 0) {
    throw not_posed('as shipped, the engine has no restitution');
  }
  const model = mujoco.MjModel.from_xml_string(xml(scene, step, configured));
  const [data, saved] = [new mujoco.MjData(model), new mujoco.MjData(model)];
  const movable = scene.bodies.filter(({ fixed }) => !fixed);
  // The engine's angular velocity has the axes of the body.
  data.qvel.set(movable.flatMap(({ velocity, orientation: [w, ...axis], angular_velocity }) =>
    [...velocity, ...rotated([w, ...axis.map((x) => -x)], angular_velocity)]));
  const row_of = (i) => movable.indexOf(scene.bodies[i]);
  const id_of = (i) => 1 + scene.bodies.slice(0, i).filter(({ half_space }) => !half_space).length;  // 0 is the world
  const part = (array, from, count) => [...array.slice(from, from + count)];
  return {
    step: () => mujoco.mj_step(model, data),
    read: (i) => {
      const [q, v] = [7 * row_of(i), 6 * row_of(i)];
      const orientation = part(data.qpos, q + 3, 4);
      return { position: part(data.qpos, q, 3), orientation, velocity: part(data.qvel, v, 3),
        angular_velocity: rotated(orientation, part(data.qvel, v + 3, 3)) };
    },
    mass: (i) => ({ mass: model.body_mass[id_of(i)], principal_inertia: part(model.body_inertia, 3 * id_of(i), 3) }),
    save: () => (mujoco.mj_copyState(model, data, saved, whole_state), saved),
    restore: () => mujoco.mj_copyState(model, saved, data, whole_state),
    free: () => [data, saved, model].forEach((one) => one.delete()),
  };
}

await serve_runs({ name: 'mujoco', version: mujoco.mj_versionString(), precision: 'binary64', cannot: ['continuous'],
  restores: true, make });
