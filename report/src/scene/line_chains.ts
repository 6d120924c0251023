// Lines out of a mesh's edges: a weld line arrives as edges between marked nodes and leaves as a smooth curve.

type Point = [number, number, number];

interface Edge {
  a: number;
  b: number;
  length: number;
}

/** A smooth line, and when the melt came to each of its points. */
export interface Chain {
  points: Point[];
  times: number[];
}

function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Gives equal points one number, and the edges between different points. */
function number_points(segments: Float32Array): { points: Point[]; edges: Edge[] } {
  const known = new Map<string, number>();
  const points: Point[] = [];
  const number_of = (at: number): number => {
    const point: Point = [segments[at]!, segments[at + 1]!, segments[at + 2]!];
    const key = point.join();
    if (!known.has(key)) known.set(key, points.push(point) - 1);
    return known.get(key)!;
  };
  const edges: Edge[] = [];
  for (let k = 0; k + 5 < segments.length; k += 6) {
    const [a, b] = [number_of(k), number_of(k + 3)];
    if (a !== b) edges.push({ a, b, length: distance(points[a]!, points[b]!) });
  }
  return { points, edges };
}

/** Keeps the shortest edges that hold together what hangs together (Kruskal): triangles of marked nodes open up. */
function span(count: number, edges: Edge[]): Set<number>[] {
  const parent = Array.from({ length: count }, (_unused, k) => k);
  const root = (k: number): number => {
    while (parent[k] !== k) {
      parent[k] = parent[parent[k]!]!;
      k = parent[k]!;
    }
    return k;
  };
  const neighbours = Array.from({ length: count }, () => new Set<number>());
  for (const { a, b } of [...edges].sort((one, other) => one.length - other.length)) {
    if (root(a) === root(b)) continue;
    parent[root(a)] = root(b);
    neighbours[a]!.add(b);
    neighbours[b]!.add(a);
  }
  return neighbours;
}

/** Cuts twigs of one edge off lines that go on. */
function prune(neighbours: Set<number>[]): void {
  const twigs = neighbours.map((near, k) => ({ near, k })).filter(({ near }) => near.size === 1 && neighbours[[...near][0]!]!.size > 2);
  for (const { near, k } of twigs) {
    const stem = [...near][0]!;
    if (neighbours[stem]!.size <= 2) continue;
    neighbours[stem]!.delete(k);
    near.clear();
  }
}

/** Walks from ends and branches to the next ones; rings of their own do not occur in a spanning forest. */
function walk(neighbours: Set<number>[]): number[][] {
  const chains: number[][] = [];
  neighbours.forEach((near, from) => {
    if (near.size === 0 || near.size === 2) return;
    for (const first of near) {
      const chain = [from, first];
      while (neighbours[chain.at(-1)!]!.size === 2) chain.push([...neighbours[chain.at(-1)!]!].find((k) => k !== chain.at(-2))!);
      // Every chain is met from both of its ends.
      if (chain[0]! < chain.at(-1)!) chains.push(chain);
    }
  });
  return chains;
}

/** Averages every value but the first and last with its neighbours, some times over. */
function smooth<Value>(values: Value[], mix: (before: Value, here: Value, after: Value) => Value): Value[] {
  let now = values;
  for (let pass = 0; pass < 6; ++pass) now = now.map((here, k) => (k === 0 || k === now.length - 1 ? here : mix(now[k - 1]!, here, now[k + 1]!)));
  return now;
}

/** Makes smooth lines out of edges, two points each. */
export function chain_edges(segments: Float32Array, time_of: (point: Point) => number): Chain[] {
  const { points, edges } = number_points(segments);
  const neighbours = span(points.length, edges);
  prune(neighbours);
  return walk(neighbours).map((chain) => {
    const places = chain.map((k) => points[k]!);
    return {
      points: smooth(places, (a, b, c) => b.map((value, k) => (a[k]! + 2 * value + c[k]!) / 4) as Point),
      times: places.map(time_of),
    };
  });
}
