// SPDX-License-Identifier: BSL-1.0
/** The text in the module's memory. The caller frees it. */
Module.newText = (text) => {
  const bytes = lengthBytesUTF8(text) + 1;
  const at = _malloc(bytes);
  stringToUTF8(text, at, bytes);
  return at;
};

/** The answer to a request, both as JSON texts. */
Module.caromCall = (request) => {
  const at = Module.newText(request);
  try {
    return UTF8ToString(_carom_call(at));
  } finally {
    _free(at);
  }
};
