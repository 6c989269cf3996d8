#pragma once

namespace biotope::icons {

// Font Awesome 4.7 (Debian fonts-font-awesome), private use area.
inline constexpr unsigned short first = 0xf000;
inline constexpr unsigned short last = 0xf2e0;

inline constexpr const char* play = "\xef\x81\x8b";
inline constexpr const char* pause = "\xef\x81\x8c";
inline constexpr const char* eye = "\xef\x81\xae";
inline constexpr const char* eye_closed = "\xef\x81\xb0";
inline constexpr const char* brush = "\xef\x87\xbc";
inline constexpr const char* eraser = "\xef\x84\xad";
inline constexpr const char* undo = "\xef\x83\xa2";
inline constexpr const char* redo = "\xef\x80\x9e";
inline constexpr const char* search = "\xef\x80\x82";
inline constexpr const char* open = "\xef\x81\xbc";
inline constexpr const char* save = "\xef\x83\x87";
inline constexpr const char* leaf = "\xef\x81\xac";
inline constexpr const char* paw = "\xef\x86\xb0";
inline constexpr const char* sun = "\xef\x86\x85";
inline constexpr const char* drop = "\xef\x81\x83";
inline constexpr const char* map = "\xef\x89\xb9";
inline constexpr const char* cube = "\xef\x86\xb2";
inline constexpr const char* columns = "\xef\x83\x9b";
inline constexpr const char* pointer = "\xef\x89\x85";
inline constexpr const char* smooth = "\xef\x83\x90";
inline constexpr const char* restore = "\xef\x87\x9a";
inline constexpr const char* warning = "\xef\x81\xb1";
inline constexpr const char* info = "\xef\x81\x9a";
inline constexpr const char* camera = "\xef\x80\xb0";
inline constexpr const char* settings = "\xef\x80\x93";
inline constexpr const char* question = "\xef\x81\x99";
inline constexpr const char* close = "\xef\x80\x8d";
inline constexpr const char* check = "\xef\x80\x8c";
inline constexpr const char* tree = "\xef\x86\xbb";
inline constexpr const char* road = "\xef\x80\x98";
inline constexpr const char* mountain = "\xef\x87\xbe";
inline constexpr const char* expand = "\xef\x81\xa5";
inline constexpr const char* file = "\xef\x80\x96";
inline constexpr const char* import_ = "\xef\x80\x99";
inline constexpr const char* refresh = "\xef\x80\xa1";
inline constexpr const char* thermometer = "\xef\x8b\x89";
inline constexpr const char* folder = "\xef\x81\xbb";
inline constexpr const char* up = "\xef\x81\xa2";
inline constexpr const char* clock = "\xef\x80\x97";
inline constexpr const char* keyboard = "\xef\x84\x9c";
inline constexpr const char* theme = "\xef\x81\x82";
inline constexpr const char* frame = "\xef\x82\xb2";
inline constexpr const char* image = "\xef\x80\xbe";
inline constexpr const char* calendar = "\xef\x81\xb3";
inline constexpr const char* lock = "\xef\x80\xa3";
inline constexpr const char* unlock = "\xef\x82\x9c";
inline constexpr const char* project = "\xef\x80\xba";
inline constexpr const char* set_value = "\xef\x86\x92";
inline constexpr const char* sharpen = "\xef\x88\x99";
inline constexpr const char* noise = "\xef\x81\xb4";
inline constexpr const char* clone = "\xef\x89\x8d";
inline constexpr const char* raise = "\xef\x81\xa2";
inline constexpr const char* lower = "\xef\x81\xa3";
inline constexpr const char* flatten = "\xef\x81\xa8";
inline constexpr const char* carve = "\xef\x81\xb8";
inline constexpr const char* gradient = "\xef\x81\x82";
inline constexpr const char* rectangle = "\xef\x82\x96";
inline constexpr const char* lasso = "\xef\x87\x8e";
inline constexpr const char* filter = "\xef\x82\xb0";
inline constexpr const char* invert = "\xef\x83\xac";
inline constexpr const char* copy = "\xef\x83\x85";
inline constexpr const char* paste = "\xef\x83\xaa";
inline constexpr const char* more = "\xef\x85\x82";
inline constexpr const char* star = "\xef\x80\x85";
inline constexpr const char* trash = "\xef\x87\xb8";
inline constexpr const char* bucket = "\xef\x81\x83";
inline constexpr const char* plus = "\xef\x81\xa7";
inline constexpr const char* stamp = "\xef\x87\xbc";
inline constexpr const char* layers = "\xef\x89\x8d";
inline constexpr const char* fire = "\xef\x81\xad";
inline constexpr const char* ban = "\xef\x81\x9e";

}  // namespace biotope::icons
