// SPDX-License-Identifier: BSL-1.0
import { read_collision } from './engines/line_protocol.mjs';
import { domain_text } from './solver/introduction.mjs';
import { this_judge } from './threads/node_judge.mjs';

/** A function that draws collisions of a family without waiting: those that the gate draws with this seed. */
export async function drawer() {
  const judge = await this_judge();
  return ({ family = 'generic', seed = 1, first = 0, count = 1, within } = {}) => {
    const request = { cmd: 'draw', family, seed: String(seed), first, count, within: domain_text(within) };
    return judge(request).collisions.map(read_collision);
  };
}

export async function draw(options) {
  const draw_now = await drawer();
  return draw_now(options);
}
