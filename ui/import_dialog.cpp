#include "ui/import_dialog.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/crop_selection.hpp"
#include "ui/dialogs.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/view_transform.hpp"

namespace biotope {
namespace {

constexpr float button_width = 110;
constexpr std::array<const char*, 7> sample_types{"uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};

bool has_raw_ending(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".raw" || ending == ".r16" || ending == ".r32";
}

/// The side of a square raster of 16-bit samples that fills the file; 0 when there is none.
int square_side(const std::filesystem::path& file, std::uintmax_t bytes_a_sample) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (error) return 0;
  const auto side = std::uintmax_t(std::llround(std::sqrt(double(bytes / bytes_a_sample))));
  return side * side * bytes_a_sample == bytes && side <= 16384 ? int(side) : 0;
}

}  // namespace

void ImportDialog::look(const std::filesystem::path& file) {
  if (file != file_) {
    file_ = file;
    cell_size_ = 0;
    vertical_scale_ = 1;
    longer_side_ = 0;
    keep_voids_ = false;
    crop_.reset();
    is_raw_ = has_raw_ending(file);
    raw_ = {};
    raw_.width = raw_.height = square_side(file, 2);
  }
  preview_.reset();
  picture_.reset();
  problem_.clear();
  looking_.start("Looking at the file",
                 [file, options = chosen(false)](const TaskContext&) { return preview_dem(file, options); });
}

void ImportDialog::take_preview() {
  std::optional<Result<DemPreview>> looked = looking_.take();
  if (!looked) return;
  if (!*looked) {
    problem_ = looked->error().message;
    return;
  }
  preview_ = std::move(**looked);
  auto snapshot = std::make_shared<MapsSnapshot>();
  snapshot->document.terrain = std::make_shared<const Terrain>(preview_->thumbnail);
  picture_ = std::move(snapshot);
}

bool ImportDialog::needs_cell_size() const { return preview_ && !preview_->cell_size && cell_size_ <= 0; }

DemImportOptions ImportDialog::chosen(bool with_crop) const {
  DemImportOptions options;
  if (with_crop) options.crop = crop_;
  if (cell_size_ > 0) options.cell_size = cell_size_;
  options.vertical_scale = vertical_scale_;
  if (longer_side_ > 0) options.longer_side = longer_side_;
  options.voids = keep_voids_ ? VoidHandling::keep_as_sea : VoidHandling::fill;
  if (is_raw_) options.raw = raw_;
  return options;
}

void ImportDialog::draw_picture(const UiContext& ui, float side) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("picture", ImVec2(side, side));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, ImVec2(at.x + side, at.y + side), colour_u32(ui.theme.window), ui.theme.px(4));
  if (!picture_) {
    const std::string words = looking_.running() ? "Looking at the file ..." : "No picture";
    const ImVec2 text = ImGui::CalcTextSize(words.c_str());
    list.AddText(ImVec2(at.x + (side - text.x) / 2, at.y + (side - text.y) / 2), colour_u32(ui.theme.muted), words.c_str());
    return;
  }
  if (!renderer_) {
    auto made = MapRenderer::create();
    if (!made) return;
    renderer_ = std::move(*made);
    target_ = std::make_unique<RenderTarget>(int(side), int(side));
  }
  target_->resize(int(side), int(side));
  renderer_->set_snapshot(picture_);
  MapOptions options;
  options.view = fitted(picture_->terrain().height.rect(), {double(side), double(side)}, ui.theme.px(6));
  options.herds = options.trails = options.water = false;
  options.dark = ui.theme.dark;
  options.pixel_scale = ui.theme.scale;
  target_->bind();
  renderer_->draw(options, int(side), int(side));
  const auto texture = reinterpret_cast<ImTextureID>(std::uintptr_t(target_->texture()));
  list.AddImageRounded(texture, at, ImVec2(at.x + side, at.y + side), ImVec2(0, 1), ImVec2(1, 0), IM_COL32_WHITE, ui.theme.px(4));
  drag_crop(options.view, at, side);
  draw_crop(ui, options.view, at, side);
}

