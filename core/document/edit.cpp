#include "core/document/edit.hpp"

#include "core/document/edit_commands.hpp"

namespace biotope {
namespace {

std::string select_words(const SelectEdit& edit, const Document& document) {
  switch (edit.shape) {
    case SelectEdit::Shape::everything:
      return "Select everything";
    case SelectEdit::Shape::nothing:
      return "Select nothing";
    case SelectEdit::Shape::rectangle:
      return "Select a rectangle";
    case SelectEdit::Shape::lasso:
      return "Select by lasso";
    case SelectEdit::Shape::range:
      return "Select by value";
    case SelectEdit::Shape::inverse:
      return "Invert the selection";
    case SelectEdit::Shape::painted:
      return "Select the paint of " + layer_words(edit.range.map, document);
  }
  return "Select";
}

std::string lock_words(const LockEdit& edit) {
  switch (edit.how) {
    case LockEdit::How::replace:
      return "Lock only the selection";
    case LockEdit::How::add:
      return "Lock the selection";
    case LockEdit::How::subtract:
      return "Unlock the selection";
    case LockEdit::How::nothing:
      return "Unlock everything";
  }
  return "Lock";
}

std::vector<LayerId> layers_of(const std::vector<EditTarget>& targets) {
  std::vector<LayerId> layers;
  for (const EditTarget& target : targets) layers.push_back(target.layer);
  return layers;
}

struct NameOf {
  const Document& document;
  std::string operator()(const StrokeEdit& edit) const { return stroke_name(layers_of(edit.targets), document); }
  std::string operator()(const FillEdit& edit) const {
    // "Paint oak and 2 more" -> "Fill oak and 2 more"
    return "Fill" + stroke_name(layers_of(edit.targets), document).substr(std::string("Paint").size());
  }
  std::string operator()(const SelectEdit& edit) const { return select_words(edit, document); }
  std::string operator()(const ClearEdit& edit) const { return "Clear " + layer_words(edit.layer, document); }
  std::string operator()(const ImageEdit& edit) const { return "Lay an image over " + layer_words(edit.layer, document); }
  std::string operator()(const MixEdit& edit) const {
    return "Mix " + layer_words(edit.from, document) + " into " + layer_words(edit.into, document);
  }
  std::string operator()(const PartsEdit& edit) const { return edit.name; }
  std::string operator()(const LockEdit& edit) const { return lock_words(edit); }
};

struct CommandOf {
  const Document& document;
  const EditGrounds& grounds;
  CommandResult operator()(const StrokeEdit& edit) const { return stroke_command(document, edit, grounds); }
  CommandResult operator()(const FillEdit& edit) const { return fill_command(document, edit, grounds); }
  CommandResult operator()(const SelectEdit& edit) const { return select_command(document, edit, grounds); }
  CommandResult operator()(const ClearEdit& edit) const { return clear_command(document, edit); }
  CommandResult operator()(const ImageEdit& edit) const { return image_command(document, edit, grounds); }
  CommandResult operator()(const MixEdit& edit) const { return mix_command(document, edit, grounds); }
  CommandResult operator()(const PartsEdit& edit) const { return parts_command(document, edit); }
  CommandResult operator()(const LockEdit& edit) const { return lock_command(document, edit); }
};

}  // namespace

std::string edit_name(const Edit& edit, const Document& document) { return std::visit(NameOf{document}, edit); }

Result<std::unique_ptr<Command>> make_command(const Document& document, const Edit& edit, const EditGrounds& grounds) {
  return std::visit(CommandOf{document, grounds}, edit);
}

}  // namespace biotope
