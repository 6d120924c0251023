"""Hostile but legal cases: for each study a small case, and lines of "name | key=value ; key=value" that change it."""

BASES = {
    "shear_cell": """study = "shear_cell"
[run]
duration = "5 ms"
[cell]
size = "0.5 mm"
[fibers]
diameter = "19 um"
youngs_modulus = "73 GPa"
length = "0.3 mm"
rod_length = "0.1 mm"
count = 8
[cluster]
step_limit = 2000
orientation_tolerance = 1
[flow]
rate = "200 1/s"
viscosity = "200 Pa s"
""",
    "cluster": """study = "cluster"
[cell]
size = "0.5 mm"
[fibers]
diameter = "19 um"
youngs_modulus = "73 GPa"
length = "0.3 mm"
rod_length = "0.1 mm"
volume_fraction = "5 %"
[cluster]
step_limit = 2000
orientation_tolerance = 0.1
""",
    "orientation": """study = "orientation"
[diffusion]
name = "folgar_tucker"
C_I = 0.01
[flow]
rate = "1 1/s"
[run]
duration = "20 s"
[output]
interval = "1 s"
""",
    "attrition": """study = "attrition"
[law]
name = "unbreakable_length"
lambda = 0.1
xi = 1e-3
[melt]
eta_0 = "200 Pa s"
[flow]
rate = "100 1/s"
[fibers]
length = "10 mm"
bins = 50
[run]
duration = "20 s"
""",
    "molding": """study = "molding"
[part]
kind = "plaque"
length = "40 mm"
width = "20 mm"
thickness = "2 mm"
mesh_size = "4 mm"
[material]
preset = "ppgf30"
[machine]
fill_time = "0.5 s"
melt_temperature = "523.15 K"
mold_temperature = "323.15 K"
[fibers]
length = "3 mm"
[numerics]
layers = 8
steps = 40
[output]
frames = 3
places = [["middle", "20 mm", "10 mm"]]
""",
    "properties": """study = "properties"
[fibers]
volume_fraction = 0.2
aspect_ratio = 50
orientation = [0.6, 0.3, 0.1]
""",
}