void ImportDialog::drag_crop(const MapView& view, ImVec2 at, float side) {
  if (!preview_) return;
  if (ImGui::IsItemActivated()) crop_from_ = ImGui::GetIO().MousePos;
  if (!ImGui::IsItemActive()) return;
  const PixelPoint canvas{double(side), double(side)};
  const auto cell = [&](ImVec2 pixel) { return cell_at(view, canvas, {double(pixel.x - at.x), double(pixel.y - at.y)}); };
  const Grid<float>& shown = picture_->terrain().height;
  crop_ = cropped_cells(cell(crop_from_), cell(ImGui::GetIO().MousePos), shown.width(), shown.height(), preview_->width,
                        preview_->height);
}

void ImportDialog::draw_crop(const UiContext& ui, const MapView& view, ImVec2 at, float side) const {
  if (!crop_ || !preview_) return;
  const Grid<float>& shown = picture_->terrain().height;
  const auto corner = [&](int x, int y) {
    const double across = double(x) / preview_->width * shown.width() - 0.5;
    const double down = double(y) / preview_->height * shown.height() - 0.5;
    const PixelPoint pixel = pixel_of(view, {double(side), double(side)}, across, down);
    return ImVec2(at.x + float(pixel.x), at.y + float(pixel.y));
  };
  const ImVec2 low = corner(crop_->x0, crop_->y0);
  const ImVec2 high = corner(crop_->x1, crop_->y1);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 shade = IM_COL32(0, 0, 0, 120);
  list.AddRectFilled(at, ImVec2(at.x + side, low.y), shade);
  list.AddRectFilled(ImVec2(at.x, high.y), ImVec2(at.x + side, at.y + side), shade);
  list.AddRectFilled(ImVec2(at.x, low.y), ImVec2(low.x, high.y), shade);
  list.AddRectFilled(ImVec2(high.x, low.y), ImVec2(at.x + side, high.y), shade);
  list.AddRect(low, high, colour_u32(ui.theme.accent), 0, 0, ui.theme.px(1.5F));
}

void ImportDialog::draw_facts(const UiContext& ui) const {
  if (!preview_) return;
  const DemPreview& p = *preview_;
  readout(ui.theme, "Format", p.format + ", " + p.sample_type);
  readout(ui.theme, "Cells", std::to_string(p.width) + " x " + std::to_string(p.height));
  if (p.cell_size) {
    readout(ui.theme, "Cell size", format_value(*p.cell_size, "m"));
    readout(ui.theme, "Extent", format_length(p.width * *p.cell_size) + " x " + format_length(p.height * *p.cell_size));
  } else {
    readout(ui.theme, "Cell size", "not in the file");
  }
  readout(ui.theme, "Heights", format_value(p.lowest, "m") + " to " + format_value(p.highest, "m"));
  readout(ui.theme, "Reference", p.crs_name.empty() ? "none" : fitted_text(p.crs_name, ui.theme.px(190)));
  const double share = p.total_cells > 0 ? double(p.void_cells) / double(p.total_cells) : 0;
  readout(ui.theme, "Cells without data", p.void_cells == 0 ? "none" : format_percent(share));
  for (const std::string& note : p.notes) hint(ui.theme, note);
}

void ImportDialog::draw_raw_fields(const UiContext& ui) {
  bool changed = ImGui::InputInt("Width", &raw_.width, 0);
  changed = ImGui::InputInt("Height", &raw_.height, 0) || changed;
  if (ImGui::BeginCombo("Samples", raw_.sample_type.c_str())) {
    for (const char* type : sample_types) {
      if (ImGui::Selectable(type, raw_.sample_type == type)) {
        raw_.sample_type = type;
        changed = true;
      }
    }
    ImGui::EndCombo();
  }
  changed = ImGui::Checkbox("Most significant byte first", &raw_.big_endian) || changed;
  if (changed && raw_.width > 1 && raw_.height > 1) look(file_);
  hint(ui.theme, "This file has no header: give its size and kind of samples.");
}

