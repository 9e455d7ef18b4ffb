// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cams/cam_fields.h"
#include "kinds/canopen/driver/node_driver.h"

namespace codewheel::canopen {

// A step of a job as carried out by the driver of a node. Step::line is "6001:0" for a read, "6001:0=5000"
// for a write, "6000:0 b0=1 b2=0" for bits that are changed, "NMT 129" for a command.
struct NodeStep : Step
{
    enum class Task : std::uint8_t {
        read,     // the values are part of the outcome
        refresh,  // only what is known is brought up to date; it may fail
        bits,     // before some of its bits are written: the others stay as they are
        write,    // sent once
        readBack, // what was written must be found
        positionBefore,
        positionAfter,
        preset, // sent once
        store,
        restore, // the factory values
        vendor,  // an object of the maker is written to that make only
        readCam,
        writeCam,
        nmt,
        bootUp,  // after a reset
        started, // the node runs again
    };

    Task task = Task::read;
    SdoObject object{};
    std::uint32_t number = 0; // preset, signatures, values of cams
    ParameterValues values{}; // write, readBack
    CamField cam{};
    NmtCommand command = NmtCommand::start;
};
using NodeSteps = std::vector<NodeStep>;

} // namespace codewheel::canopen
