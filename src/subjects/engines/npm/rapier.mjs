// SPDX-License-Identifier: BSL-1.0
import RAPIER from '@dimforge/rapier3d-compat';

import { serve, settings, subject_name } from './line_protocol.mjs';
import { components, spheres, unit, xyz } from './posing.mjs';

const { configured, model } = settings();
const overlap = 1e-5;  // some 80 roundings of binary32: the distance of the spheres must leave no gap
await RAPIER.init();

function configure(world) {
  // Gyroscopic torque and the limit on the angular velocity, a quarter of π each step, have no switch here. Both vanish
  // with the step.
  world.timestep = 1e-16;  // [s]
  if (model === 'frictionless') {
    world.numSolverIterations = 1;  // with friction the engine's 4 are nearer to the law
  }
  world.integrationParameters.contact_natural_frequency = 0;  // no velocity from the overlap
  world.lengthUnit = 1e15;  // a speed limit of 400 of these a second
}

// The body's origin is at the centre of its sphere, and its axes are those of the world: its principal axes are turned
// instead. So only the centre of mass is rounded.
function make_body(world, body, sphere, { friction, restitution }) {
  const description = body.immovable ? RAPIER.RigidBodyDesc.kinematicVelocityBased() : RAPIER.RigidBodyDesc.dynamic();
  description.setTranslation(...sphere.centre).setLinvel(...body.velocity).setAngvel(xyz(body.angular_velocity));
  const made = world.createRigidBody(description);
  const mass = body.immovable ? 1 : body.mass;  // a kinematic body has a centre of mass, but acts as infinitely heavy
  const moments = body.immovable ? [1, 1, 1] : body.principal_inertia;
  const [w, x, y, z] = body.immovable ? [1, 0, 0, 0] : unit(body.orientation);
  const collider = RAPIER.ColliderDesc.ball(sphere.radius)
    .setMassProperties(mass, xyz(sphere.centre_of_mass_from_centre), xyz(moments), { w, x, y, z })
    .setFriction(model === 'coulomb' ? friction : 0)  // two of the same average to the same
    .setRestitution(restitution);
  world.createCollider(collider, made);
  return made;
}

function velocity_of(body) {
  return { velocity: components(body.linvel()), angular_velocity: components(body.angvel()) };
}

function solve(collision) {
  const posed = spheres(collision, overlap);
  const world = new RAPIER.World(xyz([0, 0, 0]));
  try {
    if (configured) {
      configure(world);
    }
    const a = make_body(world, collision.a, posed.a, collision);
    const b = make_body(world, collision.b, posed.b, collision);
    world.step();
    return { a: velocity_of(a), b: velocity_of(b) };
  } finally {
    world.free();
  }
}

const claims = {
  name: subject_name('rapier', { configured, model }),
  version: RAPIER.version(),
  precision: 'binary32',
  model,
};
await serve(claims, solve);
