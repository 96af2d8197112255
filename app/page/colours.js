// Colours of the body. Strings are sRGB.

// The map of displacement runs from pale to deep through places in Oklab (B. Ottosson 2020):
// lightness, then green-red and blue-yellow. Entries are equally far apart there, so equal
// differences look equal; lightness only falls, so it reads without colour too; orange is left to
// the incision.
const PLACES = [
  [0.945, 0.000, 0.045], [0.80, -0.095, 0.025], [0.63, -0.075, -0.070], [0.46, 0.010, -0.140],
  [0.30, 0.075, -0.110]
];

export const OPENED_COLOUR = "#ff5a2c", SHUT_COLOUR = "#d63cf0", PLAIN_COLOUR = "#c9b4a0";

// Muted, told apart in both themes and by most kinds of colour vision; none near the incision's.
const MATERIALS = [
  "#c69c8d", "#5b86b4", "#cdb25a", "#6f9d7d", "#9b83b8", "#55999c", "#a9708f", "#8f9464", "#7f8fc9",
  "#a08a78"
];

export const materialColour = (material) => MATERIALS[material % MATERIALS.length];

function fromOklab([lightness, a, b]) {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.2914855480 * b) ** 3;
  const linear = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s
  ];
  const encode = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
  return linear.map((x) => Math.round(255 * encode(Math.min(Math.max(x, 0), 1))));
}

// A smooth curve through PLACES (Catmull and Rom); t from 0 to 1.
function onCurve(t) {
  const last = PLACES.length - 1, k = Math.min(Math.floor(t * last), last - 1), s = t * last - k;
  const at = (i) => PLACES[Math.min(Math.max(i, 0), last)];
  return [0, 1, 2].map((j) => {
    const [p, q, r, u] = [at(k - 1)[j], at(k)[j], at(k + 1)[j], at(k + 2)[j]];
    return q + 0.5 * s * (r - p + s * (2 * p - 5 * q + 4 * r - u + s * (3 * (q - r) + u - p)));
  });
}

/// `count` RGBA entries of the map, 4 bytes each.
export function displacementColours(count) {
  const fine = 1000, lengths = [0];
  for (let i = 1; i <= fine; ++i) {
    const p = onCurve((i - 1) / fine), q = onCurve(i / fine);
    lengths.push(lengths[i - 1] + Math.hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
  }
  const table = new Uint8Array(4 * count);
  for (let i = 0, k = 0; i < count; ++i) {
    while (k < fine && lengths[k] < i / (count - 1) * lengths[fine]) ++k;
    table.set([...fromOklab(onCurve(k / fine)), 255], 4 * i);
  }
  return table;
}

export function displacementGradient() {
  const table = displacementColours(24), stops = [];
  for (let i = 0; i < table.length; i += 4)
    stops.push(`rgb(${table[i]} ${table[i + 1]} ${table[i + 2]})`);
  return `linear-gradient(to right, ${stops.join(", ")})`;
}
