// SPDX-License-Identifier: BSL-1.0
// By its policy, the browser takes a text as HTML or as the address of a script only from here.

const rules = { createHTML: (text) => text, createScriptURL: (text) => text };

export const trusted = globalThis.trustedTypes?.createPolicy('carom', rules) ?? rules;
