// SPDX-License-Identifier: BSL-1.0
import assert from 'node:assert';
import { join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';

import { has_installed, imported, installed, run } from './installed.mjs';

const folder = installed();
const law = 'frictionless';

async function loaded() {
  const default_of = async (...path) => (await import(pathToFileURL(join(folder, ...path)).href)).default;
  const arbitraries = await imported(folder, 'fast_check.mjs');
  const fc = await default_of('node_modules/fast-check/lib/fast-check.js');
  const { solve: sound } = await import(pathToFileURL(join(folder, 'sound.mjs')).href);
  return { ...arbitraries, fc, sound, wrong: await default_of('wrong.mjs') };
}

test('arbitraries for fast-check', async (t) => {
  if (!has_installed(folder, 'fast-check@4')) {
    t.skip('fast-check cannot be installed');
    return;
  }
  const { approaching, body, collision, families, family, fc, holds, sound, wall, withBodies, within, wrong } =
    await loaded();

  await t.test('a sound solver holds', () => fc.assert(fc.property(collision(), holds(sound, { law }))));

  await t.test('a planted defect is found, and shrunk to simple numbers', () => {
    const details = fc.check(fc.property(collision(), holds(wrong, { law })), { seed: 1 });
    assert.ok(details.failed);
    assert.match(String(details.errorInstance), /restitution +VIOLATED/);
    const [found] = details.counterexample;
    assert.ok(JSON.stringify(found).length < 420, JSON.stringify(found));
    assert.ok(found.restitution > 0);
  });

  await t.test('a collision shrinks within its family and its domain', () => {
    const collisions = within('mass=2:3').family('elastic');
    const details = fc.check(fc.property(collisions, ({ a }) => a.mass < 2.5), { seed: 1 });
    const [{ a, b, restitution }] = details.counterexample;
    assert.ok(details.failed && details.numShrinks > 0);
    assert.ok([a.mass, b.mass].every((mass) => mass >= 2 && mass <= 3));
    assert.strictEqual(restitution, 1);
  });

  await t.test('the same seed draws the same collisions', () => {
    const sample = () => fc.sample(collision(), { seed: 7, numRuns: 20 });
    assert.deepStrictEqual(sample(), sample());
    assert.notDeepStrictEqual(sample()[0], sample()[1]);
  });

  await t.test('each family has its arbitrary', () => {
    assert.ok(fc.sample(families.elastic(), 20).every(({ restitution }) => restitution === 1));
    assert.ok(fc.sample(family('immovable_a'), 20).every(({ a }) => a.immovable));
    assert.throws(() => family('elastics'), /did you mean 'elastic'\?/);
  });

  await t.test('combinators', () => {
    const masses = fc.sample(within('mass=2:3').family('generic'), 20).flatMap(({ a, b }) => [a.mass, b.mass]);
    assert.ok(masses.every((mass) => mass >= 2 && mass <= 3));
    const walls = fc.sample(withBodies(families.generic(), body(), wall()), 20);
    assert.ok(walls.every(({ a, b }) => !a.immovable && b.immovable));
    const turned = ([x, y, z], [u, v, w]) => [y * w - z * v, z * u - x * w, x * v - y * u];
    const speed = ({ normal, point }, { position, velocity, angular_velocity }) => {
      const arm = turned(angular_velocity, point.map((x, i) => x - position[i]));
      return velocity.reduce((sum, x, i) => sum + normal[i] * (x + arm[i]), 0);
    };
    const approaching_ones = fc.sample(approaching(families.separating()), 20);
    assert.ok(approaching_ones.every((one) => speed(one, one.a) - speed(one, one.b) < 0));
  });

  await t.test('the example passes', async () => {
    const example = join(folder, 'node_modules/carom/examples/fast_check.test.mjs');
    const { status, stdout } = await run(folder, process.execPath, '--test', example);
    assert.strictEqual(status, 0, stdout);
    assert.match(stdout, /pass 2/);
  });
});
