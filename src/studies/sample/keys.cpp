// The keys of the fibers at the start.
#include "fibers/contact_laws/contact_registry.hpp"
#include "keys/law_keys.hpp"
#include "studies/sample/case.hpp"

namespace fiberfate {
namespace {

KeyRows<FiberChoices> amount_rows() {
  using Fibers = FiberChoices;
  return {
      key("count", &Fibers::count, {}, Range::between(1, 1e7), "Number of fibers.", optional("628")),
      key("volume_fraction", &Fibers::volume_fraction, {"1", "%"}, {0, 0.907, Range::Ends::open_low},
          "Volume of the fibers over the volume of the cell. Parallel rods in the densest packing would "
          "reach pi/sqrt(12).",
          usual("\"13.2 %\"")),
      key("weight_fraction", &Fibers::weight_fraction, {"1", "%"}, Range::inside(0, 1),
          "Weight of the fibers over the weight of fibers and matrix; needs fibers.density and "
          "matrix.density.",
          optional("\"30 %\""), "thesis table 3"),
  };
}

void describe_further_kind(KeyTable& table, const std::string& name, FurtherKind& kind) {
  const KeyRows<FurtherKind> own = {key("volume_share", &FurtherKind::volume_share, {}, Range::positive(1e6),
                                        "Volume of these fibers, relative to that of the kind in [fibers].",
                                        required("0.5"))};
  table.section(
      name,
      "One more kind of fibers in the same cell; the table is repeated for each. Its keys are those of "
      "[fibers]; the amount of fibers that [fibers] gives counts all kinds.");
  describe(table, name, fiber_kind_rows(), kind);
  describe(table, name, own, kind);
  describe_length_laws(table, name, kind);
}

void describe_fibers(KeyTable& table, FiberChoices& fibers) {
  table.section("fibers",
                "What the fibers are and how many. Of the number of fibers, their fraction (by volume or by "
                "weight) and cell.size give two; the third follows.");
  describe(table, "fibers", fiber_kind_rows(), fibers);
  describe(table, "fibers", amount_rows(), fibers);
  describe_length_laws(table, "fibers", fibers);
  table.repeated(
      "fibers.more_kinds", fibers.more_kinds,
      [&table](const std::string& name, FurtherKind& kind) { describe_further_kind(table, name, kind); });
}

KeyRows<ClusterChoices> source_rows() {
  using Cluster = ClusterChoices;
  const Choices<ClusterSource> sources = {
      {ClusterSource::generate, "generate", "pack fibers with the wanted orientation, without overlaps"},
      {ClusterSource::fiber, "fiber",
       "one straight fiber in the middle of the cell, along cluster.direction"},
      {ClusterSource::file, "file", "read cluster.file"}};
  return {
      key("source", &Cluster::source, sources, "Where the fibers come from."),
      file_key("file", &Cluster::file,
               "The file for source = \"file\": a checkpoint.h5, a fibers.csv or the published program's "
               "Initial_Positions.txt. A relative path starts at the case file's folder.",
               optional("\"../cluster/checkpoint.h5\"")),
      vector_key("direction", &Cluster::direction, KeyTable::Cubic::no,
                 {.text = "Direction of the fiber for source = \"fiber\", as components along x (flow), y "
                          "(gradient) and z (vorticity); its length does not matter.",
                  .example = "[0.0, 1.0, 1.0]"}),
  };
}

KeyRows<BundleRequest> bundle_rows() {
  return {
      key("bundle_fibers", &BundleRequest::fibers, {}, Range::between(1, 100000),
          "Fibers in a bundle; 7, 19, 37, ... fill hexagons."),
      key("bundle_fraction", &BundleRequest::volume_fraction, {"1", "%"}, {0, 0.9068, Range::Ends::open_low},
          "Volume fraction of the fibers inside a bundle."),
  };
}

KeyRows<PackingWeights> weight_rows() {
  return {
      key("curvature_weight", &PackingWeights::curvature, {}, Range::positive(100),
          "What bending more sharply than wanted costs against overlap, which costs 1: where packing cannot "
          "have all, more weight means less of that error."),
      key("orientation_weight", &PackingWeights::orientation, {}, Range::between(0, 1000),
          "What an error of the orientation tensor costs against overlap."),
  };
}

KeyRows<ClusterChoices> start_rows() {
  const Choices<PackingStart> starts = {
      {PackingStart::dispersed, "dispersed", "single fibers anywhere in the cell"},
      {PackingStart::bundles, "bundles", "bundles of parallel fibers, as pellets hold them"},
      {PackingStart::compressed, "compressed",
       "the published route: planar fibers at 2.5 % by volume, then the cell is compressed; the orientation "
       "is what comes of it"}};
  return {key("start", &ClusterChoices::start, starts, "How the fibers lie before packing parts them.",
              "thesis section 3.2.1")};
}

KeyRows<ClusterChoices> orientation_rows() {
  using Cluster = ClusterChoices;
  const Choices<OrientationDistribution> laws = {
      {OrientationDistribution::angular_central_gaussian, "angular_central_gaussian",
       "a smooth distribution fitted to the tensor"},
      {OrientationDistribution::subclusters, "subclusters",
       "a mixture of isotropic, planar and aligned fibers, as in the thesis"}};
  return {
      orientation_key("orientation", &Cluster::orientation,
                      "Wanted second-order orientation tensor: \"isotropic\" [1/3, 1/3, 1/3], \"planar\" "
                      "[1/2, 1/2, 0], \"aligned\" [1, 0, 0], any three principal values along x, y and z, or "
                      "3 by 3 components.",
                      optional("[0.6, 0.3, 0.1]"), "thesis section 3.2.1"),
      key("law", &Cluster::law, laws, "How directions with that tensor are distributed.",
          "thesis section 3.2.1"),
      rows_key("directions", &Cluster::directions,
               {{"p1", {"1", "1"}, Range::any()},
                {"p2", {"1", "1"}, Range::any()},
                {"p3", {"1", "1"}, Range::any()}},
               "Measured directions, instead of cluster.orientation: rows [p1, p2, p3] along x, y and z, of "
               "any length but zero, or the path of a text file of such rows. Each is used equally often.",
               optional("[[1, 0, 0], [0.8, 0.6, 0]]")),
  };
}

KeyRows<ClusterChoices> packing_rows() {
  using Cluster = ClusterChoices;
  return {
      key("swelling", &Cluster::swelling, {}, Range::between(1, 10),
          "Distance in diameters from which fibers repel each other while packing spreads them. More gives "
          "straighter fibers, but spaces them more evenly than chance."),
      key("minimum_radius", &Cluster::minimum_radius, {"m", "um"}, Range::not_negative(),
          "Smallest radius of curvature that packing may bend a fiber to; 0 bends as little as it can."),
      key("overlap_tolerance", &Cluster::overlap_tolerance, {}, Range::positive(1),
          "Largest overlap of two fibers that is let pass, in diameters."),
      key("orientation_tolerance", &Cluster::orientation_tolerance, {}, Range::positive(1),
          "Largest accepted error of any component of A2 of the packed fibers."),
      key("step_limit", &Cluster::step_limit, {}, Range::between(1, 1e8),
          "Most steps of relaxation before packing gives up."),
  };
}

KeyGroup<ClusterChoices> cluster_keys() {
  return {"cluster", "How the fibers lie at the start.",
          joined<ClusterChoices>({source_rows(), start_rows(),
                                  rows_of(&ClusterChoices::bundle, bundle_rows()), orientation_rows(),
                                  rows_of(&ClusterChoices::weights, weight_rows()), packing_rows()})};
}

}  // namespace

void describe_sample(KeyTable& table, SampleCase& sample) {
  const KeyGroup<CellChoices> cell = {
      "cell",
      "The periodic cell that holds the fibers and flows with the melt.",
      {vector_key("size", &CellChoices::size, KeyTable::Cubic::allowed,
                  {.text = "Edges of the cell along x (flow), y (gradient) and z (vorticity), or one edge of "
                           "a cube.",
                   .unit = "m",
                   .friendly = "mm",
                   .range = Range::positive(1),
                   .need = Need::usual,
                   .example = "\"0.75 mm\"",
                   .source = "thesis table 6"})}};
  const KeyGroup<MatrixChoices> matrix = {
      "matrix",
      "The melt between the fibers.",
      {key("density", &MatrixChoices::density, {"kg/m3"}, Range::between(100, 25000),
           "Density of the matrix. Only weight fractions need it.", optional("\"905 kg/m3\""),
           "polypropylene")}};
  describe(table, cell, sample.cell);
  describe_fibers(table, sample.fibers);
  describe(table, matrix, sample.matrix);
  describe(table, cluster_keys(), sample.cluster);
}

KeyRows<ContactParameters> contact_law_rows() {
  using Contact = ContactParameters;
  return {
      law_key("law", &Contact::law, contact_laws(), "The normal force between rods that touch."),
      key("force_constant", &Contact::force_constant, {"N/m"}, Range::between(0, 1e6),
          "A of law \"exponential\", the normal force F = A D exp(-B (d/a - 2)) between rods of diameter D = "
          "2a whose axes are d "
          "apart (the thesis' excluded volume force constant). 0 switches contact off.",
          {}, "thesis equation 3.14 and table 4 (250, 500, 750)"),
      key("decay", &Contact::decay, {}, Range::between(0, 100), "B in the same.", {}, "thesis section 3.3.3"),
      key("cutoff", &Contact::cutoff, {}, Range::between(2, 10),
          "Distance of the axes below which the force acts, in radii: 2 is touch.", {},
          "the published program, whose force ends at two radii"),
      key("ramp", &Contact::ramp, {"m", "um"}, Range::positive(1e-3),
          "Width over which the force rises from nothing at the cutoff, centred on it; a jump would make "
          "contacts chatter."),
      key("poisson_ratio", &Contact::poisson_ratio, {}, Range{-1, 0.5, Range::Ends::open_low},
          "Poisson's ratio of the fibers, for law \"hertz\".", {}, "E glass"),
  };
}

}  // namespace fiberfate
