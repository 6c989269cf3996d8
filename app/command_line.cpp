#include "app/command_line.hpp"

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <ostream>

#include "app/editor.hpp"
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

void add_import_options(CLI::App& command, DemImportOptions& import) {
  command.add_option("--cell-size", import.cell_size, "Cell size of the input in metres; overrules its georeference")
      ->check(CLI::PositiveNumber)
      ->type_name("M");
  command.add_option_function<std::string>(
             "--raw", [&import](const std::string& text) { keep("--raw", parse_raw_layout(text), import.raw); },
             "FILE is headerless samples: WxH:TYPE[:big][:header=BYTES], TYPE uint8, int16, uint16, int32, uint32, "
             "float32 or float64")
      ->type_name("LAYOUT");
  command.add_option_function<std::string>(
             "--crop", [&import](const std::string& text) { keep("--crop", parse_crop(text), import.crop); },
             "Take a part of the file: X,Y,WIDTH,HEIGHT in its cells")
      ->type_name("RECT");
  command.add_option("--vertical-scale", import.vertical_scale, "Multiplies heights")->check(CLI::PositiveNumber);
  command.add_option("--vertical-offset", import.vertical_offset, "Added to heights, metres");
  command.add_option("--latitude", import.latitude, "Degrees north, where the input does not tell")
      ->check(CLI::Range(-90.0, 90.0));
}

void add_file(CLI::App& command, std::string& input) {
  command.add_option("FILE", input, "A scene (.biotope), a DEM, or sample:NAME");
}

void add_quiet(CLI::App& command, bool& quiet) { command.add_flag("--quiet", quiet, "No progress"); }

void add_ecosystem_options(CLI::App& command, LandscapeRequest& request) {
  command.add_option("--climate", request.climate, "Climate by name, in place of the input's")->type_name("NAME");
  command.add_option("--species", request.species_file, "Species file, in place of the input's")->type_name("FILE");
  command.add_option("--seed", request.seed, "Seed of everything random")->type_name("N");
  command.add_option("--threads", request.threads, "Most threads to use; the result does not depend on it")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  command.add_option("--environment", request.environment_folder, "Folder of maps that replace computed ones")
      ->type_name("DIR");
  add_quiet(command, request.quiet);
}

void add_solve(CLI::App& program, SolveRequest& request) {
  CLI::App& command = *program.add_subcommand("solve", "Compute a landscape and write its maps and reports");
  add_file(command, request.landscape.input);
  command.get_option("FILE")->required();
  command.add_option("--out", request.folder, "Folder to write into")->required()->type_name("DIR");
  command.add_option("--size", request.landscape.import.longer_side, "Cells of the longer side after resampling")
      ->check(CLI::Range(2, 16384))
      ->type_name("N");
  command.add_option_function<std::string>(
             "--maps", [&request](const std::string&) { request.all_maps = true; },
             "'all' also writes fitness and monthly environment maps")
      ->check(CLI::IsMember({"all"}));
  add_import_options(command, request.landscape.import);
  add_ecosystem_options(command, request.landscape);
}

void add_render(CLI::App& program, RenderRequest& request) {
  CLI::App& command = *program.add_subcommand("render", "Compute a landscape and draw it in 3D");
  add_file(command, request.landscape.input);
  command.get_option("FILE")->required();
  command.add_option("--out", request.picture, "Picture to write")->required()->type_name("PNG");
  command.add_option_function<std::string>(
             "--size", [&request](const std::string& text) { keep("--size", parse_picture_size(text), request.size); },
             "Pixels, 1280x720 unless told")
      ->type_name("WxH");
  command.add_option_function<std::string>(
             "--camera", [&request](const std::string& text) { keep("--camera", parse_camera(text), request.camera); },
             "x,y,z,heading,pitch: metres from the south-west corner and above the sea, degrees")
      ->type_name("VIEW");
  command.add_option("--hour", request.hour, "Local solar time")->check(CLI::Range(0.0, 24.0));
  command.add_option("--month", request.month, "1 is January")->check(CLI::Range(1, 12));
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
  command.add_option("NAME", line.sample_name, "valley, valley-1m, ...")->required();
  command.add_option("--out", line.sample_file, "Scene to write")->required()->type_name("FILE.biotope");
  add_quiet(command, line.sample_quiet);
}

/// Where the editor cannot open: computes the landscape and writes maps and a picture, so that the command is never useless.
Status run_without_display(const LandscapeRequest& request, std::ostream& out, std::ostream& err) {
  const std::filesystem::path folder = "out";
  err << "biotope: there is no display to open a window on; computing " << request.input << " and writing its maps and "
      << "a picture of the 3D view into " << folder.string() << "/ instead.\n";
  if (Status solved = run_solve({request, folder.string(), false}, out, err); !solved) return solved;
  RenderRequest picture;
  picture.landscape = request;
  picture.picture = (folder / "landscape.png").string();
  return run_render(picture, out, err);
}

Status run_editor_or_say_why(const LandscapeRequest& request, std::ostream& out, std::ostream& err) {
  if (!display_available()) return run_without_display(request, out, err);
  return run_editor({request.input, request.import});
}

Status dispatch(const CLI::App& program, const CommandLine& line, std::ostream& out, std::ostream& err) {
  const auto chosen = [&](const char* name) { return program.got_subcommand(name); };
  std::unique_ptr<tbb::global_control> limit;
  const int threads = chosen("render") ? line.render.landscape.threads : line.solve.landscape.threads;
  if (threads > 0) {
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  }
  if (chosen("solve")) return run_solve(line.solve, out, err);
  if (chosen("render")) return run_render(line.render, out, err);
  if (chosen("info")) return run_info(line.info, out);
  if (chosen("sample")) return run_sample(line.sample_name, line.sample_file, line.sample_quiet, out, err);
  return run_editor_or_say_why(line.editor, out, err);
}

}  // namespace

int run_command_line(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  CommandLine line;
  CLI::App program("Living landscapes: from a terrain to its plants, animals and trails", "biotope");
  program.set_version_flag("--version", "biotope " BIOTOPE_VERSION);
  program.require_subcommand(0, 1);
  add_file(program, line.editor.input);
  add_import_options(program, line.editor.import);
  add_solve(program, line.solve);
  add_render(program, line.render);
  add_info(program, line.info);
  add_sample(program, line);

  try {
    // CLI11 takes its arguments from the back.
    program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error, out, err);
    err << "biotope: " << error.what() << "\nTry 'biotope --help'.\n";
    return exit_usage;
  }
  const Status done = dispatch(program, line, out, err);
  if (done) return exit_success;
  err << "biotope: " << done.error().message << std::endl;
  return exit_failure;
}

}  // namespace biotope
