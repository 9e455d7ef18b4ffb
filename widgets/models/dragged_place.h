// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"

#include <QMimeData>

#include <memory>

namespace codewheel {

// A device that is dragged out of the bus structure: its place for views of the program, a text for others.
// The same program alone, since another has other buses.
std::unique_ptr<QMimeData> draggedPlace(Place place, const QString &text);
std::optional<Place> placeDragged(const QMimeData &data); // nothing: something else is

} // namespace codewheel
