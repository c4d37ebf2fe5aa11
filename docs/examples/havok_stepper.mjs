// SPDX-License-Identifier: BSL-1.0
// Havok as a subject of `carom time`, an engine that Carom does not know: npm install @babylonjs/havok, and then
// carom time 'exec:node FOLDER/havok_stepper.mjs [configured|as-shipped]' where the package is installed.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { createInterface } from 'node:readline';

const require = createRequire(`${process.cwd()}/`);
const binary = require.resolve('@babylonjs/havok/lib/umd/HavokPhysics.wasm');
const havok = await require('@babylonjs/havok')({ wasmBinary: readFileSync(binary) });
const { version } = JSON.parse(readFileSync(join(binary, '../../../package.json')));
const configured = process.argv[2] !== 'as-shipped';
const got = ([, value]) => value;  // each call returns a status and a value

/** A half-space is a box of 400 m below its surface, so `turn` turns z to the normal [x, y, z, w]. */
function turn({ half_space, orientation: [w, x, y, z] = [1, 0, 0, 0] }) {
  const unit = (v) => v.map((component) => component / Math.hypot(...v));
  const [a, b, c] = unit(half_space ?? [0, 0, 1]);
  return half_space ? unit(c > -1 ? [-b, a, 0, 1 + c] : [1, 0, 0, 0]) : [x, y, z, w];
}

function make_shape({ sphere, box = [400, 400, 100], half_space }, { friction, restitution }) {
  const shape = got(sphere ? havok.HP_Shape_CreateSphere([0, 0, 0], sphere)
    : havok.HP_Shape_CreateBox([0, 0, half_space ? -50 : 0], [0, 0, 0, 1], box));
  const combine = havok.MaterialCombine.MAXIMUM;
  havok.HP_Shape_SetMaterial(shape, [friction, friction, restitution, combine, combine]);
  return shape;
}

function add_body(world, body, scene) {
  const made = got(havok.HP_Body_Create());
  havok.HP_Body_SetShape(made, make_shape(body, scene));
  havok.HP_Body_SetMotionType(made, body.fixed ? havok.MotionType.STATIC : havok.MotionType.DYNAMIC);
  havok.HP_Body_SetQTransform(made, [body.position, turn(body)]);
  havok.HP_World_AddBody(world, made, false);
  if (body.fixed) {
    return made;
  }
  const { mass, principal_inertia } = body;  // Havok takes the moments of 1 kg
  havok.HP_Body_SetMassProperties(made, [[0, 0, 0], mass, principal_inertia.map((j) => j / mass), [0, 0, 0, 1]]);
  if (configured) {
    havok.HP_Body_SetLinearDamping(made, 0);
    havok.HP_Body_SetAngularDamping(made, 0);
    havok.HP_Body_SetActivationControl(made, havok.ActivationControl.ALWAYS_ACTIVE);
  }
  havok.HP_Body_SetLinearVelocity(made, body.velocity);
  havok.HP_Body_SetAngularVelocity(made, body.angular_velocity);
  return made;
}

function run({ scene, step, steps, report }) {
  const world = got(havok.HP_World_Create());
  havok.HP_World_SetGravity(world, scene.gravity);
  havok.HP_World_SetIdealStepTime(world, step);
  if (configured) {
    havok.HP_World_SetSpeedLimit(world, 1e9, 1e9);
  }
  const bodies = scene.bodies.map((body) => add_body(world, body, scene));
  const state_of = (body) => {
    const [position, [x, y, z, w]] = got(havok.HP_Body_GetQTransform(body));
    return { position, orientation: [w, x, y, z], velocity: got(havok.HP_Body_GetLinearVelocity(body)),
      angular_velocity: got(havok.HP_Body_GetAngularVelocity(body)) };
  };
  const states = [];
  const start = performance.now();
  for (let done = 0; done <= steps; ++done) {
    if (report.includes(done)) {
      states.push(bodies.map(state_of));
    }
    havok.HP_World_Step(world, step);
  }
  const seconds = (performance.now() - start) / 1000;
  bodies.forEach((body) => { havok.HP_World_RemoveBody(world, body); havok.HP_Body_Release(body); });
  havok.HP_World_Release(world);
  return { states, seconds };
}

const introduction = { protocol: 1, name: configured ? 'havok' : 'havok-as-shipped', precision: 'binary32', time: true,
  version, cannot: ['continuous'] };
for await (const line of createInterface({ input: process.stdin })) {
  const { cmd, id, ...request } = JSON.parse(line);
  if (cmd === 'stop') {
    break;
  }
  console.log(JSON.stringify(cmd === 'start' ? introduction : { id, ...run(request) }));
}
