// SPDX-License-Identifier: BSL-1.0

/** Aborts at the first Ctrl-C, so that the report of what was judged is written. The second Ctrl-C ends the program. */
export function signal_of_interrupt() {
  const controller = new AbortController();
  for (const name of ['SIGINT', 'SIGTERM']) {
    process.once(name, () => controller.abort());
  }
  return controller.signal;
}
