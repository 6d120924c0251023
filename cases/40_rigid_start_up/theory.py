#!/usr/bin/env python3
"""Prints the theory of rigid fibers that never touch beside what a run of this case gave.

    theory.py RESULT

An isotropic population keeps its distribution function in closed form: a direction p0 becomes exp(B t) p0 / |exp(B t) p0|
with B = W + Lambda D. Its moments come from a quadrature over the sphere; the stress is
n zeta S2 [Lambda A4:D + (1 - Lambda)/2 (A2.D + D.A2)] (docs/theory/stress.md).
"""
import csv
import math
import sys
import tomllib
from pathlib import Path

RADIUS, BEADS = 5e-6, 20
LAMBDA = (BEADS**2 - 1) / (BEADS**2 + 3)
VOLUME_FRACTION = 0.01


def sphere(rings=120):
    """Yields directions with weights that add up to one: a midpoint rule in height and angle."""
    for i in range(rings):
        z = -1 + (i + 0.5) * 2 / rings
        r = math.sqrt(1 - z * z)
        for j in range(2 * rings):
            angle = math.pi * (j + 0.5) / rings
            yield (r * math.cos(angle), r * math.sin(angle), z), 1 / (2 * rings * rings)


def deformation(kind, strain):
    """exp(B t) for shear u_x = y or planar elongation at the rate 1."""
    if kind == "planar":
        return lambda p: (p[0] * math.exp(LAMBDA * strain), p[1] * math.exp(-LAMBDA * strain), p[2])
    b12, b21 = (1 + LAMBDA) / 2, (LAMBDA - 1) / 2
    q = math.sqrt(-b12 * b21)
    c, s = math.cos(q * strain), math.sin(q * strain)
    return lambda p: (c * p[0] + b12 * s / q * p[1], b21 * s / q * p[0] + c * p[1], p[2])


def relative_viscosity(kind, strain):
    """1 + stress:D / (2 eta D:D) of the whole population, and A11."""
    d = (1, -1, 0, 0) if kind == "planar" else (0, 0, 0, 0.5)  # 11, 22, 33, 12
    squared = d[0] ** 2 + d[1] ** 2 + d[2] ** 2 + 2 * d[3] ** 2
    turn, along, across, a11 = deformation(kind, strain), 0.0, 0.0, 0.0
    for p0, weight in sphere():
        p = turn(p0)
        norm = math.sqrt(sum(x * x for x in p))
        x, y, z = (c / norm for c in p)
        dp = (d[0] * x + d[3] * y, d[3] * x + d[1] * y, d[2] * z)
        stretch = x * dp[0] + y * dp[1] + z * dp[2]
        along += weight * stretch**2
        across += weight * sum(c * c for c in dp)
        a11 += weight * x * x
    moment = 6 * math.pi * RADIUS * RADIUS**2 * BEADS * (BEADS**2 - 1) / 3  # zeta S2 over the viscosity
    number = VOLUME_FRACTION / (2 * math.pi * RADIUS**3 * BEADS)
    return 1 + number * moment * (LAMBDA * along + (1 - LAMBDA) * across) / (2 * squared), a11


def main():
    folder = Path(sys.argv[1])
    kind = tomllib.loads((folder / "case.resolved.toml").read_text(encoding="utf-8"))["flow"]["type"]
    with open(folder / "series.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    print("strain   viscosity  theory   a11     theory")
    worst = 0.0
    for row in rows[1 :: max(1, len(rows) // 12)]:
        strain, step = float(row["strain"]), float(rows[1]["strain"])
        # A row has the mean since the row before.
        viscosity, _ = relative_viscosity(kind, strain - step / 2)
        _, a11 = relative_viscosity(kind, strain)
        found = float(row["relative_viscosity"])
        worst = max(worst, abs(found / viscosity - 1))
        print(f"{strain:6.2f}   {found:.4f}    {viscosity:.4f}   {float(row['a11']):.4f}  {a11:.4f}")
    print(f"largest difference of the viscosity: {100 * worst:.2f} %")


if __name__ == "__main__":
    main()
