// SPDX-License-Identifier: BSL-1.0

const is_object = (value) => (typeof value === 'object' && value !== null) || typeof value === 'function';

/** Objects that lead to those built-in prototypes that no global name leads to. */
const nameless = () => [
  function* () {}, async () => {}, async function* () {}, [].values(), new Map().values(), new Set().values(),
  ''[Symbol.iterator](), ''.matchAll(/x/g),
];

const own_descriptors = (object) => Reflect.ownKeys(object).map((key) =>
  ({ key, ...Object.getOwnPropertyDescriptor(object, key) }));

/** The values of the accessors that are properties of the scope, such as `performance`. */
function accessed(scope) {
  return own_descriptors(scope).filter(({ get }) => get).map(({ key }) => {
    try {
      return scope[key];
    } catch {
      return undefined;  // a sandboxed worker may not ask for some of them
    }
  });
}

/** All objects that code can reach from the scope and from the syntax. */
function reachable(scope) {
  const found = new Set([scope, ...nameless(), ...accessed(scope)].filter(is_object));
  for (const object of found) {  // a loop over a set also visits what is added
    const parts = own_descriptors(object).flatMap(({ value, get, set }) => [value, get, set]);
    [Object.getPrototypeOf(object), ...parts].filter(is_object).forEach((part) => found.add(part));
  }
  return found;
}

/**
 * Lets other objects hide the properties of a frozen prototype by assignment. Without this, `this.name = 'Mine'` throws
 * in the constructor of an error.
 */
function keep_assignable(prototype) {
  for (const { key, value, writable } of own_descriptors(prototype)) {
    if (writable && typeof key === 'string') {
      Object.defineProperty(prototype, key, {
        get: () => value,
        set(own) {
          if (this === prototype) {
            throw new TypeError(`the page does not let a solver change ${key} of a built-in prototype`);
          }
          Object.defineProperty(this, key, { value: own, writable: true, enumerable: true, configurable: true });
        },
      });
    }
  }
}

/**
 * Makes all built-in objects of this realm constant, and the global names that exist. Code that runs later can change
 * nothing that earlier code uses, unless it gets an object of that code. Later code can still define new globals.
 */
export function lock_down(scope = globalThis) {
  const errors = [Error, EvalError, RangeError, ReferenceError, SyntaxError, TypeError, URIError];
  [Object, Function, ...errors].forEach((type) => keep_assignable(type.prototype));
  const objects = reachable(scope);
  objects.delete(scope);
  objects.forEach((object) => Object.freeze(object));
  for (const { key, ...descriptor } of own_descriptors(scope)) {
    const constant = 'value' in descriptor ? { writable: false } : {};
    Object.defineProperty(scope, key, { ...descriptor, ...constant, configurable: false });
  }
}
