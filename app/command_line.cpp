#include "app/command_line.hpp"

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <memory>
#include <new>
#include <ostream>

#include "app/edit_command.hpp"
#include "app/editor.hpp"
#include "app/headless_command.hpp"
#include "app/info_command.hpp"
#include "app/render_command.hpp"
#include "app/sample_command.hpp"
#include "app/solve_command.hpp"

namespace biotope {
namespace {

/// Every command's request, filled by the parser.
struct CommandLine {
  LandscapeRequest editor;
  SolveRequest solve;
  EditRequest edit;
  RenderRequest render;
  LandscapeRequest info;
  std::string sample_name;
  std::string sample_file;
  bool sample_quiet = false;
};

/// Keeps a parsed value, or makes the Error a usage error of the option.
template <class T, class Target>
void keep(const std::string& option, const Result<T>& value, Target& target) {
  if (!value) throw CLI::ValidationError(option, value.error().message);
  target = *value;
}

/// An option whose text `parse` turns into a value; its Error is a usage error.
template <class Target, class Parse>
CLI::Option* add_parsed(CLI::App& command, const std::string& name, Target& target, Parse parse, const std::string& what,
                        const std::string& type) {
  return command
      .add_option_function<std::string>(
          name, [&target, name, parse](const std::string& text) { keep(name, parse(text), target); }, what)
      ->type_name(type);
}

/// An option that names something; empty is a usage error, since it comes from an unset variable of a script more often than not.
CLI::Option* add_name(CLI::App& command, const std::string& name, std::string& target, const std::string& what,
                      const std::string& type) {
  const auto parse = [](const std::string& text) -> Result<std::string> {
    if (text.empty()) return fail("must not be empty.");
    return text;
  };
  return add_parsed(command, name, target, parse, what, type);
}

auto number_within(double lowest, double highest) {
  return [lowest, highest](const std::string& text) { return parse_number(text, lowest, highest); };
}

auto whole_number_within(int lowest, int highest) {
  return [lowest, highest](const std::string& text) { return parse_whole_number(text, lowest, highest); };
}

void add_import_options(CLI::App& command, DemImportOptions& import) {
  add_parsed(command, "--cell-size", import.cell_size, number_within(smallest_cell, largest_cell),
             "Cell size of the input in metres; overrules its georeference", "M");
  add_parsed(command, "--raw", import.raw, parse_raw_layout,
             "FILE is headerless samples: WxH:TYPE[:big][:header=BYTES], TYPE uint8, int16, uint16, int32, uint32, float32 "
             "or float64",
             "LAYOUT");
  add_parsed(command, "--crop", import.crop, parse_crop, "Take a part of the file: X,Y,WIDTH,HEIGHT in its cells", "RECT");
  add_parsed(command, "--vertical-scale", import.vertical_scale, number_within(1e-6, 1e6), "Multiplies heights", "FACTOR");
  add_parsed(command, "--vertical-offset", import.vertical_offset, number_within(-12000, 12000), "Added to heights, metres", "M");
  add_parsed(command, "--latitude", import.latitude, number_within(-90, 90), "Degrees north; overrules the input's", "DEGREES");
}

void add_file(CLI::App& command, std::string& input) {
  add_name(command, "FILE", input, "A scene (.biotope), a DEM, or sample:NAME", "");
}

void add_quiet(CLI::App& command, bool& quiet) { command.add_flag("--quiet", quiet, "No progress"); }

void add_ecosystem_options(CLI::App& command, LandscapeRequest& request) {
  add_name(command, "--climate", request.climate, "Climate by name, in place of the input's", "NAME");
  add_name(command, "--species", request.species_file, "Species file, in place of the input's", "FILE");
  add_parsed(command, "--seed", request.seed, parse_seed, "Seed of everything random", "N");
  add_parsed(command, "--threads", request.threads, whole_number_within(1, 4096),
             "Most threads to use; the result does not depend on it", "N");
  add_name(command, "--environment", request.environment_folder, "Folder of maps that replace computed ones", "DIR");
  add_quiet(command, request.quiet);
}

void add_solve(CLI::App& program, SolveRequest& request) {
  CLI::App& command = *program.add_subcommand("solve", "Compute a landscape and write its maps and reports");
  add_file(command, request.landscape.input);
  command.get_option("FILE")->required();
  add_name(command, "--out", request.folder, "Folder to write into", "DIR")->required();
  add_parsed(command, "--size", request.landscape.import.longer_side, whole_number_within(2, 16384),
             "Cells of the longer side after resampling", "N");
  const auto which_maps = [](const std::string& text) -> Result<bool> {
    if (text != "all") return fail("'" + text + "': expected all.");
    return true;
  };
  // solve never does otherwise; the flag is for scripts that compare with 'edit' and want to say so.
  command.add_flag_function(
      "--from-scratch", [](std::int64_t) {}, "Compute everything anew, as solve always does");
  add_parsed(command, "--maps", request.all_maps, which_maps, "'all' also writes fitness and monthly environment maps", "all");
  add_import_options(command, request.landscape.import);
  add_ecosystem_options(command, request.landscape);
}

void add_edit(CLI::App& program, EditRequest& request) {
  CLI::App& command = *program.add_subcommand("edit", "Play recorded edits on a landscape and save the result as a scene");
  add_file(command, request.landscape.input);
  command.get_option("FILE")->required();
  add_name(command, "--script", request.script, "Edit script to play (File > Record edits in the editor)", "EDITS.json")
      ->required();
  add_name(command, "--out", request.scene, "Scene to write", "FILE2.biotope")->required();
  add_name(command, "--maps", request.maps_folder, "Also write what solve writes, of the result, into this folder", "DIR");
  command.add_flag("--verify", request.verify,
                   "Fail unless the maps kept up to date from edit to edit equal those computed from scratch, to the bit");
  add_import_options(command, request.landscape.import);
  add_ecosystem_options(command, request.landscape);
}

void add_render(CLI::App& program, RenderRequest& request) {
  CLI::App& command = *program.add_subcommand("render", "Compute a landscape and draw it in 3D");
  add_file(command, request.landscape.input);
  command.get_option("FILE")->required();
  add_name(command, "--out", request.picture, "Picture to write; with --path a folder, or a video that ends in .mp4", "PNG")
      ->required();
  add_name(command, "--path", request.path_file, "Camera path to fly along, written by the editor", "PATH.json");
  add_parsed(command, "--fps", request.frames_a_second, number_within(1, 120), "Pictures a second along the path, 25 unless told",
             "N");
  add_parsed(command, "--size", request.size, parse_picture_size, "Pixels, 1280x720 unless told", "WxH");
  add_parsed(command, "--camera", request.view, parse_camera,
             "x,y,z,heading,pitch: metres from the south-west corner and above the sea (+z: the ground), degrees", "VIEW");
  add_parsed(command, "--hour", request.hour, number_within(0, 24), "Local solar time, 10.5 unless told", "H");
  add_parsed(command, "--month", request.month, whole_number_within(1, 12), "1 is January; 6 unless told", "M");
  add_parsed(command, "--weather", request.weather, parse_weather, "clear, fair (the default), overcast, rain, fog or storm",
             "NAME");
  add_parsed(command, "--seconds", request.seconds, number_within(0, 1e6),
             "Time of what moves (leaves, waves, rain), 0 unless told", "S");
  add_parsed(command, "--quality", request.quality, number_within(0.25, 4), "0.5 low, 1 medium, 2 high (the default)", "Q");
  add_import_options(command, request.landscape.import);
  add_ecosystem_options(command, request.landscape);
}

void add_info(CLI::App& program, LandscapeRequest& request) {
  CLI::App& command = *program.add_subcommand("info", "Say what a file holds");
  add_file(command, request.input);
  command.get_option("FILE")->required();
  add_import_options(command, request.import);
}

void add_sample(CLI::App& program, CommandLine& line) {
  CLI::App& command = *program.add_subcommand("sample", "Save a built-in landscape as a scene");
  add_name(command, "NAME", line.sample_name, "valley, valley-1m, ...", "")->required();
  add_name(command, "--out", line.sample_file, "Scene to write", "FILE.biotope")->required();
  add_quiet(command, line.sample_quiet);
}

Status run_editor_or_say_why(const LandscapeRequest& request, std::ostream& out, std::ostream& err) {
  if (!display_available()) return run_without_display(request, "out", out, err);
  return run_editor({request.input, request.import});
}

Status dispatch(const CLI::App& program, const CommandLine& line, std::ostream& out, std::ostream& err) {
  const auto chosen = [&](const char* name) { return program.got_subcommand(name); };
  std::unique_ptr<tbb::global_control> limit;
  const int threads = chosen("render") ? line.render.landscape.threads
                      : chosen("edit") ? line.edit.landscape.threads
                                       : line.solve.landscape.threads;
  if (threads > 0) {
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  }
  if (chosen("solve")) return run_solve(line.solve, out, err);
  if (chosen("edit")) return run_edit(line.edit, out, err);
  if (chosen("render")) return run_render(line.render, out, err);
  if (chosen("info")) return run_info(line.info, out);
  if (chosen("sample")) return run_sample(line.sample_name, line.sample_file, line.sample_quiet, out, err);
  return run_editor_or_say_why(line.editor, out, err);
}

/// Options before a command's name would be the editor's; nobody means that.
void refuse_options_before_command(const CLI::App& program) {
  const auto commands = program.get_subcommands();
  if (commands.empty()) return;
  for (const CLI::Option* option : program.get_options()) {
    if (option->count() == 0) continue;
    const std::string what = option->get_positional() ? "'" + option->as<std::string>() + "'" : option->get_name();
    throw CLI::ValidationError(what, "must come after '" + commands.front()->get_name() + "'.");
  }
}

int usage_error(const CLI::App& program, std::string what, std::ostream& err) {
  const auto commands = program.get_subcommands();
  const std::string help = "biotope " + (commands.empty() ? "" : commands.front()->get_name() + " ") + "--help";
  if (!what.empty() && what.back() != '.') what += '.';
  err << "biotope: " << what << " Try '" << help << "'." << std::endl;
  return exit_usage;
}

int parse_and_run(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  CommandLine line;
  CLI::App program("Living landscapes: from a terrain to its plants, animals and trails", "biotope");
  program.set_version_flag("--version", "biotope " BIOTOPE_VERSION);
  program.require_subcommand(0, 1);
  add_file(program, line.editor.input);
  add_import_options(program, line.editor.import);
  add_solve(program, line.solve);
  add_edit(program, line.edit);
  add_render(program, line.render);
  add_info(program, line.info);
  add_sample(program, line);

  try {
    // CLI11 takes its arguments from the back.
    program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    refuse_options_before_command(program);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error, out, err);
    return usage_error(program, error.what(), err);
  }
  const Status done = dispatch(program, line, out, err);
  if (done) return exit_success;
  err << "biotope: " << done.error().message << std::endl;
  return exit_failure;
}

}  // namespace

int run_command_line(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  try {
    return parse_and_run(arguments, out, err);
  } catch (const std::bad_alloc&) {
    err << "biotope: there is not enough memory; give a smaller --size, or take a part of the input with --crop." << std::endl;
  } catch (const std::exception& error) {
    err << "biotope: " << error.what() << std::endl;
  }
  return exit_failure;
}

}  // namespace biotope
