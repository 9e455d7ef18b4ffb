// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"

#include <QJsonArray>
#include <QString>

namespace codewheel {

class Catalog;

// Where each device of a ring is in the registers that are served, for those who write a program for them.
QString registerTable(const RingStructure &ring, const Catalog &catalog);
QJsonArray registerJson(const RingStructure &ring);

} // namespace codewheel
