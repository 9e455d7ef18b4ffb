// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/device_file.h"

#include <QByteArray>
#include <QDateTime>

namespace codewheel::canopen {

// What the head of a DCF says of the file itself.
struct DcfHead
{
    QString fileName;
    QString ofFile{}; // the EDS it is made from; empty: none
    QDateTime now;
};

// The DCF of a device as `file` describes it, with its node, its rate and the values of its objects. Left out
// are values of objects that can only be written, those whose writing does more than giving a value (store,
// restore, preset), and identifiers without the number of their node.
QByteArray dcfOf(const DeviceFile &file, const DcfHead &head);

} // namespace codewheel::canopen
