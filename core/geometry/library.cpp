// SPDX-License-Identifier: MIT
#include "core/geometry/library.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace soffit::geometry {

Library rayLibrary() {
  // Only a device tells; one without threads of its own is made in no time.
  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  if (device == nullptr) return {"Embree", RTC_VERSION_STRING, "Apache-2.0"};
  const auto part = [device](RTCDeviceProperty property) {
    return std::to_string(rtcGetDeviceProperty(device, property));
  };
  const std::string version = part(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + '.' +
                              part(RTC_DEVICE_PROPERTY_VERSION_MINOR) + '.' +
                              part(RTC_DEVICE_PROPERTY_VERSION_PATCH);
  rtcReleaseDevice(device);
  return {"Embree", version, "Apache-2.0"};
}

}  // namespace soffit::geometry