void ImportDialog::draw_fields(const UiContext& ui) {
  ImGui::PushItemWidth(ui.theme.px(110));
  if (is_raw_) draw_raw_fields(ui);
  ImGui::InputDouble("Cell size, m", &cell_size_, 0, 0,
                     cell_size_ > 0 ? "%.3g" : (preview_ && preview_->cell_size ? "as in the file" : "required"));
  tooltip(ui.theme, "0 takes the file's own");
  cell_size_ = std::max(cell_size_, 0.0);
  ImGui::InputDouble("Heights times", &vertical_scale_, 0, 0, "%.4g");
  tooltip(ui.theme, "1 for metres, 0.3048 for feet");
  if (!(vertical_scale_ > 0)) vertical_scale_ = 1;
  if (crop_) {
    readout(ui.theme, "Part taken", std::to_string(crop_->width()) + " x " + std::to_string(crop_->height()) + " cells");
    if (ImGui::Button("Take the whole file")) crop_.reset();
  } else if (preview_) {
    hint(ui.theme, "Drag over the picture to take only a part of it.");
  }
  ImGui::InputScalar("Cells on the longer side", ImGuiDataType_S32, &longer_side_, nullptr, nullptr,
                     longer_side_ > 0 ? "%d" : "as in the file");
  tooltip(ui.theme, "0 keeps the file's own resolution");
  longer_side_ = longer_side_ == 0 ? 0 : std::clamp(longer_side_, 16, 16384);
  if (preview_ && preview_->void_cells > 0) {
    ImGui::Checkbox("Cells without data become sea", &keep_voids_);
    tooltip(ui.theme, "Off: they are filled smoothly from their surroundings");
  }
  ImGui::PopItemWidth();
}

void ImportDialog::draw(const UiContext& ui) {
  EditorState& state = ui.state;
  const bool opening = state.dialogs.import_file && !ImGui::IsPopupOpen("Import a terrain");
  if (opening) look(state.import_path);
  take_preview();
  if (!begin_modal(ui, "Import a terrain", state.dialogs.import_file, 720)) return;
  ImGui::PushFont(ui.theme.bold);
  ImGui::TextUnformatted(file_.filename().string().c_str());
  ImGui::PopFont();
  ImGui::TextDisabled("%s", fitted_text(file_.parent_path().string(), ImGui::GetContentRegionAvail().x).c_str());
  ImGui::Dummy(ImVec2(0, ui.theme.px(4)));
  draw_picture(ui, ui.theme.px(300));
  ImGui::SameLine(0, ui.theme.px(16));
  ImGui::BeginChild("facts", ImVec2(0, ui.theme.px(300)));
  draw_facts(ui);
  ImGui::Separator();
  draw_fields(ui);
  ImGui::EndChild();
  if (!problem_.empty()) {
    wrapped(ui.theme.loss, problem_);
  } else if (needs_cell_size()) {
    ImGui::TextColored(ui.theme.attention, "The file does not say how large a cell is. Give the cell size in metres.");
  } else {
    hint(ui.theme, "The terrain replaces the landscape that is open; what is unsaved is asked about first.");
  }
  align_buttons(ui.theme, 2, button_width);
  bool close = ImGui::Button("Cancel", ImVec2(ui.theme.px(button_width), 0));
  ImGui::SameLine();
  ImGui::BeginDisabled(!preview_ || needs_cell_size());
  const bool accepted = primary_button(ui.theme, "Import", ui.theme.px(button_width));
  ImGui::EndDisabled();
  close = close || accepted;
  if (close) {
    state.dialogs.import_file = false;
    looking_.cancel();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (accepted) open_asking(state, file_.string(), chosen(true));
}

}  // namespace biotope
