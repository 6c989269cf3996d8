#include "core/document/edit_commands.hpp"
#include "core/document/selection.hpp"

namespace biotope {
namespace {

using MaskPointer = std::shared_ptr<const SelectionMask>;

SelectionMask selected_cells(const Document& document) {
  if (document.selection) return *document.selection;
  return inverted(SelectionMask(document.terrain->height.width(), document.terrain->height.height()));
}

/// What is not locked is a selection like any other, and null where everything is free.
MaskPointer free_area(const Document& document, const LockEdit& edit) {
  const MaskPointer free =
      document.locked_area ? std::make_shared<const SelectionMask>(inverted(*document.locked_area)) : nullptr;
  switch (edit.how) {
    case LockEdit::How::replace:
      return combined(nullptr, inverted(selected_cells(document)), SelectionMode::replace);
    case LockEdit::How::add:
      return combined(free, selected_cells(document), SelectionMode::subtract);
    case LockEdit::How::subtract:
      return combined(free, selected_cells(document), SelectionMode::add);
    case LockEdit::How::nothing:
      break;
  }
  return nullptr;
}

}  // namespace

CommandResult lock_command(const Document& document, const LockEdit& edit) {
  if (!document.terrain) return fail("There is no terrain to lock. Open a landscape first.");
  if (document.selection) {
    if (const Status size = check_size(document, document.selection->rect(), "The selection"); !size)
      return tl::unexpected(size.error());
  }
  if (document.locked_area) {
    if (const Status size = check_size(document, document.locked_area->rect(), "The locked area"); !size) {
      return tl::unexpected(size.error());
    }
  }
  const MaskPointer free = free_area(document, edit);
  const MaskPointer locked = free ? std::make_shared<const SelectionMask>(inverted(*free)) : nullptr;
  const MaskPointer& before = document.locked_area;
  if (before == locked || (before && locked && *before == *locked)) return std::unique_ptr<Command>{};
  Document after = document;
  after.locked_area = locked;
  return std::make_unique<DocumentCommand>(edit_name(edit, document), document, std::move(after));
}

}  // namespace biotope
