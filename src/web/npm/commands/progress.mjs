// SPDX-License-Identifier: BSL-1.0

/** Shows the progress on standard error if that is a terminal. */
export function progress_line() {
  if (!process.stderr.isTTY) {
    return undefined;
  }
  let shown;
  return (done, all) => {
    const percent = Math.floor((100 * done) / all);
    if (percent !== shown) {
      shown = percent;
      process.stderr.write(`\r${done} of ${all} cases judged, ${percent} %${done === all ? '\n' : ''}`);
    }
  };
}
