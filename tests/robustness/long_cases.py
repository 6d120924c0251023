"""Small cases of every study that runs long, for campaigns that kill runs or let two of them meet."""
import math
import random
from dataclasses import dataclass, field


@dataclass
class LongCase:
    """A case, the files that it reads, and the group that campaigns count it in."""
    name: str
    group: str  # cell, other or molding
    text: str
    files: dict = field(default_factory=dict)
    takes_threads: bool = True

    def write(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in {**self.files, "case.toml": self.text}.items():
            (folder / name).write_text(text, encoding="utf-8")
        return folder / "case.toml"

    def words(self, threads):
        return ["--threads", str(threads)] if self.takes_threads else []


def straight_fibers(fibers=30, rods=10, rod_length=60e-6, cell=0.5e-3, seed=3):
    """Gives a fibers.csv of straight fibers that lie anywhere in the cell."""
    chance, rows = random.Random(seed), ["fiber,x_m,y_m,z_m"]
    for fiber in range(fibers):
        direction = [chance.gauss(0, 1) for _ in range(3)]
        norm = math.sqrt(sum(x * x for x in direction))
        begin = [chance.uniform(0, cell) for _ in range(3)]
        rows += [",".join([str(fiber), *(repr(b + node * rod_length * d / norm) for b, d in zip(begin, direction))]) for node in range(rods + 1)]
    return "\n".join(rows) + "\n"


CELL = """study = "shear_cell"
[run]
duration = "60 ms"
seed = 7
[cell]
size = "0.5 mm"
[fibers]
diameter = "19 um"
youngs_modulus = "10 GPa"
[cluster]
source = "file"
file = "fibers.csv"
[flow]
rate = "200 1/s"
viscosity = "1000 Pa s"
[breakage]
law = "probability"
check_interval = "1 ms"
[output]
interval = "0.5 ms"
frame_interval = "2 ms"
checkpoint_interval = "0.02 s"
"""

PACKED = """study = "shear_cell"
[run]
duration = "40 ms"
[cell]
size = ["0.6 mm", "0.5 mm", "0.5 mm"]
[fibers]
diameter = "19 um"
youngs_modulus = "20 GPa"
rod_length = "0.08 mm"
volume_fraction = "4 %"
[fibers.length_histogram]
edges = ["0.1 mm", "0.3 mm", "0.5 mm"]
heights = [2, 1]
[cluster]
overlap_tolerance = 0.05
orientation_tolerance = 1
[flow]
kind = "ramp"
rate = "200 1/s"
ramp_duration = "20 ms"
viscosity = "800 Pa s"
[breakage]
law = "strength"
[output]
interval = "0.5 ms"
frame_interval = "1 ms"
checkpoint_interval = "0.01 s"
"""

CLUSTER = """study = "cluster"
[cell]
size = ["1 mm", "1 mm", "0.6 mm"]
[boundary]
y = "walls"
[fibers]
diameter = "19 um"
youngs_modulus = "73 GPa"
density = "2550 kg/m3"
rod_length = "0.1 mm"
weight_fraction = "25 %"
length = "0.9 mm"
[matrix]
density = "905 kg/m3"
[cluster]
orientation = [0.6, 0.1, 0.3]
"""

ORIENTATION = """study = "orientation"
[diffusion]
name = "folgar_tucker"
C_I = 0.02
[flow]
rate = "1 1/s"
[solution]
distribution = "yes"
degree = 40
[run]
duration = "12 s"
[output]
interval = "0.02 s"
"""

ATTRITION = """study = "attrition"
[law]
name = "durin"
C_B = 0.02
zeta = 3
S = 0.25
[melt]
eta_0 = "200 Pa s"
[flow]
rate = "100 1/s"
[fibers]
length = "10 mm"
bins = 800
[run]
duration = "20 s"
[output]
interval = "0.02 s"
"""

CALIBRATION = """study = "calibration"
[law]
name = "unbreakable_length"
lambda = 0.06
xi = 1e-3
[fibers]
form = "means"
[conditions]
names = ["slow", "fast"]
rates = ["20 1/s", "180 1/s"]
viscosities = ["60 Pa s", "33 Pa s"]
lengths = ["10 mm"]
[data]
series = [["slow", "L_N", "slow.csv"], ["fast", "L_N", "fast.csv"]]
relative_uncertainty = 0.05
[fit]
free = ["xi", "lambda"]
bootstrap = 5000
"""
CURVES = {"slow.csv": "time_s,L_N_m\n2,0.00951\n5,0.0083\n10,0.0069\n20,0.0047\n40,0.0025\n80,0.0017\n",
          "fast.csv": "time_s,L_N_m\n2,0.00612364\n5,0.00325614\n10,0.00131923\n20,0.00067344\n40,0.000673885\n80,0.00062978\n"}

GATES = """study = "molding"
[part]
kind = "plaque"
length = "100 mm"
width = "50 mm"
thickness = "2 mm"
mesh_size = "5 mm"
gate = "given"
[gates]
places = [["left", "0 mm", "25 mm"], ["right", "100 mm", "25 mm"]]
sensors = [["S1", "50 mm", "25 mm"]]
valves = [["right", "start", "filled 0.4", "sensor S1 0.01 s"]]
[material]
preset = "ppgf30"
[machine]
fill_time = "1 s"
switchover = 0.97
melt_temperature = "523.15 K"
mold_temperature = "323.15 K"
[fibers]
length = "3 mm"
[numerics]
layers = 8
steps = 120
[output]
frames = 40
places = [["P1", "90 mm", "10 mm"], ["P2", "50 mm", "25 mm"]]
checkpoint_interval = "1 ms"
"""


def changed(text, *changes):
    """Replaces parts of a case, each of which must be there."""
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text


def cells():
    fibers = {"fibers.csv": straight_fibers()}
    walls = changed(PACKED, ('[breakage]\nlaw = "strength"', '[boundary]\ny = "walls"\n[contact]\nfriction = 0.5\n[breakage]\nlaw = "fixed"'))
    table = changed(CELL, ('rate = "200 1/s"\nviscosity = "1000 Pa s"', 'kind = "table"\ntable = [["20 ms", "250 1/s", "1000 Pa s"], '
                           '["35 ms", "50 1/s", "3000 Pa s"], ["60 ms", "300 1/s", "500 Pa s"]]'))
    return [LongCase("cell", "cell", CELL, fibers), LongCase("cell with walls", "cell", walls),
            LongCase("cell, flow of a table", "cell", table, fibers), LongCase("cell, packed", "cell", PACKED)]


def others():
    relaxed = CLUSTER + '[relaxation]\nduration = "20 ms"\nrate = "5 1/s"\nminimum_radius = "1 m"\n'
    separately = changed(CALIBRATION, ('free = ["xi", "lambda"]', 'free = ["xi", "lambda"]\nstarts = 3\nscope = "separately"'))
    return [LongCase("cluster", "other", CLUSTER), LongCase("cluster, relaxed", "other", relaxed),
            LongCase("orientation", "other", ORIENTATION, takes_threads=False), LongCase("attrition", "other", ATTRITION, takes_threads=False),
            LongCase("calibration", "other", CALIBRATION, CURVES, takes_threads=False),
            LongCase("calibration, separate", "other", separately, CURVES, takes_threads=False)]


def moldings():
    sequence = changed(GATES, ('["right", "start", "filled 0.4", "sensor S1 0.01 s"]', '["left", "start", "filled 0.65", "time 0.8 s"], '
                               '["right", "sensor S1", "filled 0.85", "filled 0.93"]'))
    frozen = changed(GATES, ("fill_time = \"1 s\"", 'fill_time = "6 s"'), ('thickness = "2 mm"', 'thickness = "1 mm"'), ('"323.15 K"', '"293.15 K"'))
    limited = changed(GATES, ("switchover = 0.97", 'switchover = 0.6\npressure_limit = "6 MPa"\nlongest_time = "2 s"'))
    runners = changed(GATES, ('valves = [["right", "start", "filled 0.4", "sensor S1 0.01 s"]]',
                              'resistances = [["left", "1e10 Pa s/m^3"], ["right", "4e10 Pa s/m^3"]]\nvalves = [["right", "filled 0.1", "filled 0.3", "filled 0.6"]]\n'
                              'inlet_lengths = [["right", "2 mm"]]'))
    phelps = changed(GATES, ("[fibers]", '[compare]\nname = "phelps"\nC_B = 0.02\nzeta = 3\nS = 0.25\n[fibers]'),
                     ('length = "3 mm"\n[num', 'distribution = [["1 mm", 400], ["2 mm", 250], ["4 mm", 120]]\n[num'))
    coupled = changed(GATES, ('length = "3 mm"\n[num', 'length = "3 mm"\ncoupling = "informed_isotropic"\n[num'))
    texts = {"gate reopens": GATES, "valve sequence": sequence, "freezes off": frozen, "pressure limit": limited, "runners": runners,
             "two length laws": phelps, "coupled flow": coupled}
    return [LongCase("molding, " + name, "molding", text) for name, text in texts.items()]


def all_cases():
    return cells() + others() + moldings()
