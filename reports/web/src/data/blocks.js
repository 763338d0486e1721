const ELEMENT_BYTES = { u8: 1, u32: 4, i32: 4, f32: 4 };

/**
 * The unpacked numbers of a page, block by block (see ../../README.md).
 */
export class Blob32 {
  /** @param {Uint8Array} bytes all of the unpacked data */
  constructor(bytes) {
    this.bytes = bytes;
  }

  /** Throws where a block does not lie within the data or is of no known kind. */
  check(block) {
    const size = ELEMENT_BYTES[block?.type];
    if (!size || !(block.order >= 0 && block.order <= 2))
      throw new Error('the page’s data have a block of an unknown kind');
    if (!(block.at >= 0 && block.count >= 0 && block.at + size * block.count <= this.bytes.length))
      throw new Error('the page’s data are cut short');
    return block;
  }

  /**
   * @param {{at: number, count: number, type: string, order: number, components?: number}} block
   * @returns {Uint8Array|Uint32Array|Int32Array|Float32Array}
   */
  numbers(block) {
    this.check(block);
    if (block.type === 'u8') return this.bytes.slice(block.at, block.at + block.count);
    const words = joinedPlanes(this.bytes, block.at, block.count);
    if (block.order > 0) undoDifferences(words, block.order, block.components ?? 1);
    if (block.type === 'f32') return new Float32Array(words.buffer);
    return block.type === 'i32' ? new Int32Array(words.buffer) : words;
  }

  /**
   * Multiples of a step as what they stand for.
   * @param {object} block of integers
   * @param {number} step mm or s
   * @returns {Float32Array}
   */
  multiples(block, step) {
    const whole = this.numbers(block);
    const out = new Float32Array(whole.length);
    for (let i = 0; i < whole.length; ++i) out[i] = whole[i] * step;
    return out;
  }
}

/** Little-endian words of which all lowest bytes stand first, then all second ones, ... */
function joinedPlanes(bytes, at, count) {
  const words = new Uint32Array(count);
  for (let i = 0; i < count; ++i)
    words[i] = bytes[at + i] | (bytes[at + count + i] << 8) | (bytes[at + 2 * count + i] << 16) |
      (bytes[at + 3 * count + i] << 24);
  return words;
}

/** Sums up zigzag-coded differences in place, modulo 2^32. */
function undoDifferences(words, order, components) {
  for (let i = 0; i < words.length; ++i) words[i] = (words[i] >>> 1) ^ -(words[i] & 1);
  for (let round = 0; round < order; ++round)
    for (let i = components; i < words.length; ++i) words[i] += words[i - components];
}
