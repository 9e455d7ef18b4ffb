// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"

#include <QMimeData>

namespace codewheel {

// A device that is dragged out of the bus structure; it can be dropped on what shows a device.
inline constexpr const char *placeMimeType = "application/x-codewheel-place";

inline QMimeData *dragged(Place place)
{
    auto *data = new QMimeData;
    data->setData(QLatin1String(placeMimeType), place.key().toLatin1());
    return data;
}

// Nothing: something else is dragged.
inline std::optional<Place> draggedPlace(const QMimeData &data)
{
    return Place::parse(QString::fromLatin1(data.data(QLatin1String(placeMimeType))));
}

} // namespace codewheel
