// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project.h"

#include <algorithm>

namespace codewheel {

const ProjectDevice *findDevice(const Project &project, Place number)
{
    if (number.isOnLine() && !project.line)
        return nullptr;
    const std::vector<ProjectDevice> &devices = number.isOnLine() ? project.line->encoders : project.devices;
    const auto found = std::ranges::find_if(
        devices, [number](const ProjectDevice &device) { return device.place() == number; });
    return found == devices.end() ? nullptr : &*found;
}

ProjectDevice *findDevice(Project &project, Place number)
{
    return const_cast<ProjectDevice *>(findDevice(std::as_const(project), number));
}

} // namespace codewheel
