// A failure: a status of the library, with the offending element.

import { constants, elements, statuses } from "./tables.js";

/** A call of the library failed; nothing has changed. */
export class GussetError extends Error {
  constructor(message, status, { element = 0, index = 0n, value = 0, input = null, param = null } = {}) {
    super(message);
    this.name = new.target.name;
    this.status = status;
    this.code = statuses[status] ?? String(status);
    this.element = elements[element] ?? String(element);
    this.index = element ? Number(index) : null;
    this.value = element ? value : null;
    this.input = input;
    this.param = param;
  }
}

/** The input cannot be used; names its first offending element. */
export class InputError extends GussetError {}

/** Memory ran out. */
export class OutOfMemory extends GussetError {}

/** The call was cancelled. */
export class Cancelled extends GussetError {}

/** The library stopped: a mistake of its own. The loaded module cannot be used any more. */
export class Stopped extends GussetError {}

/** The error for a status. */
export function errorFor(status, message, at) {
  const kinds = { [constants.PLUGIN_OUT_OF_MEMORY]: OutOfMemory, [constants.PLUGIN_CANCELLED]: Cancelled, [constants.ERROR_PANIC]: Stopped };
  return new (kinds[status] ?? InputError)(message, status, at);
}
