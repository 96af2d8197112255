// Half-facets, as everywhere in Cleave: h = 4 * cell + i is the facet opposite the cell's i-th
// vertex.

export const SKIN = 0, INSIDE = 1, OPENED = 2, SHUT = 3;

// The local vertices of each facet, seen from outside a positively oriented cell.
const FACET = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// The mate of every half-facet, -1 on the boundary. A hash table of facets, open addressing.
export function findMates(cells) {
  const count = cells.length;
  let size = 1;
  while (size < 2 * count) size *= 2;
  const table = new Int32Array(size).fill(-1);
  const mates = new Int32Array(count).fill(-1);
  const low = new Uint32Array(count), middle = new Uint32Array(count),
        high = new Uint32Array(count);
  for (let h = 0; h < count; ++h) {
    const first = h - (h & 3), facet = FACET[h & 3];
    const a = cells[first + facet[0]], b = cells[first + facet[1]], c = cells[first + facet[2]];
    const l = Math.min(a, b, c), u = Math.max(a, b, c);
    low[h] = l;
    high[h] = u;
    middle[h] = a + b + c - l - u;
    let at = (Math.imul(l, 73856093) ^ Math.imul(middle[h], 19349663) ^ Math.imul(u, 83492791)) &
        (size - 1);
    for (; table[at] >= 0; at = (at + 1) & (size - 1)) {
      const other = table[at];
      if (low[other] !== l || middle[other] !== middle[h] || high[other] !== u) continue;
      mates[h] = other;
      mates[other] = h;
      break;
    }
    if (table[at] < 0) table[at] = h;
  }
  return mates;
}

/// The three corners of a half-facet, in order seen from outside.
export function facetCorners(mesh, h, corners) {
  const first = h - (h & 3), facet = FACET[h & 3], flipped = mesh.negative[first >> 2];
  corners[0] = first + facet[0];
  corners[1] = first + facet[flipped ? 2 : 1];
  corners[2] = first + facet[flipped ? 1 : 2];
}

/// What does not change in a run: mates, orientation, centroids and extent of the body at rest.
export function readMesh(cells, points) {
  const count = cells.length / 4;
  const negative = new Uint8Array(count), centroids = new Float32Array(3 * count);
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let c = 0; c < count; ++c) {
    const o = 3 * cells[4 * c], p = 3 * cells[4 * c + 1], q = 3 * cells[4 * c + 2],
          r = 3 * cells[4 * c + 3];
    const edge = (v, axis) => points[v + axis] - points[o + axis];
    const volume = edge(p, 0) * (edge(q, 1) * edge(r, 2) - edge(q, 2) * edge(r, 1)) -
        edge(p, 1) * (edge(q, 0) * edge(r, 2) - edge(q, 2) * edge(r, 0)) +
        edge(p, 2) * (edge(q, 0) * edge(r, 1) - edge(q, 1) * edge(r, 0));
    negative[c] = volume < 0 ? 1 : 0;
    for (let axis = 0; axis < 3; ++axis) {
      const s = points[o + axis], t = points[p + axis], u = points[q + axis], v = points[r + axis];
      centroids[3 * c + axis] = 0.25 * (s + t + u + v);
      low[axis] = Math.min(low[axis], s, t, u, v);
      high[axis] = Math.max(high[axis], s, t, u, v);
    }
  }
  return {cells, points, mates: findMates(cells), negative, centroids, low, high, cellCount: count};
}

/// Per half-facet: OPENED, SHUT or 0, both sides of each scored facet.
export function scoredFacets(mesh, states) {
  const scored = new Uint8Array(mesh.cells.length);
  const mark = (halfFacets, kind) => {
    for (const h of halfFacets) {
      scored[h] = kind;
      if (mesh.mates[h] >= 0) scored[mesh.mates[h]] = kind;
    }
  };
  for (const state of states) mark(state.shut, SHUT);
  for (const state of states) mark(state.opened, OPENED);
  return scored;
}

/// Per cell: 1 if its centroid lies beyond the plane. `at` runs from 0 to 1 through the body.
export function cellsBeyond(mesh, {axis, at, flip}) {
  const hidden = new Uint8Array(mesh.cellCount);
  const a = "xyz".indexOf(axis);
  if (a < 0) return hidden;
  const plane = mesh.low[a] + at * (mesh.high[a] - mesh.low[a]);
  for (let c = 0; c < mesh.cellCount; ++c)
    hidden[c] = (mesh.centroids[3 * c + a] > plane) !== flip ? 1 : 0;
  return hidden;
}

/// The facets to draw: of visible cells, those without mate, opened, or with the mate's cell
/// hidden.
export function visibleFacets(mesh, scored, hidden) {
  const facets = [], kinds = [];
  for (let h = 0; h < scored.length; ++h) {
    if (hidden[h >> 2]) continue;
    const mate = mesh.mates[h];
    let kind;
    if (mate < 0) kind = SKIN;
    else if (scored[h] === OPENED) kind = OPENED;
    else if (hidden[mate >> 2]) kind = scored[h] || INSIDE;
    else continue;
    facets.push(h);
    kinds.push(kind);
  }
  return {facets, kinds};
}

/// Edges of opened and of shut facets, and the vertices they have: rim(a, b) is their kind or 0.
export function incisionEdges(mesh, scored) {
  const edges = new Map(), touched = new Uint8Array(mesh.points.length / 3);
  const key = (a, b) => Math.min(a, b) * 4294967296 + Math.max(a, b);
  const corners = [0, 0, 0];
  for (let h = 0; h < scored.length; ++h) {
    if (!scored[h]) continue;
    facetCorners(mesh, h, corners);
    const v = corners.map((corner) => mesh.cells[corner]);
    for (let i = 0; i < 3; ++i) {
      touched[v[i]] = 1;
      const edge = key(v[i], v[(i + 1) % 3]);
      if (edges.get(edge) !== OPENED) edges.set(edge, scored[h]);
    }
  }
  return (a, b) => (touched[a] && touched[b] && edges.get(key(a, b))) || 0;
}
