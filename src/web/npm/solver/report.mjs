// SPDX-License-Identifier: BSL-1.0
/** The reply to `finish`, with the content of report.json as `report`. */
export function with_report(reply) {
  return { ...reply, report: JSON.parse(reply.files.find(({ file }) => file === 'report.json').text) };
}
