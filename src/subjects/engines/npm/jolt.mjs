// SPDX-License-Identifier: BSL-1.0
import { createRequire } from 'node:module';

import {
  engine_position, engine_rotation, engine_vector, Jolt, make_interface, numbers_of, set_mass,
} from './jolt_engine.mjs';
import { limits, serve_if_program, subject_name } from './line_protocol.mjs';
import { spheres, unit } from './posing.mjs';

const overlap = 1e-5;  // about 80 roundings of binary32, so that rounding leaves no gap between the spheres
const step = 1 / 60;  // [s]; has no effect on the configured engine

function make_world({ configured, model }) {
  const world = make_interface(16, 16);
  world.GetPhysicsSystem().SetGravity(engine_vector([0, 0, 0]));
  if (configured) {
    const physics = world.GetPhysicsSystem().GetPhysicsSettings();
    physics.mMinVelocityForRestitution = 0;  // [m/s]
    if (model === 'coulomb') {
      physics.mNumVelocitySteps = 20;  // friction and the normal impulse alternate; more steps do not help
    }
  }
  return world;
}

// The engine's body has the world's axes, and its inertia has rotated principal axes. So the sphere's position is not
// rounded.
function make_body(bodies, body, sphere, { friction, restitution }, { configured, model }) {
  const shape = new Jolt.OffsetCenterOfMassShape(
    new Jolt.SphereShape(sphere.radius), engine_vector(sphere.centre_of_mass_from_centre));
  const settings = new Jolt.BodyCreationSettings(
    shape, engine_position(sphere.centre), engine_rotation([1, 0, 0, 0]),
    body.immovable ? Jolt.EMotionType_Kinematic : Jolt.EMotionType_Dynamic, 0);
  settings.mLinearVelocity = engine_vector(body.velocity);
  settings.mAngularVelocity = engine_vector(body.angular_velocity);
  settings.mFriction = model === 'coulomb' ? friction : 0;  // the geometric mean √(μ μ) rounds to μ
  settings.mRestitution = restitution;
  if (configured) {
    settings.mLinearDamping = settings.mAngularDamping = 0;
    settings.mMaxLinearVelocity = settings.mMaxAngularVelocity = 1e18;
  }
  const made = bodies.CreateBody(settings);
  Jolt.destroy(settings);  // the shapes are reference-counted and end with the body
  if (!body.immovable) {
    set_mass(made, body, unit(body.orientation));
  }
  bodies.AddBody(made.GetID(), Jolt.EActivation_Activate);
  return made;
}

function velocity_of(body) {
  return { velocity: numbers_of(body.GetLinearVelocity()), angular_velocity: numbers_of(body.GetAngularVelocity()) };
}

function solve(world, collision, setting) {
  const bodies = world.GetPhysicsSystem().GetBodyInterface();
  const posed = spheres(collision, overlap);
  const a = make_body(bodies, collision.a, posed.a, collision, setting);
  const b = make_body(bodies, collision.b, posed.b, collision, setting);
  world.Step(step, 1);
  const outcome = { a: velocity_of(a), b: velocity_of(b) };
  for (const body of [b, a]) {  // the engine reuses the ID freed last, so A keeps the lower ID and comes first
    bodies.RemoveBody(body.GetID());
    bodies.DestroyBody(body.GetID());
  }
  return outcome;
}

export function subject(setting) {
  const { configured, model } = setting;
  const world = make_world(setting);
  const claims = {
    name: subject_name('jolt', setting),
    version: createRequire(import.meta.url)('jolt-physics/package.json').version,
    precision: 'binary32',
    model,
    claims: configured ? undefined : {
      restitution_threshold: 1,
      linear_damping: 0.05 * step,
      angular_damping: 0.05 * step,
      ...limits(model, { max_speed: 500, max_angular_velocity: Math.PI / 4 / step }),
    },
  };
  return { claims, solve: (collision) => solve(world, collision, setting) };
}

await serve_if_program(import.meta.url, subject);