CHANGES = {
    "shear_cell": """
one fiber | fibers.count=1
one rod | fibers.count=1 ; fibers.length=0.1 mm
stubs of aspect ratio 1 | fibers.length=19 um ; fibers.rod_length=19 um
aspect ratio 3000 | fibers.diameter=1 um ; fibers.length=3 mm ; fibers.rod_length=3 mm ; cell.size=4 mm
fibers as long as the cell | fibers.length=0.5 mm
fibers six times as long as the cell | fibers.length=3 mm ; fibers.count=2
rods as long as the cell | fibers.length=0.5 mm ; fibers.rod_length=0.5 mm
dense and aligned | fibers.length=0.1 mm ; fibers.count=1300 ; cluster.orientation=aligned ; run.duration=0.1 ms
no friction | contact.friction=0
sticky friction | contact.friction=10 ; fibers.count=40
no contact | contact.force_constant=0
hard contact | contact.force_constant=1e6 N/m ; fibers.count=40 ; run.duration=0.2 ms
contact that does not decay | contact.decay=0
contact that decays at once | contact.decay=100
contact from afar | contact.cutoff=10 ; fibers.count=30
wide ramp | contact.ramp=19 um
hertz, incompressible | contact.law=hertz ; contact.poisson_ratio=0.5
floppy fibers | fibers.youngs_modulus=1 MPa
stiff fibers | fibers.youngs_modulus=2000 GPa
melt at rest | flow.rate=0 1/s
rate of 1e7 | flow.rate=1e7 1/s ; run.duration=1 us
rate of 1e-9 for a day | flow.rate=1e-9 1/s ; run.duration=1e5 s ; step.maximum=10 s
viscosity of 1e-9 | flow.viscosity=1e-9 Pa s
viscosity of 1e9 | flow.viscosity=1e9 Pa s ; run.duration=0.5 ms
a picosecond | run.duration=1e-12 s
fixed steps of a nanosecond | run.duration=1 us ; step.control=fixed ; step.initial=1 ns
fixed steps that are too long | step.control=fixed ; step.initial=1 s ; step.maximum=1 s
loose steps | step.tolerance=10 ; step.maximum=10 s ; step.maximum_strain=1
tight steps | step.tolerance=1e-9 ; run.duration=0.05 ms
slip of nearly none | contact.slip_velocity=1e-12 m/s ; fibers.count=30
twenty sweeps | contact.sweeps=20
checks every nanosecond | breakage.law=fixed ; breakage.check_interval=1 ns ; run.duration=2 us
every hinge breaks | breakage.law=fixed ; breakage.critical_radius=1 m
steep probability | breakage.law=probability ; breakage.exponent=700
radii that nearly agree | breakage.law=probability ; breakage.minimum_radius=200 um ; breakage.maximum_radius=200.0001 um
narrow walls | boundary.y=walls ; cell.size=["0.5 mm", "0.08 mm", "0.5 mm"] ; fibers.count=4 ; cluster.orientation=[0.7, 0, 0.3]
a flat cell | cell.size=["0.5 mm", "0.5 mm", "0.08 mm"] ; fibers.count=4
ramp of a million steps | flow.kind=ramp ; flow.ramp_steps=1000000 ; flow.ramp_duration=5 ms
a flow that stops and turns on | flow.kind=table ; flow.table=[["1 ms","200 1/s","200 Pa s"],["2 ms","0 1/s","200 Pa s"],["9 ms","1e4 1/s","1e-3 Pa s"]]
outputs beyond the end | output.interval=1 s ; output.frame_interval=1 s
ellipsoids of aspect ratio 1 | drag.law=ellipsoid ; fibers.length=19 um ; fibers.rod_length=19 um
slender bodies that are not | drag.law=slender_body ; fibers.length=40 um ; fibers.rod_length=40 um
""",
    "cluster": """
one fiber | fibers.volume_fraction=0.068 % ; cluster.orientation_tolerance=1
all along x | cluster.orientation=aligned
all in a plane | cluster.orientation=planar
nearly aligned | cluster.orientation=[0.999999, 5e-7, 5e-7]
half full and aligned | fibers.volume_fraction=50 % ; cluster.orientation=aligned ; cell.size=0.4 mm
nearly the densest | fibers.volume_fraction=90 % ; cluster.orientation=aligned ; cell.size=0.35 mm ; cluster.step_limit=300
too dense for chance | fibers.volume_fraction=40 % ; cluster.step_limit=200
bundles of one | cluster.start=bundles ; cluster.bundle_fibers=1
bundles of all fibers | cluster.start=bundles ; cluster.bundle_fibers=7 ; cluster.orientation_tolerance=1
bundles that touch | cluster.start=bundles ; cluster.bundle_fraction=90 %
no swelling | cluster.swelling=1
much swelling | cluster.swelling=10
orientation does not matter | cluster.orientation_weight=0
curvature hardly matters | cluster.curvature_weight=1e-6
no overlap at all | cluster.overlap_tolerance=1e-12
fibers that must be straight | cluster.minimum_radius=10 m ; fibers.length=1 mm
relaxation at rest | relaxation.duration=1 ms ; relaxation.rate=0 1/s
compressed start | cluster.start=compressed
""",
    "orientation": """
C_I of 0 | diffusion.C_I=0
C_I of 1 | diffusion.C_I=1
C_I of 1e-300 | diffusion.C_I=1e-300
kappa of 1e-6 | retardation.name=rsc ; retardation.kappa=1e-6
kappa of 1 | retardation.name=rsc ; retardation.kappa=1
alpha of 1 | retardation.name=rpr ; retardation.alpha=1
srf of 1e-9 | retardation.name=srf ; retardation.srf=1e-9
spheres | fibers.aspect_ratio=1
discs | fibers.aspect_ratio=1e-6
aspect ratio of 1e9 | fibers.aspect_ratio=1e9
aligned at the start | fibers.orientation=aligned
nearly singular A2 | fibers.orientation=[0.9999999999, 5e-11, 5e-11]
nearly planar A2 | fibers.orientation=[0.5, 0.4999999999, 1e-10] ; diffusion.C_I=0
eleven days of strain | run.duration=1e6 s ; output.interval=1e5 s
rate of 0 | flow.rate=0 1/s
rate of 1e7 | flow.rate=1e7 1/s ; run.duration=1 us ; output.interval=0.1 us
uniaxial for long | flow.kind=uniaxial ; diffusion.C_I=0 ; run.duration=1000 s ; output.interval=100 s
biaxial for long | flow.kind=biaxial ; diffusion.C_I=0 ; run.duration=1000 s ; output.interval=100 s
strong potential | fibers.potential=10
repelling potential | fibers.potential=-10
tightest tolerance | solution.tolerance=1e-13
loosest tolerance | solution.tolerance=0.01
linear closure in strong shear | solution.closure=linear ; run.duration=100 s
quadratic closure from isotropic | solution.closure=quadratic ; diffusion.C_I=0
distribution of low degree | solution.distribution=yes ; solution.degree=4 ; diffusion.C_I=1e-4
distribution of C_I 10 | solution.distribution=yes ; diffusion.C_I=10
a leap of the flow | flow.kind=table ; flow.table=[["0 s",0,1,0,0,0,0,0,0,0],["5 s",0,1,0,0,0,0,0,0,0],["5.000000001 s",0,0,0,1e6,0,0,0,0,0],["5.00001 s",0,0,0,1,0,0,0,0,0]]
a flow with divergence | flow.kind=gradient ; flow.gradient=[[1,0,0,0,1,0,0,0,1]]
iard with C_M of 1 | diffusion.name=iard ; diffusion.C_M=1 ; diffusion.C_I=1
""",
    "attrition": """
xi of 0 | law.xi=0
xi of 1e12 | law.xi=1e12
lambda of 1e-12 | law.lambda=1e-12
lambda of 1e9 | law.lambda=1e9
rate of 0 | flow.rate=0 1/s
rate of 1e7 | flow.rate=1e7 1/s
thirty years | run.duration=1e9 s
a nanosecond | run.duration=1e-9 s
fibers of 10 m | fibers.length=10 m
fibers of a nanometre | fibers.length=1 nm
means that agree | fibers.length=10 mm ; fibers.form=means
one class alone | law.name=phelps ; law.C_B=0.02 ; law.zeta=3 ; law.S=0.25 ; fibers.bins=2
narrow children | law.name=phelps ; law.C_B=0.02 ; law.zeta=3 ; law.S=0.005
wide children | law.name=phelps ; law.C_B=0.02 ; law.zeta=3 ; law.S=100
nothing breaks | law.name=phelps ; law.C_B=0 ; law.zeta=3 ; law.S=0.25
all breaks at once | law.name=phelps ; law.C_B=1e9 ; law.zeta=3 ; law.S=0.25
durin below L_ub | law.name=durin ; law.C_B=0.02 ; law.zeta=3 ; law.S=0.25 ; law.L_ub=1 m
rheometer at rest | flow.kind=couette ; flow.speed=0
rheometer without gap | flow.kind=couette ; flow.speed=50 ; flow.inner_radius=26.9999999 mm
one bin | output.histogram_bins=1
""",
    "molding": """
wall of 20 um | part.thickness=20 um
wall of 100 mm | part.thickness=100 mm ; fibers.length=3 mm
filled in a microsecond | machine.fill_time=1 us
filled in an hour | machine.fill_time=3600 s ; machine.pressure_limit=100 MPa
a mold nearly as hot as the melt | machine.mold_temperature=523.1499 K
window of 0.01 K | material.no_flow_temperature=523.14 K ; machine.pressure_limit=100 MPa
liquid like honey | melt.name=newtonian ; melt.eta_0=1e9 Pa s ; machine.pressure_limit=200 MPa ; machine.longest_time=10 s
liquid like air | melt.name=newtonian ; melt.eta_0=1e-9 Pa s
pressure limit of 1 Pa | machine.pressure_limit=1 Pa ; machine.longest_time=10 s
switchover at once | machine.switchover=0.001 ; machine.switchover_pressure=20 MPa
switchover never | machine.switchover=1
ends after a nanosecond | machine.longest_time=1e-9 s
insulated wall | machine.wall_transfer=1e-6 W/(m^2 K)
perfect wall | machine.wall_transfer=1e9 W/(m^2 K)
gate in a corner | part.gate=given ; gates.places=[["G", "0 mm", "0 mm"]]
gate of a micrometre | part.gate=given ; gates.places=[["G", "20 mm", "10 mm"]] ; gates.radius=1 um
gate as wide as the part | part.gate=given ; gates.places=[["G", "20 mm", "10 mm"]] ; gates.radius=10 mm
two gates in one place | part.gate=given ; gates.places=[["G", "20 mm", "10 mm"], ["H", "20.1 mm", "10 mm"]]
a valve that closes at once | part.gate=given ; gates.places=[["G", "0 mm", "10 mm"], ["H", "40 mm", "10 mm"]] ; gates.valves=[["H", "start", "filled 0.0001"]]
mesh nearly too coarse | part.mesh_size=8 mm
a strip of 1 m by 1 mm | part.length=1 m ; part.width=1 mm ; part.mesh_size=1 mm ; machine.pressure_limit=200 MPa ; output.places=[["middle", "0.5 m", "0.5 mm"]]
fewest layers and steps | numerics.layers=4 ; numerics.steps=10
most layers | numerics.layers=128 ; part.mesh_size=8 mm
wall layer of nearly none | numerics.wall_width_ratio=1e-6
C_I of 1 | orientation.C_I=1
aligned at the gate | fibers.inlet_orientation=[1, 0, 0]
dust | fibers.length=1 um
fibers longer than the part | fibers.length=1 m
breaks at once | law.xi=1e6
thin at the end | part.thickness_profile=[["0 mm", 1], ["40 mm", 0.02]] ; machine.pressure_limit=200 MPa
rolled up | part.bend_radius=7 mm ; output.places=[["middle", "20 mm", "10 mm"]]
all gates close for long | part.gate=given ; gates.places=[["G", "0 mm", "10 mm"]] ; gates.valves=[["G", "start", "filled 0.3", "time 5 s"]]
a gate that waits for nothing | part.gate=given ; gates.places=[["G", "0 mm", "10 mm"], ["H", "40 mm", "10 mm"]] ; gates.valves=[["H", "never"]]
""",
    "properties": """
no fibers | fibers.volume_fraction=0
all fibers | fibers.volume_fraction=1
spheres | fibers.aspect_ratio=1
discs | fibers.aspect_ratio=1e-6
aspect ratio of 1e9 | fibers.aspect_ratio=1e9
incompressible | matrix.poisson_ratio=0.4999999999
auxetic | matrix.poisson_ratio=-0.9999999 ; fibers.poisson_ratio=-0.9999999
fibers nearly of matrix | fibers.youngs_modulus=1.51 GPa ; fibers.poisson_ratio=0.4
a matrix of nothing | matrix.youngs_modulus=1e-6 Pa
aligned | fibers.orientation=aligned
lielens, dense | solution.model=lielens ; fibers.volume_fraction=0.999999
halpin-tsai, dense | solution.model=halpin_tsai ; fibers.volume_fraction=0.999999
""",
}


def all_cases():
    """Gives (study, name, changes) of every case."""
    for study, lines in CHANGES.items():
        for line in lines.strip().split("\n"):
            name, changes = line.split(" | ")
            yield study, name, changes.split(" ; ")
