// Describes the keys of the fibers at the start.
#include "fibers/contact_laws/contact_registry.hpp"
#include "keys/law_keys.hpp"
#include "studies/sample/case.hpp"

namespace fiberfate {
namespace {

void describe_amount(KeyTable& table, FiberChoices& fibers) {
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

void describe_fibers(KeyTable& table, FiberChoices& fibers) {
  table.section("fibers",
                "What the fibers are and how many. Of the number of fibers, their fraction (by volume or by "
                "weight) and "
                "cell.size give two; the third follows.");
  describe_fiber_kind(table, "fibers", fibers);
  describe_amount(table, fibers);
  describe_length_laws(table, "fibers", fibers);
  table.repeated(
      "fibers.more_kinds", fibers.more_kinds, [&table](const std::string& name, FurtherKind& kind) {
        table.section(
            name,
            "One more kind of fibers in the same cell; the table is repeated for each. Its keys are those of "
            "[fibers]; the amount of fibers that [fibers] gives counts all kinds.");
        describe_fiber_kind(table, name, kind);
        table.quantity(name + ".volume_share", kind.volume_share,
                       {.text = "Volume of these fibers, relative to that of the kind in [fibers].",
                        .range = Range::positive(1e6),
                        .need = Need::required,
                        .example = "0.5"});
        describe_length_laws(table, name, kind);
      });
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
       .range = Range::between(1, 10)});
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
  describe_law_name(table, "contact.law", contact.law, contact_laws(),
                    {.text = "The normal force between rods that touch."});
  table.quantity("contact.force_constant", contact.force_constant,
                 {.text = "A of law \"exponential\", the normal force F = A D exp(-B (d/a - 2)) between rods "
                          "of diameter D = 2a whose axes "
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
  table.quantity("contact.poisson_ratio", contact.poisson_ratio,
                 {.text = "Poisson's ratio of the fibers, for law \"hertz\".",
                  .range = {-1, 0.5, Range::Ends::open_low},
                  .source = "E glass"});
}

}  // namespace fiberfate
