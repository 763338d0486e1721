/**
 * The outline of a cutter from its tip up, [radius, height] in mm: where it is turned about its axis it
 * is the tool. Types as in job files; `null` where the figures make none.
 * @param {{type, diameter_mm, corner_radius_mm?, flute_length_mm?, taper_angle_deg?, tip_angle_deg?}} cutter
 */
export function cutterOutline(cutter, arcSteps = 12) {
  const radius = cutter?.diameter_mm / 2;
  if (!(radius > 0)) return null;
  const height = cutter.flute_length_mm > 0 ? cutter.flute_length_mm : 4 * radius;
  const rise = tangent(cutter.tip_angle_deg), lean = tangent(cutter.taper_angle_deg);
  const corner = Math.min(cutter.corner_radius_mm ?? 0, radius);
  if (cutter.type === 'drill' || cutter.type === 'apt')
    return ending([[0, 0], [radius, rise * radius]], lean, height);
  const outline = [[0, 0]];
  if (radius > corner) outline.push([radius - corner, 0]);
  // The rounding ends where it touches the side.
  const sweep = Math.PI / 2 - Math.atan(lean);
  for (let i = 1; corner > 0 && i <= arcSteps; ++i) {
    const angle = (sweep * i) / arcSteps;
    outline.push([radius - corner + corner * Math.sin(angle), corner * (1 - Math.cos(angle))]);
  }
  return ending(outline, lean, height);
}

const tangent = (degrees) => Math.tan(((degrees ?? 0) * Math.PI) / 180);

/**
 * The outlines of what holds the cutter, shank and holder, each part a cylinder on the one below; the lowest
 * stands on the cutter's outline.
 */
export function shaftOutlines(cutter) {
  let [, z] = cutterOutline(cutter)?.at(-1) ?? [0, 0];
  return [...(cutter?.shank ?? []), ...(cutter?.holder ?? [])].map(({ diameter_mm, length_mm }) => {
    const low = z, radius = diameter_mm / 2;
    z += length_mm;
    return [[0, low], [radius, low], [radius, z], [0, z]];
  });
}

/** `outline` with its side, which gains `lean` of radius for each mm of height, and its upper face. */
function ending(outline, lean, height) {
  const [radius, z] = outline[outline.length - 1];
  const top = Math.max(height, z);
  const wide = Math.max(0, radius + lean * (top - z));
  return [...outline, [wide, top], [0, top]];
}

/**
 * The body that `outline` sweeps when turned about Z, as wires: circles, and the outline at even angles.
 * @returns {{points: Float32Array, lines: Uint32Array}} lines as VTK has cells: count, vertices, ...
 */
export function wireBody(outline, { around = 32, meridians = 8, circles = 6 } = {}) {
  const points = [], lines = [];
  const wire = (vertices) => {
    lines.push(vertices.length, ...vertices.map((_, i) => points.length / 3 + i));
    points.push(...vertices.flat());
  };
  const at = (radius, z, turn) => {
    const angle = 2 * Math.PI * turn;
    return [radius * Math.cos(angle), radius * Math.sin(angle), z];
  };
  const rings = outline.filter(([radius]) => radius > 0);
  const every = Math.max(1, Math.ceil(rings.length / circles));
  rings.filter((_, i) => (rings.length - 1 - i) % every === 0).forEach(([radius, z]) =>
    wire(Array.from({ length: around + 1 }, (_, k) => at(radius, z, k / around))));
  for (let k = 0; k < meridians; ++k) wire(outline.map(([radius, z]) => at(radius, z, k / meridians)));
  return { points: Float32Array.from(points), lines: Uint32Array.from(lines) };
}

/** Several bodies of wires as one. */
export function joined(bodies) {
  const points = [], lines = [];
  for (const body of bodies) {
    const first = points.length / 3;
    for (let at = 0; at < body.lines.length; at += body.lines[at] + 1)
      lines.push(body.lines[at], ...body.lines.slice(at + 1, at + 1 + body.lines[at]).map((k) => first + k));
    points.push(...body.points);
  }
  return { points: Float32Array.from(points), lines: Uint32Array.from(lines) };
}

/**
 * Points [x, y, z, x, ...] of an upright body as they lie in the part's frame: `rotation` has the rows of
 * the turn from the part's frame to the one in which the tool stands along Z.
 */
export function standing(points, rotation) {
  const out = new Float32Array(points.length);
  for (let i = 0; i < points.length; i += 3)
    for (let axis = 0; axis < 3; axis += 1)
      out[i + axis] = rotation.reduce((sum, row, k) => sum + row[axis] * points[i + k], 0);
  return out;
}
