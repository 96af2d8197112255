// Colours of the body. Strings are sRGB.

// Viridis (S. van der Walt, N. Smith; CC0): perceptually uniform, readable by the colour-blind.
const VIRIDIS = ["#440154", "#482878", "#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779",
  "#6ece58", "#b5de2b", "#fde725"];

export const OPENED_COLOUR = "#ff5a2c", SHUT_COLOUR = "#d63cf0", PLAIN_COLOUR = "#c9b4a0";

// Muted, told apart in both themes and by most kinds of colour vision.
const MATERIALS = ["#b5654a", "#5b8db8", "#d9b44a", "#6d9f71", "#9a78b0", "#d98a6a", "#4f9c9c",
  "#b0577a", "#8a8f5c", "#7a86c2"];

export const materialColour = (material) => MATERIALS[material % MATERIALS.length];

export function parts(colour) {
  const value = parseInt(colour.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/// `count` RGBA entries of the map, 4 bytes each.
export function viridisTable(count) {
  const table = new Uint8Array(4 * count), stops = VIRIDIS.map(parts);
  for (let i = 0; i < count; ++i) {
    const at = i / (count - 1) * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
    for (let j = 0; j < 3; ++j)
      table[4 * i + j] = Math.round(stops[k][j] + (at - k) * (stops[k + 1][j] - stops[k][j]));
    table[4 * i + 3] = 255;
  }
  return table;
}

export const viridisGradient = `linear-gradient(to right, ${VIRIDIS.join(", ")})`;
