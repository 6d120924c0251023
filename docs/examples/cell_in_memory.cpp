// Shears a cell of fibers in memory: a case as text, a session without a terminal, results without a folder.
#include <any>
#include <cstdio>
#include <exception>

#include "base/error.hpp"
#include "keys/case_file.hpp"
#include "results/memory_recorder.hpp"
#include "studies/session.hpp"
#include "studies/shear_cell/run.hpp"

namespace {

constexpr const char* text = R"(
study = "shear_cell"
run.duration = "0.1 s"
cell.size = "1 mm"
fibers = {count = 20, length = "0.8 mm", rod_length = "0.1 mm", diameter = "19 um", youngs_modulus = "73 GPa"}
flow = {rate = "16.65 1/s", viscosity = "200 Pa s"}
output.interval = "20 ms"
)";

int shear() {
  using namespace fiberfate;
  // Reads the case, with units and all checks, as the command line reads a file.
  const CaseKind kind = case_kind<ShearCellCase>("shear_cell", "", describe_shear_cell, validate_shear_cell);
  const LoadedCase loaded = parse_case(text, "cell_in_memory", {&kind});
  auto values = std::any_cast<ShearCellCase>(loaded.values);
  values.flow.rate = 20;  // the case is a plain struct of SI numbers: change what you like

  MemoryRecorder recorder;
  Session session(recorder, {.threads = 1});
  Outcome outcome = compute_shear_cell(values, session);
  recorder.hand_over(outcome);

  const CsvTable& series = outcome.table("series");
  for (std::size_t row = 0; row < series.rows(); ++row)
    std::printf("%.3f s  a11 = %.4f  L_N = %.3f mm\n", series.column("time_s")[row],
                series.column("a11")[row], 1e3 * series.column("L_N_m")[row]);
  for (const NamedFrames& one : outcome.frames)
    std::printf("%zu frames of \"%s\"; %zu lines in the log\n", one.frames.size(), one.name.c_str(),
                recorder.log().size());
  return series.rows() == 6 && series.column("strain").back() > 1.9 ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return shear();
  } catch (const fiberfate::InputError& error) {  // every problem of the case, with its line and remedy
    std::fprintf(stderr, "%s\n", error.what());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 2;
}
