// The JSON files by which the EGL and Vulkan loaders find a driver.
#pragma once

#include <filesystem>
#include <string>

namespace etalon {

// While it lives, the loaders find the libraries that the environment names (driver_files.h), and
// no others; does nothing where it names none. A driver's own JSON files name the place where it
// expects to be installed, which under a prefix is wrong: these are written to a folder of their
// own, which goes with this object.
class DriverManifests {
  public:
    DriverManifests();
    ~DriverManifests();
    DriverManifests(const DriverManifests&) = delete;
    DriverManifests& operator=(const DriverManifests&) = delete;

  private:
    // Writes one manifest; returns its path.
    std::string Write(const std::string& library);

    std::filesystem::path folder_;
    int written_ = 0;
};

}  // namespace etalon
