#include "ui/video_encoder.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "ui/picture_export.hpp"

extern char** environ;

namespace biotope {
namespace {

constexpr useconds_t look_every = 20000;  // microseconds between looks at whether it is done

/// The last line of a text file that says something.
std::string last_line(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::string last;
  while (std::getline(in, line)) {
    if (!line.empty()) last = line;
  }
  return last;
}

/// Waits until a process is over; its exit code, or -1 when it was stopped because that was asked for.
int wait_for(pid_t process, const TaskContext& context) {
  int status = 0;
  while (true) {
    const pid_t ended = ::waitpid(process, &status, WNOHANG);
    if (ended == process) return WIFEXITED(status) ? WEXITSTATUS(status) : 255;
    if (ended < 0) return 255;
    if (context.stopped()) {
      ::kill(process, SIGKILL);
      ::waitpid(process, &status, 0);
      return -1;
    }
    ::usleep(look_every);
  }
}

}  // namespace

std::optional<std::filesystem::path> find_ffmpeg() {
  const char* path = std::getenv("PATH");
  std::string folders = path != nullptr ? path : "";
  while (!folders.empty()) {
    const std::size_t end = folders.find(':');
    const std::filesystem::path candidate = std::filesystem::path(folders.substr(0, end)) / "ffmpeg";
    std::error_code error;
    if (std::filesystem::is_regular_file(candidate, error) && ::access(candidate.c_str(), X_OK) == 0) return candidate;
    folders = end == std::string::npos ? std::string() : folders.substr(end + 1);
  }
  return std::nullopt;
}

Result<std::shared_ptr<const FramesFolder>> FramesFolder::make(const std::filesystem::path& video) {
  // mkdtemp makes a name that nothing else has: neither pictures of a person nor those of an earlier try get into the video.
  std::string name = video.string() + ".frames-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) return fail(name + ": cannot be made: " + std::strerror(errno) + ".");
  return std::shared_ptr<const FramesFolder>(new FramesFolder(name));
}

FramesFolder::~FramesFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Status encode_video(const std::filesystem::path& frames, double frames_a_second, const std::filesystem::path& video,
                    const TaskContext& context) {
  const auto program = find_ffmpeg();
  if (!program) return fail("A video needs ffmpeg, which is not installed.");
  const std::filesystem::path part = frames / "video.mp4";
  const std::filesystem::path log = frames / "ffmpeg.log";
  // Even sides, which the format needs; colours that every player shows.
  std::vector<std::string> words{program->string(),
                                 "-y",
                                 "-loglevel",
                                 "error",
                                 "-framerate",
                                 std::to_string(frames_a_second),
                                 "-i",
                                 (frames / "frame-%05d.png").string(),
                                 "-vf",
                                 "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                 "-c:v",
                                 "libx264",
                                 "-crf",
                                 "17",
                                 "-pix_fmt",
                                 "yuv420p",
                                 "-movflags",
                                 "+faststart",
                                 part.string()};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&files, 1, 2);
  pid_t process = 0;
  const int refused = ::posix_spawn(&process, program->c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (refused != 0) return fail("ffmpeg could not be started.");
  const int code = wait_for(process, context);
  if (code < 0) return fail("stopped");
  std::error_code error;
  if (code != 0 || !std::filesystem::is_regular_file(part, error)) {
    const std::string said = last_line(log);
    return fail("ffmpeg did not make the video" + (said.empty() ? std::string(".") : ": " + said));
  }
  std::filesystem::rename(part, video, error);
  if (error) return fail(video.string() + ": cannot be written: " + error.message() + ".");
  return {};
}

}  // namespace biotope
