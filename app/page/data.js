// The data of the page, as write_page stored them: typed arrays from base64, states from what
// changed in them.

function bytes(base64) {
  const binary = atob(base64);
  const result = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) result[i] = binary.charCodeAt(i);
  return result.buffer;
}

const integers = (base64) => new Uint32Array(bytes(base64));
const floats = (base64) => (base64 === null ? null : new Float32Array(bytes(base64)));

// Cells with some corners renamed; the same array when none is.
function renamed(cells, corners, vertices) {
  if (corners.length === 0) return cells;
  const result = cells.slice();
  for (let i = 0; i < corners.length; ++i) result[corners[i]] = vertices[i];
  return result;
}

function readState(stored, cells) {
  return {
    ...stored,
    cells: renamed(cells, integers(stored.renamedCorners), integers(stored.theirVertices)),
    displacement: floats(stored.displacement),
    opened: integers(stored.opened),
    shut: integers(stored.shut),
  };
}

/// Points are relative to `origin`, the middle of the body.
export function readData(text) {
  const stored = JSON.parse(text);
  const cells = integers(stored.cells);
  const cellNumbers =
      stored.cellNumbers === null ? null : new BigUint64Array(bytes(stored.cellNumbers));
  return {
    ...stored,
    cells,
    points: floats(stored.points),
    materialOfCell: integers(stored.materialOfCell),
    states: stored.states.map((state) => readState(state, cells)),
    cellNumber: (cell) => (cellNumbers ? cellNumbers[cell] : cell + 1).toString(),
  };
}

/// The largest length of a displacement in a state; 0 if it has none.
export function largestDisplacement(state) {
  const u = state.displacement;
  if (!u) return 0;
  let largest = 0;
  for (let i = 0; i < u.length; i += 3)
    largest = Math.max(largest, Math.hypot(u[i], u[i + 1], u[i + 2]));
  return largest;
}

/// A number in four digits, for people.
export function readable(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(2) : String(+value.toPrecision(4));
}

/// An outcome such as iteration_limit, for people.
export const inWords = (outcome) => outcome.replaceAll("_", " ");
