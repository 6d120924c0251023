// Describes the keys of the fibers at the start.
#include "app/studies/sample_case.hpp"

namespace fiberfate {
namespace {

void describe_fibers(KeyTable& table, FiberChoices& fibers) {
  table.section("fibers",
                "What the fibers are and how many. Of the number of fibers, their fraction (by volume or by "
                "weight) and "
                "cell.size give two; the third follows.");
  table.quantity(
      "fibers.length", fibers.length,
      {.text = "Length of every fiber. Instead of it, fibers.lengths, [fibers.length_histogram] or "
               "[fibers.length_distribution] gives a distribution.",
       .unit = "m",
       .friendly = "mm",
       .range = Range::between(1e-6, 0.1),
       .need = Need::usual,
       .example = "\"2.5 mm\"",
       .source = "thesis section 3.3.3"});
  table.rows(
      "fibers.lengths", fibers.lengths, {{"length", {"m", "mm"}, Range::between(1e-6, 0.1)}},
      {.text = "Measured lengths, dealt to the fibers in turn: a list, or the path of a text file with one "
               "length in m a line.",
       .example = R"(["0.5 mm", "0.8 mm", "2.1 mm"])"});
  table.quantity("fibers.diameter", fibers.diameter,
                 {.text = "Diameter of every fiber.",
                  .unit = "m",
                  .friendly = "um",
                  .range = Range::between(1e-7, 1e-3),
                  .need = Need::required,
                  .example = "\"19 um\"",
                  .source = "thesis table 3"});
  table.quantity(
      "fibers.youngs_modulus", fibers.youngs_modulus,
      {.text = "Young's modulus of the fibers; with the diameter it gives the bending stiffness E pi d^4/64.",
       .unit = "Pa",
       .friendly = "GPa",
       .range = Range::between(1e6, 2e12),
       .need = Need::required,
       .example = "\"73 GPa\"",
       .source = "thesis table 3"});
  table.quantity("fibers.density", fibers.density,
                 {.text = "Density of the fibers. Only weight fractions need it.",
                  .unit = "kg/m3",
                  .range = Range::between(100, 25000),
                  .example = "\"2550 kg/m3\"",
                  .source = "E glass"});
}

void describe_amount(KeyTable& table, FiberChoices& fibers) {
  table.quantity(
      "fibers.rod_length", fibers.rod_length,
      {.text = "Wanted length of the rigid rods of which a flexible fiber is a chain. A fiber is cut into "
               "equal rods, as many as come nearest to this length; a rod is at least one diameter long.",
       .unit = "m",
       .friendly = "mm",
       .range = Range::positive(0.1),
       .need = Need::usual,
       .example = "\"0.1 mm\"",
       .source = "thesis section 3.3.3"});
  table.count("fibers.count", fibers.count,
              {.text = "Number of fibers.", .range = Range::between(1, 1e7), .example = "628"});
  table.quantity(
      "fibers.volume_fraction", fibers.volume_fraction,
      {.text = "Volume of the fibers over the volume of the cell. Parallel rods in the densest packing "
               "would reach pi/sqrt(12).",
       .friendly = "%",
       .range = {0, 0.907, Range::Ends::open_low},
       .need = Need::usual,
       .example = "\"13.2 %\""});
  table.quantity(
      "fibers.weight_fraction", fibers.weight_fraction,
      {.text = "Weight of the fibers over the weight of fibers and matrix; needs fibers.density and "
               "matrix.density.",
       .friendly = "%",
       .range = Range::inside(0, 1),
       .example = "\"30 %\"",
       .source = "thesis table 3"});
}

void describe_more_kinds(KeyTable& table, FiberChoices& fibers) {
  table.rows(
      "fibers.more_kinds", fibers.more_kinds,
      {{"length", {"m", "mm"}, Range::between(1e-6, 0.1)},
       {"diameter", {"m", "um"}, Range::between(1e-7, 1e-3)},
       {"youngs_modulus", {"Pa", "GPa"}, Range::between(1e6, 2e12)},
       {"density", {"kg/m3", "kg/m3"}, Range::between(100, 25000)},
       {"rod_length", {"m", "mm"}, Range::positive(0.1)},
       {"volume_share", {"1", "1"}, Range::positive()}},
      {.text = "More kinds of fibers in the same cell, one row each: [length, diameter, youngs_modulus, "
               "density, rod_length, volume_share]; the share is relative to the kind that [fibers] "
               "describes, and the amount of fibers counts all kinds.",
       .example = R"([["1 mm", "7 um", "230 GPa", "1800 kg/m3", "0.05 mm", 0.5]])"});
}

void describe_length_distribution(KeyTable& table, LengthDistributionChoices& distribution) {
  table.section("fibers.length_distribution",
                "Lengths from a smooth law with given means, instead of fibers.length.");
  table.choice("fibers.length_distribution.law", distribution.law,
               {{LengthDistributionLaw::weibull, "weibull", "P(L < x) = 1 - exp(-(x/a)^b), by number"},
                {LengthDistributionLaw::log_normal, "log_normal", "ln L is normal, by number"}},
               {.text = "The law."});
  table.quantity("fibers.length_distribution.number_average", distribution.number_average,
                 {.text = "Mean length by number, L_N.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::between(1e-6, 0.1),
                  .example = "\"1.0 mm\"",
                  .source = "thesis equation 2.5"});
  table.quantity("fibers.length_distribution.weight_average", distribution.weight_average,
                 {.text = "Mean length by weight, L_W; at least L_N.",
                  .unit = "m",
                  .friendly = "mm",
                  .range = Range::between(1e-6, 0.1),
                  .example = "\"2.0 mm\"",
                  .source = "thesis equation 2.6"});
}

void describe_lengths(KeyTable& table, LengthHistogram& histogram) {
  table.section("fibers.length_histogram",
                "Lengths from a histogram, instead of fibers.length; within a bin they are "
                "spread evenly.");
  table.quantities("fibers.length_histogram.edges", histogram.edges,
                   {.text = "Edges of the bins, rising: one more than there are bins.",
                    .unit = "m",
                    .friendly = "mm",
                    .range = Range::between(0, 0.1),
                    .example = R"(["0.5 mm", "1 mm", "1.5 mm", "2 mm"])"});
  table.quantities("fibers.length_histogram.heights", histogram.heights,
                   {.text = "Heights of the bins, on any scale.",
                    .range = Range::not_negative(),
                    .example = "[30, 50, 20]",
                    .source = "thesis equation 3.30"});
  table.choice("fibers.length_histogram.height", histogram.height,
               {{HistogramHeight::fibers, "fibers", "share of the number of fibers"},
                {HistogramHeight::length, "length", "share of the total length of the fibers"}},
               {.text = "What the heights count.", .source = "thesis equations 3.30, 3.31"});
}

void describe_source(KeyTable& table, ClusterChoices& cluster) {
  table.section("cluster", "How the fibers lie at the start.");
  table.choice(
      "cluster.source", cluster.source,
      {{ClusterSource::generate, "generate", "pack fibers with the wanted orientation, without overlaps"},
       {ClusterSource::fiber, "fiber",
        "one straight fiber in the middle of the cell, along cluster.direction"},
       {ClusterSource::file, "file", "read cluster.file"}},
      {.text = "Where the fibers come from."});
  table.file(
      "cluster.file", cluster.file,
      {.text = "The file for source = \"file\": a checkpoint.h5, a fibers.csv or the published program's "
               "Initial_Positions.txt. A relative path starts at the case file's folder.",
       .example = "\"../cluster/checkpoint.h5\""});
  table.vector(
      "cluster.direction", cluster.direction, KeyTable::Cubic::no,
      {.text =
           "Direction of the fiber for source = \"fiber\", as components along x (flow), y (gradient) and "
           "z (vorticity); its length does not matter.",
       .example = "[0.0, 1.0, 1.0]"});
}

void describe_start(KeyTable& table, ClusterChoices& cluster) {
  table.choice("cluster.start", cluster.start,
               {{PackingStart::dispersed, "dispersed", "single fibers anywhere in the cell"},
                {PackingStart::bundles, "bundles", "bundles of parallel fibers, as pellets hold them"},
                {PackingStart::compressed, "compressed",
                 "the published route: planar fibers at 2.5 % by volume, then the cell is compressed; the "
                 "orientation is what comes of it"}},
               {.text = "How the fibers lie before packing parts them.", .source = "thesis section 3.2.1"});
  table.count(
      "cluster.bundle_fibers", cluster.bundle.fibers,
      {.text = "Fibers in a bundle; 7, 19, 37, ... fill hexagons.", .range = Range::between(1, 100000)});
  table.quantity("cluster.bundle_fraction", cluster.bundle.volume_fraction,
                 {.text = "Volume fraction of the fibers inside a bundle.",
                  .friendly = "%",
                  .range = {0, 0.9068, Range::Ends::open_low}});
}

void describe_packing(KeyTable& table, ClusterChoices& cluster) {
  table.orientation(
      "cluster.orientation", cluster.orientation,
      {.text = "Wanted second-order orientation tensor: \"isotropic\" [1/3, 1/3, 1/3], \"planar\" "
               "[1/2, 1/2, 0], \"aligned\" [1, 0, 0], any three principal values along x, y and z, or "
               "3 by 3 components.",
       .example = "[0.6, 0.3, 0.1]",
       .source = "thesis section 3.2.1"});
  table.choice(
      "cluster.law", cluster.law,
      {{OrientationDistribution::angular_central_gaussian, "angular_central_gaussian",
        "a smooth distribution fitted to the tensor"},
       {OrientationDistribution::subclusters, "subclusters",
        "a mixture of isotropic, planar and aligned fibers, as in the thesis"}},
      {.text = "How directions with that tensor are distributed.", .source = "thesis section 3.2.1"});
  table.rows(
      "cluster.directions", cluster.directions,
      {{"p1", {"1", "1"}, Range::any()}, {"p2", {"1", "1"}, Range::any()}, {"p3", {"1", "1"}, Range::any()}},
      {.text = "Measured directions, instead of cluster.orientation: rows [p1, p2, p3] along x, y and z, of "
               "any length but zero, or the path of a text file of such rows. Each is used equally often.",
       .example = "[[1, 0, 0], [0.8, 0.6, 0]]"});
  table.quantity("cluster.curvature_weight", cluster.weights.curvature,
                 {.text = "What bending more sharply than wanted costs against overlap, which costs 1: where "
                          "packing cannot have all, more weight means less of that error.",
                  .range = Range::positive(100)});
  table.quantity("cluster.orientation_weight", cluster.weights.orientation,
                 {.text = "What an error of the orientation tensor costs against overlap.",
                  .range = Range::between(0, 1000)});
  table.quantity(
      "cluster.swelling", cluster.swelling,
      {.text =
           "Distance in diameters from which fibers repel each other while packing spreads them. More gives "
           "straighter fibers, but spaces them more evenly than chance.",
       .range = Range::between(1, 20)});
  table.quantity(
      "cluster.minimum_radius", cluster.minimum_radius,
      {.text = "Smallest radius of curvature that packing may bend a fiber to; 0 bends as little as it can.",
       .unit = "m",
       .friendly = "um",
       .range = Range::not_negative()});
  table.quantity(
      "cluster.overlap_tolerance", cluster.overlap_tolerance,
      {.text = "Largest overlap of two fibers that is let pass, in diameters.", .range = Range::positive(1)});
  table.quantity("cluster.orientation_tolerance", cluster.orientation_tolerance,
                 {.text = "Largest error that is let pass in any component of the orientation tensor.",
                  .range = Range::positive(1)});
  table.count("cluster.step_limit", cluster.step_limit,
              {.text = "Most steps of relaxation before packing gives up.", .range = Range::between(1, 1e8)});
}

}  // namespace

void describe_sample(KeyTable& table, SampleCase& sample) {
  table.section("cell", "The periodic cell that holds the fibers and flows with the melt.");
  table.vector(
      "cell.size", sample.cell_size, KeyTable::Cubic::allowed,
      {.text = "Edges of the cell along x (flow), y (gradient) and z (vorticity), or one edge of a cube.",
       .unit = "m",
       .friendly = "mm",
       .range = Range::positive(1),
       .need = Need::usual,
       .example = "\"0.75 mm\"",
       .source = "thesis table 6"});
  describe_fibers(table, sample.fibers);
  describe_amount(table, sample.fibers);
  describe_more_kinds(table, sample.fibers);
  describe_lengths(table, sample.fibers.length_histogram);
  describe_length_distribution(table, sample.fibers.length_distribution);
  table.section("matrix", "The melt between the fibers.");
  table.quantity("matrix.density", sample.matrix_density,
                 {.text = "Density of the matrix. Only weight fractions need it.",
                  .unit = "kg/m3",
                  .range = Range::between(100, 25000),
                  .example = "\"905 kg/m3\"",
                  .source = "polypropylene"});
  describe_source(table, sample.cluster);
  describe_start(table, sample.cluster);
  describe_packing(table, sample.cluster);
}

void describe_contact_law(KeyTable& table, ContactParameters& contact) {
  table.quantity(
      "contact.force_constant", contact.force_constant,
      {.text = "A in the normal force F = A D exp(-B (d/a - 2)) between rods of diameter D = 2a whose axes "
               "are d apart (the thesis' excluded volume force constant). 0 switches contact off.",
       .unit = "N/m",
       .range = Range::between(0, 1e6),
       .source = "thesis equation 3.14 and table 4 (250, 500, 750)"});
  table.quantity(
      "contact.decay", contact.decay,
      {.text = "B in the same.", .range = Range::between(0, 100), .source = "thesis section 3.3.3"});
  table.quantity("contact.cutoff", contact.cutoff,
                 {.text = "Distance of the axes below which the force acts, in radii: 2 is touch.",
                  .range = Range::between(2, 10),
                  .source = "the published program's distanceFactor"});
  table.quantity(
      "contact.ramp", contact.ramp,
      {.text = "Width over which the force rises from nothing at the cutoff, centred on it; a jump would "
               "make contacts chatter.",
       .unit = "m",
       .friendly = "um",
       .range = Range::positive(1e-3)});
}

}  // namespace fiberfate
