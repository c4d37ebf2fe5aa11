// SPDX-License-Identifier: BSL-1.0
const packages = {
  cannon: 'cannon-es',
  jolt: 'jolt-physics',
  mujoco: '@mujoco/mujoco',
  oimo: 'oimophysics',
  physx: 'physx-js-webidl',
  rapier: '@dimforge/rapier3d-compat',
};

const settings = [
  { suffix: '', configured: true, model: 'frictionless' },
  { suffix: '-as-shipped', configured: false, model: 'frictionless' },
  { suffix: '-coulomb', configured: true, model: 'coulomb' },
  { suffix: '-coulomb-as-shipped', configured: false, model: 'coulomb' },
];

/** The engines' subjects by their names, as `carom subjects` of the native program lists them. */
export const engine_subjects = new Map(Object.keys(packages).flatMap((engine) =>
  settings.map(({ suffix, ...setting }) => [engine + suffix, { engine, ...setting }])));

async function adapter(engine) {
  try {
    return await import(`../engines/${engine}.mjs`);
  } catch (error) {
    if (error.code === 'ERR_MODULE_NOT_FOUND' && error.message.includes(`'${packages[engine]}'`)) {
      throw new Error(`${packages[engine]} is not installed: npm install ${packages[engine]}`);
    }
    throw error;
  }
}

/** What a module that runs one of the engines' subjects would export. Its solver refuses invalid collisions. */
export async function engine_exports({ engine, configured, model }) {
  const { subject } = await adapter(engine);
  const { validate } = await import('../engines/line_protocol.mjs');
  const { claims, solve } = await subject({ configured, model });
  return {
    ...claims,
    law: model,
    solve(collision) {
      const defects = validate(collision);
      if (defects.length > 0) {
        throw new Error(defects.join('; '));
      }
      return solve(collision);
    },
  };
}
