// Reads the command line with CLI11, runs the command, and turns errors into messages and exit statuses.
#include "app/command_line.hpp"

#include "app/study_registry.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "app/command_check.hpp"
#include "app/command_cite.hpp"
#include "app/command_explain.hpp"
#include "app/command_export.hpp"
#include "app/command_import.hpp"
#include "app/command_new.hpp"
#include "app/command_report.hpp"
#include "app/command_resume.hpp"
#include "app/command_run.hpp"
#include "app/environment.hpp"
#include "app/exit_status.hpp"
#include "app/gallery.hpp"
#include "app/last_words.hpp"
#include "app/say.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "io/disk_faults.hpp"

namespace fiberfate {
namespace {

constexpr const char* overview =
    R"(fiberfate predicts what becomes of the fibers when a fiber composite is processed.

A session:
  fiberfate new shear_cell first          write first/case.toml, with every key explained
  fiberfate check first/case.toml         validate it; see what it needs
  fiberfate run first/case.toml           run it into a result folder
  fiberfate report results/first          write a report that opens in any browser
  fiberfate explain breakage.law          what a key means
  fiberfate cite results/first            what a paper says of it
)";

constexpr const char* statuses =
    "Exit status: 0 done, 2 bad input, 3 the simulation failed, 4 stopped by a signal after a checkpoint.";

/// Reads a quantity of the command line; CLI11 shows the complaint.
double quantity(const std::string& option, const std::string& text, const std::string& unit) {
  try {
    return quantity_in_si(text, unit);
  } catch (const std::invalid_argument& error) {
    InputProblem problem;
    problem.file = "command line";
    problem.key = option;
    problem.value = text;
    problem.complaint = error.what();
    problem.remedy = fmt::format("give a quantity such as \"1.5 {}\"", unit);
    throw InputError({problem});
  }
}

/// The options of all commands and the status of the one that ran.
struct Commands {
  NewOptions new_case;
  CheckOptions check;
  RunOptions run, resume;
  ReportOptions report;
  ExportOptions export_result;
  ImportOptions import_case;
  ExplainOptions explain;
  CiteOptions cite;
  std::optional<std::string> run_until, resume_until;
  int status = 0;
};

void add_changes(CLI::App& command, CaseChanges& changes) {
  command
      .add_option(
          "--variant", changes.variants,
          "Take the values of [NAME] in the variants.toml beside the case; may be given more than once")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command
      .add_option("--set", changes.overrides,
                  "Replace a value of the case: --set fibers.length=\"2 mm\"; may be given more than once")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

template <class Existing>
void add_overwrite(CLI::App& command, Existing& existing, const std::string& what) {
  command.add_flag_callback(
      "--overwrite,--force", [&existing] { existing = Existing::overwrite; },
      "Replace " + what + " there already");
}

/// Checks a count; CLI11's own words for its range have 160 digits.
CLI::Validator at_least_one() {
  const auto complaint = [](const std::string& text) {
    const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    return digits && text.find_first_not_of('0') != std::string::npos
               ? std::string()
               : fmt::format("{} is not a whole number of at least 1", text);
  };
  return {complaint, "", "at least one"};
}

/// Reads the time at which a run stops.
double time_to_stop(const std::string& text) {
  const double time = quantity("--until", text, "s");
  if (time > 0) return time;
  throw InputError(
      {{"command line", 0, 0, "--until", text, "is not a time after the start", "give more than 0 s"}});
}

void add_limits(CLI::App& command, RunOptions& options, std::optional<std::string>& until) {
  command.add_option("--threads", options.session.threads, "Threads, instead of run.threads")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  command.add_option("--until", until, "Stop at this simulated time, \"0.5 s\"")->type_name("TIME");
  command.add_option("--steps", options.session.steps, "Make at most so many steps now")
      ->type_name("N")
      ->check(at_least_one());
  command
      .add_option("--progress", options.progress,
                  "How to show progress: auto, line (for a terminal), log (a line now and then), none")
      ->type_name("KIND")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, ProgressKind>{{"auto", ProgressKind::automatic},
                                                                      {"line", ProgressKind::line},
                                                                      {"log", ProgressKind::log},
                                                                      {"none", ProgressKind::none}}));
}

