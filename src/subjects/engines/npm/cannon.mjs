// SPDX-License-Identifier: BSL-1.0
import { createRequire } from 'node:module';

import { Body, Quaternion, Sphere, Vec3, World } from 'cannon-es';

import { serve, wants_configured } from './line_protocol.mjs';
import { spheres, unit } from './posing.mjs';

const configured = wants_configured();
const overlap = 4500 * Number.EPSILON;  // some thousand roundings of the spheres' distance must leave no gap
const step = 1 / 60;  // [s]; configured, its length enters nothing

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

function make_world(a, b, restitution) {
  const world = new World();  // without gravity
  world.addBody(a);
  world.addBody(b);
  world.defaultContactMaterial.friction = 0;
  world.defaultContactMaterial.restitution = restitution;
  return world;
}

function configure(world) {
  for (const body of world.bodies) {
    body.linearDamping = body.angularDamping = 0;
  }
  // Before the contact is solved: its SPOOK parameters as for an infinite relaxation, which leaves no softness and lets
  // no velocity come from the overlap, and no limit on its impulse.
  world.bodies[0].addEventListener('collide', ({ contact }) => {
    Object.assign(contact, { a: 0, b: 1, eps: 0, maxForce: Infinity });
  });
}

function velocity_of(body) {
  return { velocity: body.velocity.toArray(), angular_velocity: body.angularVelocity.toArray() };
}

function solve(collision) {
  const posed = spheres(collision, overlap);
  const a = make_body(collision.a, posed.a);
  const b = make_body(collision.b, posed.b);
  const world = make_world(a, b, collision.restitution);
  if (configured) {
    configure(world);
  }
  world.step(step);
  return { a: velocity_of(a), b: velocity_of(b) };
}

const claims = {
  name: configured ? 'cannon' : 'cannon-as-shipped',
  version: createRequire(import.meta.url)('cannon-es/package.json').version,
  precision: 'binary64',
  model: 'frictionless',
};
await serve(claims, solve);
