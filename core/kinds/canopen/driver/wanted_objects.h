// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/canopen/eds/file_value.h"
#include "kinds/canopen/protocol/sdo.h"
#include "vocabulary/cam_program.h"
#include "vocabulary/parameter.h"

#include <vector>

namespace codewheel::canopen {

// What an object is to have, so that its node has the values that are wanted of the encoder.
struct WantedObject
{
    SdoObject object{};
    FileValue value{};      // a number or a text
    std::uint32_t bits = 0; // those that are wanted, the others may be anything; 0: the whole object

    bool isMetBy(const FileValue &now) const;

    friend bool operator==(const WantedObject &, const WantedObject &) = default;
};

// By index and subindex. Parameters without an object are left out.
std::vector<WantedObject> wantedObjects(const DeviceDescription &device, const ParameterValues &values,
                                        const std::vector<CamProgram> &cams);

} // namespace codewheel::canopen
