// SPDX-License-Identifier: BSL-1.0
import { read_collision } from './engines/line_protocol.mjs';
import { draw_options, sorted_options } from './options.mjs';
import { this_judge } from './threads/node_judge.mjs';

/** The collisions that the gate draws of a family with this seed. */
export async function draw(options = {}) {
  const { request } = sorted_options(options, draw_options);
  const judge = await this_judge();
  return judge({ cmd: 'draw', family: 'generic', count: 1, ...request }).collisions.map(read_collision);
}
