#include "ui/panels/selection_panel.hpp"

#include "ui/dialogs.hpp"
#include "ui/edit_actions.hpp"
#include "ui/editor_actions.hpp"
#include "ui/panels/filter_panel.hpp"

namespace biotope {
namespace {

void command_text_button(const UiContext& ui, const char* id, const char* label, float width) {
  const EditorCommand* command = ui.commands.find(id);
  if (command == nullptr) return;
  ImGui::BeginDisabled(!enabled(*command, ui.state));
  if (ImGui::Button(label, ImVec2(width, 0))) run(*command, ui.state);
  ImGui::EndDisabled();
  tooltip(ui.theme, command->tooltip, ui.commands.keys(id));
}

}  // namespace

void draw_selection_panel(const UiContext& ui) {
  EditorState& state = ui.state;
  heading(ui.theme, state.document.selection ? "Selection" : "Nothing is selected: edits act everywhere");
  const float gap = ui.theme.px(6);
  const float half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  command_text_button(ui, "select.drop", "Deselect", half);
  ImGui::SameLine(0, gap);
  command_text_button(ui, "select.invert", "Invert", half);
  command_text_button(ui, "select.range", "By value ...", half);
  ImGui::SameLine(0, gap);
  command_text_button(ui, "paint.fill", "Fill", half);
  command_text_button(ui, "paint.restore", "Take paint off", half);
  ImGui::SameLine(0, gap);
  command_text_button(ui, "lock.add", "Lock", half);
  if (state.document.locked_area) {
    command_text_button(ui, "lock.subtract", "Unlock", half);
    ImGui::SameLine(0, gap);
    command_text_button(ui, "lock.nothing", "Unlock all", half);
    hint(ui.theme, "The hatched ground is locked: no edit changes paint there.");
  }
  hint(ui.theme, "Drag: select. Shift adds, Ctrl takes away, both keep what is in both.");
}

void draw_select_range(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!begin_modal(ui, "Select by value", state.dialogs.select_range, 420)) return;
  FilterCondition& range = state.paint.range;
  if (range.low == 0 && range.high == 0) range = new_condition(state, FilterQuantity::slope);
  const std::string title = condition_title(state, range);
  if (ImGui::Button((title + " ...").c_str(), ImVec2(-1, 0))) ImGui::OpenPopup("quantity");
  tooltip(ui.theme, "What to look at");
  if (ImGui::BeginPopup("quantity")) {
    if (const auto chosen = condition_menu(state)) range = *chosen;
    ImGui::EndPopup();
  }
  readout(ui.theme, "From, to", condition_text(state, range));
  (void)draw_condition(ui, range);
  static constexpr const char* modes[] = {"Replace", "Add", "Subtract", "Intersect"};
  int mode = int(state.paint.range_mode);
  ImGui::TextDisabled("The selection that is there");
  if (segmented(ui.theme, "mode", {modes[0], modes[1], modes[2], modes[3]}, mode, ImGui::GetContentRegionAvail().x)) {
    state.paint.range_mode = SelectionMode(mode);
  }
  ImGui::Dummy(ImVec2(0, ui.theme.px(6)));
  align_buttons(ui.theme, 2, 110);
  const bool cancelled = ImGui::Button("Cancel", ImVec2(ui.theme.px(110), 0));
  ImGui::SameLine();
  const bool accepted = primary_button(ui.theme, "Select", ui.theme.px(110)) || take_key(state, DialogKey::enter);
  if (accepted || cancelled) {
    state.dialogs.select_range = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (!accepted) return;
  SelectEdit edit;
  edit.shape = SelectEdit::Shape::range;
  edit.mode = state.paint.range_mode;
  edit.range = range;
  perform_edit(state, edit);
}

}  // namespace biotope
