#include "app/pen.hpp"

#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace biotope {

float axis_share(double value, double least, double most) {
  if (!(most > least)) return 1;
  return float(std::clamp((value - least) / (most - least), 0.0, 1.0));
}

/// A connection of its own, so that no event is taken from the window.
struct Pen::Connection {
  struct Axis {
    int number = 0;
    double least = 0;
    double most = 1;
  };

  Display* display = nullptr;
  int extension = 0;
  Atom pressure_label = 0;
  /// The axis that tells the pressure, by device; none where there is none.
  std::map<int, std::optional<Axis>> axes;
  float pressure = 1;

  ~Connection() {
    if (display != nullptr) XCloseDisplay(display);
  }
  bool open();
  void read_events();
  void read_motion(const XIRawEvent& motion);
  const std::optional<Axis>& axis_of(int device);
};

bool Pen::Connection::open() {
  display = XOpenDisplay(nullptr);
  if (display == nullptr) return false;
  int event = 0;
  int error = 0;
  int major = 2;
  int minor = 2;
  if (!XQueryExtension(display, "XInputExtension", &extension, &event, &error)) return false;
  if (XIQueryVersion(display, &major, &minor) != Success) return false;
  pressure_label = XInternAtom(display, "Abs Pressure", False);
  std::array<unsigned char, XIMaskLen(XI_LASTEVENT)> bits{};
  XISetMask(bits.data(), XI_RawMotion);
  XISetMask(bits.data(), XI_HierarchyChanged);
  XIEventMask mask{XIAllDevices, int(bits.size()), bits.data()};
  XISelectEvents(display, DefaultRootWindow(display), &mask, 1);
  XFlush(display);
  return true;
}

const std::optional<Pen::Connection::Axis>& Pen::Connection::axis_of(int device) {
  const auto known = axes.find(device);
  if (known != axes.end()) return known->second;
  std::optional<Axis> found;
  int count = 0;
  XIDeviceInfo* info = XIQueryDevice(display, device, &count);
  for (int i = 0; info != nullptr && count > 0 && i < info->num_classes; ++i) {
    if (info->classes[i]->type != XIValuatorClass) continue;
    const auto* valuator = reinterpret_cast<const XIValuatorClassInfo*>(info->classes[i]);
    if (valuator->label == pressure_label) found = Axis{valuator->number, valuator->min, valuator->max};
  }
  if (info != nullptr) XIFreeDeviceInfo(info);
  return axes.emplace(device, found).first->second;
}

void Pen::Connection::read_motion(const XIRawEvent& motion) {
  const std::optional<Axis>& axis = axis_of(motion.sourceid);
  if (!axis) {
    pressure = 1;
    return;
  }
  // Values come only for the axes whose bit is set, in their order. One that did not change is not sent.
  const double* value = motion.valuators.values;
  for (int i = 0; i < motion.valuators.mask_len * 8; ++i) {
    if (!XIMaskIsSet(motion.valuators.mask, i)) continue;
    if (i == axis->number) pressure = axis_share(*value, axis->least, axis->most);
    ++value;
  }
}

void Pen::Connection::read_events() {
  while (XPending(display) > 0) {
    XEvent event;
    XNextEvent(display, &event);
    if (event.xcookie.type != GenericEvent || event.xcookie.extension != extension) continue;
    if (!XGetEventData(display, &event.xcookie)) continue;
    if (event.xcookie.evtype == XI_RawMotion) read_motion(*static_cast<const XIRawEvent*>(event.xcookie.data));
    if (event.xcookie.evtype == XI_HierarchyChanged) axes.clear();
    XFreeEventData(display, &event.xcookie);
  }
}

Pen::Pen() {
  auto connection = std::make_unique<Connection>();
  if (connection->open()) connection_ = std::move(connection);
}

Pen::~Pen() = default;

float Pen::pressure() {
  if (!connection_) return 1;
  connection_->read_events();
  return connection_->pressure;
}

}  // namespace biotope
