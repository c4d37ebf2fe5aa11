// SPDX-License-Identifier: BSL-1.0
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

import initialize from 'physx-js-webidl';

import { xyz } from './posing.mjs';

const require = createRequire(import.meta.url);

// The package is built for browsers and does not start if it detects Node.
const { process } = globalThis;
Object.assign(globalThis, { process: undefined, window: globalThis });
const wasmBinary = readFileSync(require.resolve('physx-js-webidl/physx-js-webidl.wasm'));
export const PhysX = await initialize({ wasmBinary, print: console.error });  // standard output carries the protocol
Object.assign(globalThis, { process, window: undefined });

const number = PhysX.PHYSICS_VERSION;
export const version = [24, 16, 8].map((shift) => (number >> shift) & 255).join('.');
export const scale = new PhysX.PxTolerancesScale();
const foundation = PhysX.CreateFoundation(number, new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback());
export const physics = PhysX.CreatePhysics(number, foundation, scale);

// These objects are in the engine's memory, which has no garbage collection, and are reused.
const pose = new PhysX.PxTransform(PhysX.PxIDENTITYEnum.PxIdentity);
const vector = new PhysX.PxVec3(0, 0, 0);
const dispatcher = PhysX.DefaultCpuDispatcherCreate(0);

/** The engine's vector with these numbers, until the next call. */
export const engine_vector = (numbers) => Object.assign(vector, xyz(numbers));

/** The engine's pose, until the next call. */
export function pose_at(position, [w, x, y, z] = [1, 0, 0, 0]) {
  Object.assign(pose.p, xyz(position));
  Object.assign(pose.q, { w, x, y, z });
  return pose;
}

/** The description of a scene with the default settings. */
export function describe_scene(gravity) {
  const description = new PhysX.PxSceneDesc(scale);
  description.gravity = engine_vector(gravity);
  description.cpuDispatcher = dispatcher;
  description.filterShader = PhysX.DefaultFilterShader();
  return description;
}