void add_case_commands(CLI::App& app, Commands& commands) {
  CLI::App* new_case =
      app.add_subcommand("new", "Write an annotated case file, or copy a case of the gallery");
  new_case->footer(
      fmt::format("Studies: {}\nGallery: {}\nExamples:\n  fiberfate new shear_cell my_study\n  fiberfate new "
                  "04_couette_43wt",
                  fmt::join(study_names(), ", "), fmt::join(gallery_names(), ", ")));
  new_case
      ->add_option("what", commands.new_case.what,
                   "A study (see 'fiberfate explain') or a case of the gallery")
      ->required()
      ->type_name("STUDY|CASE");
  new_case
      ->add_option("dir", commands.new_case.folder, "Folder to write to; named after the first if left out")
      ->type_name("DIR");
  add_overwrite(*new_case, commands.new_case.existing, "files");
  new_case->callback([&commands] { commands.status = run_new(commands.new_case); });

  CLI::App* check = app.add_subcommand("check", "Validate a case; print it resolved, with what it needs");
  check->footer("Example:\n  fiberfate check case.toml --set flow.rate=\"100 1/s\"");
  check->add_option("case", commands.check.case_file, "The case file")->required()->type_name("CASE.toml");
  add_changes(*check, commands.check.changes);
  check->callback([&commands] { commands.status = run_check(commands.check); });

  CLI::App* explain = app.add_subcommand("explain", "Explain a key, a table or a study");
  explain->footer(
      "Examples:\n  fiberfate explain\n  fiberfate explain shear_cell\n  fiberfate explain contact.friction");
  explain->add_option("topic", commands.explain.topic, "A key, a table of keys or a study")->type_name("KEY");
  explain->add_flag_callback(
      "--markdown", [&commands] { commands.explain.layout = ExplainLayout::markdown; },
      "Write all keys of all studies as Markdown");
  explain->callback([&commands] { commands.status = run_explain(commands.explain); });
}

void add_run_commands(CLI::App& app, Commands& commands) {
  CLI::App* run = app.add_subcommand("run", "Run a case into a result folder");
  run->footer(
      "Examples:\n  fiberfate run case.toml\n"
      "  fiberfate run case.toml --out results/fast --set flow.rate=\"100 1/s\" --until \"0.5 s\"\n"
      "  fiberfate run case.toml --sweep diffusion.C_I=0.001,0.01,0.1 --sweep solution.closure=ibof,orf");
  run->add_option("case", commands.run.case_file, "The case file")->required()->type_name("CASE.toml");
  run->add_option("--out", commands.run.out, "The result folder")->type_name("DIR");
  add_limits(*run, commands.run, commands.run_until);
  add_changes(*run, commands.run.changes);
  run->add_option("--sweep", commands.run.sweep,
                  "Run the case once for each value of a key, each into a folder below DIR, and set their "
                  "summaries side by side in DIR/sweep.csv; given more than once: every combination")
      ->type_name("KEY=VALUE,VALUE")
      ->allow_extra_args(false);
  add_overwrite(*run, commands.run.existing, "a result");
  run->callback([&commands] {
    if (commands.run_until) commands.run.session.until = time_to_stop(*commands.run_until);
    commands.status = run_run(commands.run);
  });

  CLI::App* resume = app.add_subcommand("resume", "Continue a run from its last checkpoint");
  resume->footer(
      "Examples:\n  fiberfate resume results/fast\n  fiberfate resume results/fast --until \"20 s\"");
  resume->add_option("dir", commands.resume.out, "The result folder")->required()->type_name("DIR");
  add_limits(*resume, commands.resume, commands.resume_until);
  resume->callback([&commands] {
    if (commands.resume_until) commands.resume.session.until = time_to_stop(*commands.resume_until);
    commands.status = run_resume(commands.resume);
  });
}

