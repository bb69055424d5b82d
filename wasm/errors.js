// A failure: a status of the library, with the offending element.

import { constants, elements, fileStatuses, statuses } from "./tables.js";

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

/** A file or document breaks a rule, or the format is unknown or cannot hold the document. */
export class FileError extends GussetError {
  constructor(message, status) {
    super(message, status);
    this.code = fileStatuses[status] ?? String(status);
  }
}

/** Memory ran out. */
export class OutOfMemory extends GussetError {}

/** The call was cancelled. */
export class Cancelled extends GussetError {}

/** The library stopped: a mistake of its own. The loaded module cannot be used any more. */
export class Stopped extends GussetError {}

/** The error for a status of the table of files. */
export function fileErrorFor(status, message) {
  const kinds = {
    [constants.FILES_OUT_OF_MEMORY]: [OutOfMemory, constants.PLUGIN_OUT_OF_MEMORY], [constants.FILES_INTERNAL]: [Stopped, constants.ERROR_PANIC],
  };
  const [kind, number] = kinds[status] ?? [FileError, status];
  return new kind(message, number);
}

/** The error for a status. */
export function errorFor(status, message, at) {
  const kinds = { [constants.PLUGIN_OUT_OF_MEMORY]: OutOfMemory, [constants.PLUGIN_CANCELLED]: Cancelled, [constants.ERROR_PANIC]: Stopped };
  return new (kinds[status] ?? InputError)(message, status, at);
}
