// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <QMimeData>

#include <memory>

namespace codewheel {

// A device dragged out of the bus structure: its place for views of this program, a text for others. Not for
// another instance, which has other buses.
std::unique_ptr<QMimeData> draggedPlace(Place place, const QString &text);
std::optional<Place> placeDragged(const QMimeData &data); // nothing: something else

} // namespace codewheel
