// SPDX-License-Identifier: BSL-1.0
import RAPIER from '@dimforge/rapier3d-compat';

import { serve_if_program, subject_name } from './line_protocol.mjs';
import { components, spheres, unit, xyz } from './posing.mjs';

const overlap = 1e-5;  // about 80 roundings of binary32, so that rounding leaves no gap between the spheres
await RAPIER.init();

function configure(world, model) {
  // Rapier cannot turn off the gyroscopic torque, or its limit of π/4 rad a step. A short step makes both negligible.
  world.timestep = 1e-16;  // [s]
  if (model === 'frictionless') {
    world.numSolverIterations = 1;  // with friction, the default of 4 is nearer to the law
  }
  world.integrationParameters.contact_natural_frequency = 0;  // the overlap causes no velocity
  world.lengthUnit = 1e15;  // raises the speed limit, which is 400 length units a second
}

// The engine's body has the world's axes, and its inertia has rotated principal axes. So only the centre of mass is
// rounded.
function make_body(world, body, sphere, { friction, restitution }, model) {
  const description = body.immovable ? RAPIER.RigidBodyDesc.kinematicVelocityBased() : RAPIER.RigidBodyDesc.dynamic();
  description.setTranslation(...sphere.centre).setLinvel(...body.velocity).setAngvel(xyz(body.angular_velocity));
  const made = world.createRigidBody(description);
  const mass = body.immovable ? 1 : body.mass;  // the engine ignores the mass of a kinematic body
  const moments = body.immovable ? [1, 1, 1] : body.principal_inertia;
  const [w, x, y, z] = body.immovable ? [1, 0, 0, 0] : unit(body.orientation);
  const collider = RAPIER.ColliderDesc.ball(sphere.radius)
    .setMassProperties(mass, xyz(sphere.centre_of_mass_from_centre), xyz(moments), { w, x, y, z })
    .setFriction(model === 'coulomb' ? friction : 0)  // the mean of two equal coefficients is the coefficient
    .setRestitution(restitution);
  world.createCollider(collider, made);
  return made;
}

function velocity_of(body) {
  return { velocity: components(body.linvel()), angular_velocity: components(body.angvel()) };
}

function solve(collision, { configured, model }) {
  const posed = spheres(collision, overlap);
  const world = new RAPIER.World(xyz([0, 0, 0]));
  try {
    if (configured) {
      configure(world, model);
    }
    const a = make_body(world, collision.a, posed.a, collision, model);
    const b = make_body(world, collision.b, posed.b, collision, model);
    world.step();
    return { a: velocity_of(a), b: velocity_of(b) };
  } finally {
    world.free();
  }
}

export function subject(setting) {
  const claims = {
    name: subject_name('rapier', setting),
    version: RAPIER.version(),
    precision: 'binary32',
    model: setting.model,
  };
  return { claims, solve: (collision) => solve(collision, setting) };
}

await serve_if_program(import.meta.url, subject);
