// SPDX-License-Identifier: BSL-1.0
import RAPIER from '@dimforge/rapier3d-compat';

import { components, xyz } from '../posing.mjs';
import { serve_runs } from './serve_runs.mjs';

await RAPIER.init();

// The speed limit is 400 length units a second. The other lengths that follow the length unit keep their values.
function configure({ integrationParameters: parameters }, { continuous }) {
  const unit = 1e6;
  parameters.lengthUnit = unit;
  parameters.normalizedAllowedLinearError /= unit;
  parameters.normalizedPredictionDistance /= unit;
  if (!continuous) {
    parameters.maxCcdSubsteps = 0;  // as shipped, fast bodies do not pass through fixed ones
  }
}

function make_collider({ shape, sphere, box, half_space }) {
  switch (shape) {
    case 'sphere':
      return RAPIER.ColliderDesc.ball(sphere);
    case 'box':
      return RAPIER.ColliderDesc.cuboid(...box.map((x) => x / 2));
    default:
      return new RAPIER.ColliderDesc(new RAPIER.HalfSpace(xyz(half_space)));
  }
}

function make_body(world, body, { friction, restitution, continuous, bodies }, configured) {
  const description = body.fixed ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic();
  const [w, x, y, z] = body.orientation;
  description.setTranslation(...body.position).setRotation({ w, x, y, z });
  description.setLinvel(...body.velocity).setAngvel(xyz(body.angular_velocity));
  // Two bodies with continuous detection do not find each other, so only the last body has it.
  description.setCcdEnabled(continuous && body === bodies.at(-1)).setCanSleep(!configured);
  const made = world.createRigidBody(description);
  const collider = make_collider(body);
  if (!body.fixed) {
    collider.setMassProperties(body.mass, xyz([0, 0, 0]), xyz(body.principal_inertia), { w: 1, x: 0, y: 0, z: 0 });
  }
  world.createCollider(collider.setFriction(friction).setRestitution(restitution), made);  // a pair has the mean
  made.recomputeMassPropertiesFromColliders();
  return made;
}

function make(scene, step, configured) {
  let world = new RAPIER.World(xyz(scene.gravity));
  if (configured) {
    configure(world, scene);
  }
  world.timestep = step;
  const handles = scene.bodies.map((body) => make_body(world, body, scene, configured).handle);
  const body_at = (i) => world.getRigidBody(handles[i]);
  return {
    step: () => world.step(),
    read: (i) => {
      const body = body_at(i);
      const { w, x, y, z } = body.rotation();
      return { position: components(body.translation()), orientation: [w, x, y, z], velocity: components(body.linvel()),
        angular_velocity: components(body.angvel()) };
    },
    mass: (i) => ({ mass: body_at(i).mass(), principal_inertia: components(body_at(i).principalInertia()) }),
    save: () => world.takeSnapshot(),
    restore: (saved) => {
      world.free();
      world = RAPIER.World.restoreSnapshot(saved);
    },
    free: () => world.free(),
  };
}

await serve_runs({ name: 'rapier', version: RAPIER.version(), precision: 'binary32', restores: true, make });
