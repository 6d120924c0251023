// The lattice of a cell in simple shear along x: its tilt, its window, and the images of points.

export type Three = [number, number, number];

/** A box that keeps its place while the melt flows through it: what the reader sees of the periodic pattern. */
export interface CellWindow {
  low: Three;
  size: Three;
  /** From its home to where it is: what it shows is drawn at home, in front of a camera that rests. */
  shift: Three;
}

export interface Lattice {
  /** Row-major; columns are the lattice vectors [m]. */
  lattice: number[];
  origin: Three;
  periodic: boolean[];
}

/** Inverts a 3 by 3 row-major matrix; nothing for a cell without volume. */
export function invert(m: number[]): number[] | undefined {
  const [a, b, c, d, e, f, g, h, i] = m as [number, number, number, number, number, number, number, number, number];
  const determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  if (!(Math.abs(determinant) > 0)) return undefined;
  return [
    e * i - f * h, c * h - b * i, b * f - c * e,
    f * g - d * i, a * i - c * g, c * d - a * f,
    d * h - e * g, b * g - a * h, a * e - b * d,
  ].map((cofactor) => cofactor / determinant);
}

export function times(m: number[], x: Three): Three {
  return [0, 3, 6].map((row) => m[row]! * x[0] + m[row + 1]! * x[1] + m[row + 2]! * x[2]) as Three;
}

export function has_cell({ lattice }: Lattice): boolean {
  return lattice.length === 9 && invert(lattice) !== undefined;
}

type Columns = [Three, Three, Three];

/** Subtracts columns from each other until only one of some has a component along an axis (Euclid); gives that one. */
function gather(columns: Three[], axis: number, nothing: number): Three | undefined {
  for (let step = 0; step < 200; ++step) {
    const left = columns.filter((column) => Math.abs(column[axis]!) > nothing).sort((a, b) => Math.abs(a[axis]!) - Math.abs(b[axis]!));
    if (left.length <= 1) return left[0];
    const [least, next] = left as [Three, Three];
    const turns = Math.round(next[axis]! / least[axis]!);
    for (const k of [0, 1, 2] as const) next[k] -= turns * least[k];
  }
  return undefined;
}

/**
 * Gives the upright basis of a lattice: vectors along x, in the plane of x and y, and any. Programs keep the shortest
 * basis, which leans when a long cell is sheared; the lattice, and so the picture, is the same.
 */
export function make_upright(lattice: number[]): number[] {
  const size = Math.max(...lattice.map(Math.abs));
  const columns = [0, 1, 2].map((column) => [0, 3, 6].map((row) => lattice[row + column]!) as Three) as Columns;
  const third = gather(columns, 2, 1e-9 * size);
  const flat = columns.filter((column) => column !== third);
  const second = gather(flat, 1, 1e-9 * size);
  const first = flat.find((column) => column !== second);
  if (!first || !second || !third) return lattice;
  // A lattice that stretches has no upright basis but for one that round-off makes, of vectors without end.
  if ([first, second, third].some((column) => Math.hypot(...column) > 100 * size)) return lattice;
  const upright = [first, second, third].map((column, axis) => (column[axis]! < 0 ? column.map((value) => -value) : column)) as Columns;
  // What Euclid leaves below the diagonal is round-off.
  const entry = (row: number, column: number): number => (row > column ? 0 : upright[column]![row]!);
  return [0, 1, 2].flatMap((row) => [0, 1, 2].map((column) => entry(row, column)));
}

/** Tells whether shear along x has made this lattice out of a box: then the box is a window onto it. */
function is_sheared_box(cell: Lattice): boolean {
  const { lattice: h } = cell;
  const size = Math.max(...h.map(Math.abs));
  const nothing = (value: number): boolean => Math.abs(value) <= 1e-9 * size;
  return has_cell(cell) && nothing(h[3]!) && nothing(h[6]!) && nothing(h[7]!) && h[0]! > 0 && h[4]! > 0 && h[8]! > 0;
}

export function window_of(cell: Lattice): CellWindow | undefined {
  if (!is_sheared_box(cell)) return undefined;
  return { low: [...cell.origin], size: [cell.lattice[0]!, cell.lattice[4]!, cell.lattice[8]!], shift: [0, 0, 0] };
}

/** Moves a window so that a point is in its middle; directions that end at walls keep their place. */
export function centre_window(cell: Lattice, window: CellWindow, point: Three): CellWindow {
  const shift = point.map((value, k) => (cell.periodic[k] ? value - cell.origin[k]! - window.size[k]! / 2 : 0)) as Three;
  return { ...window, low: cell.origin.map((value, k) => value + shift[k]!) as Three, shift };
}

/** Gives the lattice after a further strain: its vectors flow with the melt. */
export function shear_lattice(lattice: number[], strain: number): number[] {
  const sheared = [...lattice];
  for (const column of [0, 1, 2]) sheared[column] = lattice[column]! + strain * lattice[3 + column]!;
  return sheared;
}

/** Gives the shortest of a displacement and its images, axis by axis from z down. */
export function nearest_image(cell: Lattice, displacement: Three): Three {
  const { lattice: h, periodic } = cell;
  const d: Three = [...displacement];
  for (const axis of [2, 1, 0] as const) {
    const along = h[4 * axis]!;
    const cells = periodic[axis] && along !== 0 ? Math.round(d[axis] / along) : 0;
    for (const k of [0, 1, 2] as const) d[k] -= cells * h[3 * k + axis]!;
  }
  return d;
}
