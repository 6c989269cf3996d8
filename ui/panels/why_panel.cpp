#include <cmath>

#include "ui/canvas_menu.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/panels/panels.hpp"

namespace biotope {
namespace {

void draw_answer(const Theme& theme, const Explanation& answer) {
  ImGui::PushFont(theme.bold);
  wrapped(theme.text, answer.headline);
  ImGui::PopFont();
  if (answer.fitness >= 0) readout(theme, "Fitness before competition", format_percent(answer.fitness));
  for (const std::string& detail : answer.details) hint(theme, detail);
}

void draw_present(const UiContext& ui, const CellQuestion& question) {
  const FoodWeb* web = ui.state.web();
  if (web == nullptr || !ui.state.shown) return;
  ImGui::Dummy(ImVec2(0, ui.theme.px(2)));
  const std::vector<Presence> present = present_at(*ui.state.shown, question.x, question.y);
  hint(ui.theme, present.empty() ? "Nothing lives in this cell." : "Here now");
  for (const Presence& presence : present) {
    const Species& species = web->species[std::size_t(presence.species)];
    ImGui::PushID(presence.species);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##present", presence.species == question.species)) {
      select_species(ui.state, presence.species);
      ask_why(ui.state, question.x, question.y);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float side = ui.theme.px(9);
    const float top = at.y + (ImGui::GetFontSize() - side) / 2;
    list.AddRectFilled(ImVec2(at.x, top), ImVec2(at.x + side, top + side), colour_u32(to_imgui(species.colour)), ui.theme.px(2));
    const std::string amount = species.is_plant() ? format_percent(presence.amount) : format_value(presence.amount, "/km²");
    const float right = at.x + ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(amount.c_str()).x;
    list.AddText(ImVec2(at.x + ui.theme.px(16), at.y), colour_u32(ui.theme.text), display_name(species).c_str());
    list.AddText(ImVec2(right, at.y), colour_u32(ui.theme.muted), amount.c_str());
    ImGui::PopID();
  }
}

}  // namespace

void draw_why_panel(const UiContext& ui) {
  EditorState& state = ui.state;
  const CellQuestion question = *state.question;
  const Theme& theme = ui.theme;
  const FoodWeb* web = state.web();
  const bool about = web != nullptr && question.species >= 0 && question.species < int(web->species.size());
  const std::string title =
      about ? "Why here? " + display_name(web->species[std::size_t(question.species)]) : std::string("What is here?");
  ImGui::Dummy(ImVec2(0, theme.px(2)));
  const float close = ImGui::GetFontSize() + theme.px(10);
  ImGui::PushFont(theme.bold);
  const float room = ImGui::GetContentRegionAvail().x - close;
  ImGui::TextColored(theme.accent, "%s", fitted_text(title, room).c_str());
  ImGui::PopFont();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - close + theme.px(6));
  const bool closed = icon_button(theme, "close why", theme.has_icons ? icons::close : "x", theme.muted, "Close");
  if (question.answer) {
    draw_answer(theme, *question.answer);
  } else if (about) {
    hint(theme, "This species' map is still being computed.");
  } else {
    hint(theme, "Choose a species in the list and click again to ask why it is here, or why not.");
  }
  ImGui::Checkbox("Follow the pointer", &state.view.why_follows);
  tooltip(theme, "Explain every place the pointer comes to, without a click");
  draw_present(ui, question);
  if (closed) state.question.reset();
}

}  // namespace biotope
