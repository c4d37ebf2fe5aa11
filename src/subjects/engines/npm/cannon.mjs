// SPDX-License-Identifier: BSL-1.0
import { createRequire } from 'node:module';

import { Body, Quaternion, Sphere, Vec3, World } from 'cannon-es';

import { serve_if_program, subject_name } from './line_protocol.mjs';
import { spheres, unit } from './posing.mjs';

const overlap = 64 * Number.EPSILON;  // exceeds the rounding error of the spheres' distance, about 10 roundings
const step = 1 / 60;  // [s]; has no effect on the configured engine

function make_body(body, sphere) {
  const [w, x, y, z] = body.immovable ? [1, 0, 0, 0] : unit(body.orientation);
  const made = new Body({
    type: body.immovable ? Body.KINEMATIC : Body.DYNAMIC,
    mass: body.immovable ? 0 : body.mass,
    position: new Vec3(...sphere.centre_of_mass),
    quaternion: new Quaternion(x, y, z, w),
    velocity: new Vec3(...body.velocity),
    angularVelocity: new Vec3(...body.angular_velocity),
  });
  const centre = new Vec3(...sphere.centre_of_mass_from_centre).negate();
  made.addShape(new Sphere(sphere.radius), made.quaternion.inverse().vmult(centre));
  if (!body.immovable) {
    made.inertia.set(...body.principal_inertia);
    made.invInertia.set(...body.principal_inertia.map((moment) => 1 / moment));
    made.updateInertiaWorld(true);
  }
  return made;
}

// The engine limits the friction impulse to μ g m, with a gravity g and the reduced mass m of the bodies. If g = (1 +
// ε) |N·V⁻|, then g m is the normal impulse of bodies that do not turn.
function friction_gravity({ a, b, point, normal, restitution }) {
  const velocity_at_point = ({ position, velocity, angular_velocity }) =>
    new Vec3(...angular_velocity).cross(new Vec3(...point).vsub(new Vec3(...position))).vadd(new Vec3(...velocity));
  const approach = -velocity_at_point(a).vsub(velocity_at_point(b)).dot(new Vec3(...unit(normal)));  // [m/s]
  return new Vec3((1 + restitution) * Math.max(0, approach), 0, 0);
}

function make_world(a, b, { friction, restitution }, model) {
  const world = new World();  // has no gravity by default
  world.addBody(a);
  world.addBody(b);
  world.defaultContactMaterial.friction = model === 'coulomb' ? friction : 0;
  world.defaultContactMaterial.restitution = restitution;
  return world;
}

function configure(world, collision, model) {
  for (const body of world.bodies) {
    body.linearDamping = body.angularDamping = 0;
  }
  if (model === 'coulomb') {
    world.frictionGravity = friction_gravity(collision);
    world.solver.iterations = 100;
    world.solver.tolerance = 0;
  }
  // Runs before the contact is solved. SPOOK, the engine's contact model, gets the parameters of infinite relaxation:
  // the contact is rigid, and the overlap causes no velocity.
  world.bodies[0].addEventListener('collide', ({ contact }) => {
    Object.assign(contact, { a: 0, b: 1, eps: 0, maxForce: Infinity });
    for (const friction of world.frictionEquations) {
      Object.assign(friction, { a: 0, b: 1, eps: 0 });
    }
  });
}

function velocity_of(body) {
  return { velocity: body.velocity.toArray(), angular_velocity: body.angularVelocity.toArray() };
}

function solve(collision, { configured, model }) {
  const posed = spheres(collision, overlap);
  const a = make_body(collision.a, posed.a);
  const b = make_body(collision.b, posed.b);
  const world = make_world(a, b, collision, model);
  if (configured) {
    configure(world, collision, model);
  }
  world.step(step);
  return { a: velocity_of(a), b: velocity_of(b) };
}

export function subject(setting) {
  const damping = 1 - 0.99 ** step;
  const claims = {
    name: subject_name('cannon', setting),
    version: createRequire(import.meta.url)('cannon-es/package.json').version,
    precision: 'binary64',
    model: setting.model,
    claims: setting.configured ? undefined : { linear_damping: damping, angular_damping: damping },
  };
  return { claims, solve: (collision) => solve(collision, setting) };
}

await serve_if_program(import.meta.url, subject);
