// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/trend/trend_scene.h"

#include <QRectF>

namespace codewheel {

// Where the curves of each lane are in a plot, from top to bottom, each below the names of its curves: those
// of single bits are low, the others share the rest.
std::vector<QRectF> layOutLanes(const std::vector<TrendLane> &lanes, const QRectF &plot);
double laneTitleHeight();
// The lane at this height, its names included; nothing between lanes.
std::optional<std::size_t> laneAt(const std::vector<QRectF> &areas, double y);

} // namespace codewheel
