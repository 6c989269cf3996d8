#include <catch2/catch.hpp>
#include <set>

#include "ui/commands.hpp"

using namespace biotope;

TEST_CASE("a shortcut reads back as it is written") {
  for (const char* text : {"Ctrl+Shift+S", "F5", "[", "Shift+]", "Tab", "Alt+Left", "Ctrl+,", "Space", "1", "Esc"}) {
    const auto shortcut = parse_shortcut(text);
    REQUIRE(shortcut);
    CHECK(to_text(*shortcut) == text);
  }
  CHECK(parse_shortcut("ctrl+z") == parse_shortcut("Ctrl+Z"));
  CHECK(parse_shortcut("")->key == 0);
}

TEST_CASE("what is no key is refused") {
  for (const char* text : {"Ctrl+", "Hyper+S", "Ctrl+Foo", "F0", "F26", "F1x", "++"}) CHECK_FALSE(parse_shortcut(text));
}

TEST_CASE("every command has a name, a sentence, an action and an id of its own") {
  std::set<std::string> ids;
  for (const EditorCommand& command : editor_commands()) {
    CAPTURE(command.id);
    CHECK(ids.insert(command.id).second);
    CHECK_FALSE(command.name.empty());
    CHECK_FALSE(command.tooltip.empty());
    CHECK(command.run);
    CHECK(parse_shortcut(command.keys));
  }
}

TEST_CASE("no two commands share a shortcut") {
  std::set<std::string> keys;
  for (const EditorCommand& command : editor_commands()) {
    if (command.keys.empty()) continue;
    CAPTURE(command.id, command.keys);
    CHECK(keys.insert(to_text(*parse_shortcut(command.keys))).second);
  }
}

TEST_CASE("a key press finds its command, with its modifiers and no others") {
  const CommandTable table(editor_commands());
  CHECK(table.of_keys(*parse_shortcut("Ctrl+S"))->id == "file.save");
  CHECK(table.of_keys(*parse_shortcut("S"))->id == "tool.smooth");
  CHECK(table.of_keys(*parse_shortcut("Ctrl+Shift+Z"))->id == "edit.redo");
  CHECK(table.of_keys(*parse_shortcut("Ctrl+Alt+S")) == nullptr);
  CHECK(table.of_keys({}) == nullptr);
}

TEST_CASE("a person's own shortcuts replace the built-in ones, and wrong ones are told") {
  const CommandTable table(editor_commands(), {{"tool.brush", "P"}, {"nonsense", "X"}, {"tool.erase", "Ctrl+Foo"}});
  CHECK(table.keys("tool.brush") == "P");
  CHECK(table.of_keys(*parse_shortcut("B")) == nullptr);
  CHECK(table.keys("tool.erase") == "E");
  CHECK(table.problems().size() == 2);
}

TEST_CASE("the palette puts whole beginnings before letters apart") {
  const CommandTable table(editor_commands());
  REQUIRE_FALSE(table.search("save").empty());
  CHECK(table.search("save").front()->id == "file.save");
  CHECK(table.search("undo").front()->id == "edit.undo");
  CHECK(table.search("fllscrn").front()->id == "window.full_screen");
  CHECK(table.search("xyzzyq").empty());
  CHECK(table.search("").size() == table.all().size());
}

TEST_CASE("a command that is not enabled does not run") {
  EditorState state;
  const CommandTable table(editor_commands());
  const EditorCommand& save = *table.find("file.save_as");
  CHECK_FALSE(enabled(save, state));
  run(save, state);
  CHECK_FALSE(state.dialogs.save_file);
  run(*table.find("file.samples"), state);
  CHECK(state.dialogs.samples);
}

TEST_CASE("tools and tabs are switches that say which one is on") {
  EditorState state;
  const CommandTable table(editor_commands());
  run(*table.find("tool.erase"), state);
  CHECK(checked(*table.find("tool.erase"), state));
  CHECK_FALSE(checked(*table.find("tool.brush"), state));
  run(*table.find("tab.2"), state);
  CHECK(state.view.tab == Tab::climate);
}

TEST_CASE("the brush keys change size and strength within limits") {
  EditorState state;
  const CommandTable table(editor_commands());
  for (int i = 0; i < 200; ++i) run(*table.find("brush.larger"), state);
  CHECK(state.brush.radius == 1000);
  for (int i = 0; i < 200; ++i) run(*table.find("brush.weaker"), state);
  CHECK(state.brush.strength == Approx(0.01));
}
