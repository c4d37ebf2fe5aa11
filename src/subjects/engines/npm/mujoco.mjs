// SPDX-License-Identifier: BSL-1.0
import initialize from '@mujoco/mujoco';

import { serve_if_program, subject_name } from './line_protocol.mjs';
import { spheres, unit } from './posing.mjs';

const silent = () => {};  // warnings would go to standard output, which carries the protocol
const mujoco = await initialize({ print: silent, printErr: silent });
const overlap = 64 * Number.EPSILON;  // exceeds the rounding error of the spheres' distance, about 10 roundings
const step = 2 ** -100;  // [s]; so short that the gyroscopic torque vanishes. As shipped, a step has 0.002 s

// A template whose numbers each collision replaces. An immovable body has no joint. The normal points from `geom1` to
// `geom2`.
function xml({ a, b }) {
  const body = (name, immovable) => `
    <body>
      ${immovable ? '' : '<freejoint/>'}
      <inertial pos="0 0 0" quat="0.5 0.1 0.6 0.3" mass="1" diaginertia="1 1.1 1.2"/>
      <geom name="${name}" pos="1 2 3" size="1" contype="0" conaffinity="0"/>
    </body>`;
  return `
    <mujoco>
      <option gravity="0 0 0"/>
      <worldbody>${body('a', a.immovable)}${body('b', b.immovable)}</worldbody>
      <contact><pair geom1="b" geom2="a"/></contact>
    </mujoco>`;
}

function configure(option) {
  Object.assign(option, {
    timestep: step,
    disableflags: mujoco.mjtDisableBit.mjDSBL_AUTORESET.value,  // accelerations beyond 1e10 are valid here
    enableflags: mujoco.mjtEnableBit.mjENBL_DIAGEXACT.value,  // the softness follows N·K N instead of 1/m_A + 1/m_B
    cone: mujoco.mjtCone.mjCONE_ELLIPTIC.value,
    impratio: 100,  // softness along N / tangential softness; from 1e4 on, the solver stops too early
  });
}

function make_world(collision, configured) {
  const model = mujoco.MjModel.from_xml_string(xml(collision));
  if (configured) {
    configure(model.opt);
  }
  return { model, data: new mujoco.MjData(model) };
}

function world_for(worlds, collision, configured) {
  const key = `${collision.a.immovable} ${collision.b.immovable}`;
  if (!worlds.has(key)) {
    worlds.set(key, make_world(collision, configured));
  }
  return worlds.get(key);
}

function set_contact(world, { restitution, friction }, { configured, model }) {
  const without_friction = model === 'frictionless' || (configured && friction === 0);
  world.pair_dim[0] = without_friction ? 1 : 3;
  world.pair_friction.fill(friction, 0, 2);  // MuJoCo uses at least 1e-5
  if (configured) {
    const impedance = mujoco.mjMAXIMP;  // the hardest contact that MuJoCo has, at every depth
    world.pair_solimp.fill(impedance, 0, 2);
    // Zero stiffness, and a damping that demands N·V⁺ = −ε N·V⁻ and N × V⁺ = 0 at the end of the step. The engine
    // divides the damping by the impedance, which compensates for the softness along N. Friction has almost no
    // softness, so its damping contains the impedance as a factor.
    world.pair_solref.set([0, -(1 + restitution) / step]);
    world.pair_solreffriction.set([0, -impedance / step]);
  }
}

// The engine's body has the world's axes, and its inertia has rotated principal axes.
function set_body(world, index, body, sphere) {
  const centre = body.immovable ? sphere.centre : sphere.centre_of_mass_from_centre.map((x) => -x);
  world.geom_pos.set(centre, 3 * index);
  world.geom_size[3 * index] = world.geom_rbound[index] = sphere.radius;
  if (!body.immovable) {
    world.body_mass[index + 1] = body.mass;  // index 0 is the world's own body
    world.body_inertia.set(body.principal_inertia, 3 * (index + 1));
    world.body_iquat.set(unit(body.orientation), 4 * (index + 1));
  }
}

// The velocity of the wall's material point at P: v − w × c, with the wall's centre of mass c. P is the origin.
function velocity_of_wall({ velocity: v, angular_velocity: w }, { centre_of_mass: c }) {
  return v.map((x, i) => x - (w[(i + 1) % 3] * c[(i + 2) % 3] - w[(i + 2) % 3] * c[(i + 1) % 3]));
}

// MuJoCo cannot prescribe a velocity. So a contact with a wall is posed in a frame that moves with the wall's material
// point at P.
function solve(worlds, collision, setting) {
  const { a, b } = collision;
  if (a.immovable && b.immovable) {
    return collision;
  }
  const posed = spheres(collision, overlap);
  const frame = a.immovable ? velocity_of_wall(a, posed.a) : b.immovable ? velocity_of_wall(b, posed.b) : [0, 0, 0];
  const { model: world, data } = world_for(worlds, collision, setting.configured);
  set_contact(world, collision, setting);
  set_body(world, 0, a, posed.a);
  set_body(world, 1, b, posed.b);
  mujoco.mj_setConst(world, data);
  world.geom_sameframe.fill(0);  // otherwise the engine treats offsets below 1e-6 as 0
  world.body_sameframe.fill(0);
  mujoco.mj_resetData(world, data);
  const movable = [a, b].filter(({ immovable }) => !immovable);
  const before = movable.flatMap((body) => [...body.velocity.map((x, i) => x - frame[i]), ...body.angular_velocity]);
  data.qvel.set(before);
  data.qpos.set(movable.flatMap((body) => [...(body === a ? posed.a : posed.b).centre_of_mass, 1, 0, 0, 0]));
  mujoco.mj_step(world, data);
  const change = data.qvel.map((x, i) => x - before[i]);
  const velocity_of = (body) => {
    const first = 6 * movable.indexOf(body);
    const changed = (vector, offset) => vector.map((x, i) => x + change[offset + i]);
    return body.immovable
      ? body
      : { velocity: changed(body.velocity, first), angular_velocity: changed(body.angular_velocity, first + 3) };
  };
  return { a: velocity_of(a), b: velocity_of(b) };
}

export function subject(setting) {
  const worlds = new Map();
  const claims = {
    name: subject_name('mujoco', setting),
    version: mujoco.mj_versionString(),
    precision: 'binary64',
    model: setting.model,
  };
  return { claims, solve: (collision) => solve(worlds, collision, setting) };
}

await serve_if_program(import.meta.url, subject);