void add_result_commands(CLI::App& app, Commands& commands) {
  CLI::App* report = app.add_subcommand(
      "report", "Write the report of a result, DIR/report.html, or one page that compares several");
  report->footer(
      "Examples:\n  fiberfate report results/fast\n  fiberfate report results/fast results/slow --out "
      "comparison.html");
  report
      ->add_option("dir", commands.report.folders,
                   "The result folder; several of one study: a comparison, a line a run, "
                   "replicas that differ in their seeds as a band")
      ->required()
      ->type_name("DIR");
  report
      ->add_option("--out", commands.report.out,
                   "The page; of several results comparison.html in the folder that holds them all")
      ->type_name("FILE");
  add_overwrite(*report, commands.report.existing, "a page that --out names, or a comparison, that is");
  report->callback([&commands] { commands.status = run_report(commands.report); });

  CLI::App* export_result = app.add_subcommand("export", "Write a result in another format");
  export_result->footer("Example:\n  fiberfate export results/fast --format vtp");
  export_result->add_option("dir", commands.export_result.folder, "The result folder")
      ->required()
      ->type_name("DIR");
  export_result
      ->add_option("--format", commands.export_result.format,
                   "vtp (ParaView 5.11 and older), csv, abaqus or calculix")
      ->required()
      ->type_name("FORMAT");
  export_result->add_option("--out", commands.export_result.out, "Where to write")->type_name("DIR");
  export_result->callback([&commands] { commands.status = run_export(commands.export_result); });

  CLI::App* cite =
      app.add_subcommand("cite", "Print what a paper says of a result: method, laws, values, references");
  cite->footer("Examples:\n  fiberfate cite\n  fiberfate cite results/fast");
  cite->add_option("dir", commands.cite.folder, "The result folder; left out: how to cite the program")
      ->type_name("DIR");
  cite->callback([&commands] { commands.status = run_cite(commands.cite); });

  CLI::App* import_case =
      app.add_subcommand("import", "Turn input decks of the published program into a case");
  import_case->footer(
      "Example:\n  fiberfate import old_run my_study\nThe folder holds Fibers.in and "
      "Initial_Positions.txt, and DynamicParameters.in where the flow follows a table.");
  import_case->add_option("legacy_dir", commands.import_case.legacy_folder, "The folder with the decks")
      ->required()
      ->type_name("LEGACY_DIR");
  import_case->add_option("dir", commands.import_case.out, "Folder to write to")->type_name("DIR");
  add_overwrite(*import_case, commands.import_case.existing, "a case");
  import_case->callback([&commands] { commands.status = run_import(commands.import_case); });
}

/// Says how a changed cell starts from saved fibers: paths in a case begin at its folder.
std::string resume_keeps_the_case(const std::vector<std::string>& words) {
  const std::string folder = words.size() > 1 && !words[1].starts_with('-') ? words[1] : "DIR";
  const std::filesystem::path saved_case = std::filesystem::path(folder) / "case.resolved.toml";
  return fmt::format(
      "'resume' goes on with the case as it was: to change keys of a cell from here on, start the changed "
      "case from the saved fibers: fiberfate run {} --out NEW --set KEY=VALUE --set cluster.source=file "
      "--set cluster.file=checkpoint.h5",
      saved_case.string());
}

