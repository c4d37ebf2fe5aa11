// SPDX-License-Identifier: BSL-1.0

/**
 * Aborts at the first Ctrl-C, so that the report of what was judged is written. The second Ctrl-C ends the program.
 * Node does not tell which signals its parent ignored, so a hang-up aborts a run under `nohup`, too.
 */
export function signal_of_interrupt() {
  const controller = new AbortController();
  for (const name of ['SIGINT', 'SIGTERM', 'SIGHUP']) {
    process.once(name, () => controller.abort());
  }
  return controller.signal;
}
