// Jobs for the program native.c, and its answers.

import { spawnSync } from "node:child_process";
import { Curves, Mesh, Report } from "../gusset.js";
import { constants } from "../tables.js";

/** The program; `make wasm` builds it. */
export const program = process.env.GUSSET_NATIVE;

class Writer {
  parts = [];
  number(value) {
    this.parts.push(Buffer.from(Uint32Array.of(value).buffer));
  }
  double(value) {
    this.parts.push(Buffer.from(Float64Array.of(value).buffer));
  }
  array(values) {
    this.parts.push(Buffer.from(values.buffer, values.byteOffset, values.byteLength));
  }
  text(text) {
    this.number(Buffer.byteLength(text));
    this.parts.push(Buffer.from(text));
  }
}

class Reader {
  at = 0;
  constructor(bytes) {
    this.bytes = bytes;
  }
  take(size) {
    this.at += size;
    return this.bytes.subarray(this.at - size, this.at);
  }
  number() {
    return this.take(4).readUInt32LE();
  }
  double() {
    return this.take(8).readDoubleLE();
  }
  array(kind, length) {
    return new kind(Uint8Array.from(this.take(kind.BYTES_PER_ELEMENT * length)).buffer);
  }
  text() {
    return this.take(this.number()).toString("utf8");
  }
}

const isMesh = (one) => one instanceof Mesh;
const realsOf = (scalar) => (scalar === constants.PLUGIN_F32 ? Float32Array : Float64Array);

function write(to, { filter, inputs, params = {} }) {
  to.text(filter.id);
  to.number(inputs.length);
  for (const one of inputs) {
    const points = isMesh(one) ? one.positions : one.points, offsets = isMesh(one) ? one.faces.offsets : one.offsets;
    to.number(isMesh(one) ? constants.KIND_MESH : constants.KIND_CURVES);
    to.number(points instanceof Float32Array ? constants.PLUGIN_F32 : constants.PLUGIN_F64);
    to.number(points.length / 3);
    to.array(points);
    to.number(offsets.length - 1);
    to.array(offsets);
    if (isMesh(one)) {
      to.number(one.faces.corners.length);
    }
    to.array(isMesh(one) ? one.faces.corners : one.closed);
  }
  const values = Object.entries(params).flatMap(([id, value]) => {
    const param = filter.params.find((one) => one.id === id);
    const numbers = typeof value === "string" ? [param.choices.findIndex((choice) => choice.word === value)] : [value].flat().map(Number);
    return numbers.map((number, k) => [param.first + k, number]);
  });
  to.number(values.length);
  values.forEach(([place, value]) => (to.number(place), to.double(value)));
}

function output(from) {
  const kind = from.number();
  if (kind === constants.KIND_TEXT) {
    const text = from.text();
    return new Report(text, Object.fromEntries(Array.from({ length: from.number() }, () => {
      const [name, value, kind] = [from.text(), from.double(), from.number()];
      return [name, kind === constants.VALUE_FLAG ? value !== 0 : value];
    })));
  }
  const points = from.array(realsOf(from.number()), 3 * from.number()), count = from.number(), offsets = from.array(Uint32Array, count + 1);
  return kind === constants.KIND_MESH ? Mesh.of(points, offsets, from.array(Uint32Array, from.number())) : Curves.of(points, offsets, from.array(Uint8Array, count));
}

function answer(from) {
  const status = from.number(), found = { status };
  if (status === 0) {
    found.outputs = Array.from({ length: from.number() }, () => output(from));
  } else {
    const [element, param, input] = [from.number(), from.number(), from.number()];
    Object.assign(found, { element, param, input, index: Number(from.take(8).readBigUInt64LE()), value: from.double(), message: from.text() });
  }
  found.seconds = from.double();
  return found;
}

/** The answers of the native library to jobs. A job has a filter, meshes and curves as inputs, and parameters. */
export function natively(jobs) {
  const to = new Writer();
  jobs.forEach((job) => write(to, job));
  const { status, stdout, stderr, error } = spawnSync(program, { input: Buffer.concat(to.parts), maxBuffer: 1 << 30 });
  if (error || status !== 0) {
    throw error ?? new Error(`${program}: ${stderr}`);
  }
  const from = new Reader(stdout);
  return jobs.map(() => answer(from));
}