/// States what is wrong with a command line that CLI11 refused, with the nearest option or command.
std::string refusal(const CLI::App& app, const CLI::ParseError& error,
                    const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  std::vector<std::string> names;
  for (const CLI::App* one : app.get_subcommands({})) names.push_back(one->get_name());
  for (const CLI::App* one : app.get_subcommands()) command = one;
  if (command == &app && !words.empty() && !words.front().starts_with('-')) {
    const std::string nearest = nearest_word(words.front(), names);
    return fmt::format("unknown command '{}': {}", words.front(),
                       nearest.empty() ? fmt::format("the commands are {}", fmt::join(names, ", "))
                                       : fmt::format("did you mean '{}'?", nearest));
  }
  std::vector<std::string> options;
  for (const CLI::Option* option : command->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || std::find(options.begin(), options.end(), name) != options.end()) continue;
    if (command->get_name() == "resume" && (name == "--set" || name == "--variant"))
      return resume_keeps_the_case(words);
    const std::string nearest = nearest_word(name, options);
    return fmt::format("unknown option '{}': {}", name,
                       nearest.empty() ? fmt::format("the options are {}", fmt::join(options, ", "))
                                       : fmt::format("did you mean '{}'?", nearest));
  }
  const std::string where = command == &app ? "" : ' ' + command->get_name();
  return fmt::format("{}: see 'fiberfate{} --help'", error.what(), where);
}

int report_error(ExitStatus status, const std::string& message) {
  say(fmt::format("fiberfate: {}\n", message));
  return static_cast<int>(status);
}

int report_problems(const InputError& error) {
  say(fmt::format("{}\n", error.what()));
  if (error.problems().size() > 1)
    say(fmt::format("{} errors; nothing was written\n", error.problems().size()));
  return static_cast<int>(ExitStatus::bad_input);
}

}  // namespace

int run_command_line(int argument_count, const char* const* arguments) {
  CLI::App app(overview, "fiberfate");
  Commands commands;
  app.set_version_flag("--version", fmt::format("fiberfate {}", version));
  app.require_subcommand(1);
  app.footer(statuses);
  add_case_commands(app, commands);
  add_run_commands(app, commands);
  add_result_commands(app, commands);
  try {
    if (argument_count < 2) {
      say(app.help());
      return static_cast<int>(ExitStatus::bad_input);
    }
    check_environment();
    app.parse(argument_count, arguments);
    // What is still to be printed may not fit on a full disk.
    if (std::fflush(stdout) != 0)
      throw std::system_error(errno, std::generic_category(), "cannot write the output");
    return commands.status;
  } catch (const CLI::Success& answer) {  // --help, --version
    return app.exit(answer);
  } catch (const CLI::ParseError& error) {
    return report_error(
        ExitStatus::bad_input,
        refusal(app, error, std::vector<std::string>(arguments + 1, arguments + argument_count)));
  } catch (const InputError& error) {
    return report_problems(error);
  } catch (const SimulationFailure& error) {
    return report_error(ExitStatus::failed, fmt::format("the simulation failed: {}", error.what()));
  } catch (const StorageError& error) {
    return report_error(ExitStatus::failed, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    // A closed folder, a link that leads back to itself, a name that is too long.
    const int reason = error.code().value();
    const bool full = reason == ENOSPC || reason == EDQUOT;
    return report_error(
        full ? ExitStatus::failed : ExitStatus::bad_input,
        fmt::format("{}: {}{}", error.path1().string(), reason_text(reason), full ? "" : ": check the path"));
  } catch (const std::bad_alloc&) {
    return report_error(ExitStatus::failed, out_of_memory);
  } catch (const std::length_error&) {  // more than any machine has
    return report_error(ExitStatus::failed, out_of_memory);
  } catch (const std::system_error& error) {  // of the standard streams
    if (error.code() == std::errc::broken_pipe)
      return static_cast<int>(ExitStatus::done);  // a reader that has seen enough
    return report_error(ExitStatus::failed,
                        fmt::format("cannot write the output: {}", reason_text(error.code().value())));
  } catch (const std::exception& error) {
    return report_error(ExitStatus::failed, fmt::format("an error of the program itself: {}", error.what()));
  }
}

}  // namespace fiberfate
