#include "ui/recording_commands.hpp"

#include "ui/edit_player.hpp"
#include "ui/icons.hpp"

namespace biotope {

void add_recording_commands(std::vector<EditorCommand>& list) {
  list.push_back(editor_command("file.record", "File", "Record edits", "",
                                "Write down every edit from now on, to be played again, tested or shared", "", start_recording));
  list.back().line_before = true;
  list.back().enabled = [](const EditorState& s) { return s.has_document && !s.recorder.recording() && !s.player.running(); };
  list.back().checked = [](const EditorState& s) { return s.recorder.recording(); };
  list.push_back(editor_command("file.stop_recording", "File", "Stop recording and save ...", "",
                                "Save the recorded edits as a script", icons::save, stop_and_save_recording));
  list.back().enabled = [](const EditorState& s) { return s.recorder.recording() || s.recorder.unsaved(); };
  list.push_back(editor_command("file.play", "File", "Play edits ...", "",
                                "Do again what a script of recorded edits says; each is a step that can be undone", icons::play,
                                ask_to_play));
  list.back().enabled = [](const EditorState& s) { return s.has_document && !s.recorder.recording() && !s.player.running(); };
}

}  // namespace biotope
