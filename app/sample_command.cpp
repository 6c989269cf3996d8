#include "app/sample_command.hpp"

#include <ostream>

#include "app/command_line_progress.hpp"
#include "core/exchange/open_input.hpp"
#include "core/exchange/scene_file.hpp"

namespace biotope {

Status run_sample(const std::string& name, const std::string& file, bool quiet, std::ostream& out, std::ostream& err) {
  if (!is_scene_file(file)) return fail(file + ": a scene's name ends in .biotope.");
  ProgressLine progress(err, standard_error_is_terminal(), quiet);
  const auto document = open_input("sample:" + name, {}, progress.context());
  if (!document) return tl::unexpected(document.error());
  if (Status saved = save_scene(file, *document); !saved) return saved;
  progress.clear();
  if (!quiet) out << "Written to " << file << '\n';
  return {};
}

}  // namespace biotope
