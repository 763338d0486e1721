/**
 * Base64 of zlib data, unpacked.
 * @param {string} text
 * @param {number} [expected] how many bytes the data must have
 * @returns {Promise<Uint8Array>}
 */
export async function unpack(text, expected) {
  if (typeof DecompressionStream === 'undefined')
    throw new Error('this browser is too old: it cannot unpack the page’s data');
  const bytes = await inflated(fromBase64(text.trim()));
  if (expected !== undefined && bytes.length !== expected)
    throw new Error('the page’s data are cut short');
  return bytes;
}

function fromBase64(text) {
  let binary;
  try {
    binary = atob(text);
  } catch {
    throw new Error('the page’s data are damaged or cut short');
  }
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(packed) {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  try {
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new Error('the page’s data are damaged or cut short');
  }
}
