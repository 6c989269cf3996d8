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
  /// The axis that tells the pressure, of the devices that have one.
  std::map<int, Axis> axes;
  float pressure = 1;

  ~Connection() {
    if (display != nullptr) XCloseDisplay(display);
  }
  bool open();
  void read_events();
  void read_motion(const XIRawEvent& motion);
  void read_devices();
  std::optional<Axis> pressure_axis(const XIDeviceInfo& device) const;
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
  read_devices();
  return true;
}

std::optional<Pen::Connection::Axis> Pen::Connection::pressure_axis(const XIDeviceInfo& device) const {
  for (int i = 0; i < device.num_classes; ++i) {
    if (device.classes[i]->type != XIValuatorClass) continue;
    const auto* valuator = reinterpret_cast<const XIValuatorClassInfo*>(device.classes[i]);
    if (valuator->label == pressure_label) return Axis{valuator->number, valuator->min, valuator->max};
  }
  return std::nullopt;
}

/// All devices at once: to ask about one that has just gone is an error that ends the program.
void Pen::Connection::read_devices() {
  axes.clear();
  int count = 0;
  XIDeviceInfo* devices = XIQueryDevice(display, XIAllDevices, &count);
  for (int i = 0; devices != nullptr && i < count; ++i) {
    if (const auto axis = pressure_axis(devices[i])) axes[devices[i].deviceid] = *axis;
  }
  if (devices != nullptr) XIFreeDeviceInfo(devices);
}

void Pen::Connection::read_motion(const XIRawEvent& motion) {
  const auto axis = axes.find(motion.sourceid);
  if (axis == axes.end()) {
    pressure = 1;
    return;
  }
  // Values come only for the axes whose bit is set, in their order. One that did not change is not sent.
  const double* value = motion.valuators.values;
  for (int i = 0; i < motion.valuators.mask_len * 8; ++i) {
    if (!XIMaskIsSet(motion.valuators.mask, i)) continue;
    if (i == axis->second.number) pressure = axis_share(*value, axis->second.least, axis->second.most);
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
    if (event.xcookie.evtype == XI_HierarchyChanged) read_devices();
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
