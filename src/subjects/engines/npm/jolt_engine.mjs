// SPDX-License-Identifier: BSL-1.0
import initialize from 'jolt-physics';

export const Jolt = await initialize();

// These objects are in the engine's memory, which has no garbage collection, and are reused.
const vector = new Jolt.Vec3();
const position = new Jolt.RVec3();
const rotation = new Jolt.Quat();
const filled = (target, numbers) => (target.Set(...numbers), target);

/** The engine's vector with these numbers, until the next call. */
export const engine_vector = (numbers) => filled(vector, numbers);
export const engine_position = (numbers) => filled(position, numbers);
/** The engine's quaternion from w, x, y, z, until the next call. */
export const engine_rotation = ([w, x, y, z]) => filled(rotation, [x, y, z, w]);

export const numbers_of = (v) => [v.GetX(), v.GetY(), v.GetZ()];

/** An empty world in which everything collides. The caller destroys it; no two may exist at once. */
export function make_interface(max_bodies, max_contacts) {
  const layer_pairs = new Jolt.ObjectLayerPairFilterTable(1);
  layer_pairs.EnableCollision(0, 0);
  const broad_phase_layers = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
  const layer = new Jolt.BroadPhaseLayer(0);
  broad_phase_layers.MapObjectToBroadPhaseLayer(0, layer);
  const settings = new Jolt.JoltSettings();
  settings.mMaxBodies = max_bodies;
  settings.mMaxBodyPairs = settings.mMaxContactConstraints = max_contacts;
  settings.mObjectLayerPairFilter = layer_pairs;
  settings.mBroadPhaseLayerInterface = broad_phase_layers;
  const layer_filter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(broad_phase_layers, 1, layer_pairs, 1);
  settings.mObjectVsBroadPhaseLayerFilter = layer_filter;
  const world = new Jolt.JoltInterface(settings);  // owns the tables
  Jolt.destroy(layer);
  Jolt.destroy(settings);
  return world;
}

/** Sets the mass of a body, and its moments about axes that `orientation` turns away from the body's. */
export function set_mass(body, { mass, principal_inertia }, orientation = [1, 0, 0, 0]) {
  const properties = body.GetMotionProperties();
  properties.SetInverseMass(1 / mass);
  properties.SetInverseInertia(engine_vector(principal_inertia.map((j) => 1 / j)), engine_rotation(orientation));
}
