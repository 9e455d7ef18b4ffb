// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/lane_layout.h"

#include "widgets/look/fonts.h"

#include <QFontMetricsF>

#include <algorithm>

namespace codewheel {
namespace {

constexpr double bitHeight = 14;   // of the curve of a bit
constexpr double leastHeight = 40; // of another lane, before the bits give way
constexpr double gap = 4;          // below the curves of a lane

double bitLane()
{
    return bitHeight + laneTitleHeight() + gap;
}

} // namespace

double laneTitleHeight()
{
    return QFontMetricsF(textFont(TextSize::small)).height();
}

std::vector<QRectF> layOutLanes(const std::vector<TrendLane> &lanes, const QRectF &plot)
{
    const auto bits = static_cast<double>(std::ranges::count_if(lanes, &TrendLane::isLogic));
    const auto others = static_cast<double>(lanes.size()) - bits;
    const double forBits = others == 0 ? std::min(bits * bitLane(), plot.height())
                                       : std::min(bits * bitLane(), plot.height() - others * leastHeight);
    const double ofBit =
        bits == 0 ? 0 : std::max(forBits, plot.height() * bits / (4 * (bits + others))) / bits;
    const double ofOther = others == 0 ? 0 : (plot.height() - ofBit * bits) / others;
    std::vector<QRectF> areas;
    double top = plot.top();
    for (const TrendLane &lane : lanes) {
        const double height = lane.isLogic() ? ofBit : ofOther;
        const double title = std::min(laneTitleHeight(), height / 2);
        areas.emplace_back(plot.left(), top + title, plot.width(),
                           std::max(height - title - std::min(gap, height / 5), 1.0));
        top += height;
    }
    return areas;
}

std::optional<std::size_t> laneAt(const std::vector<QRectF> &areas, double y)
{
    const auto found = std::ranges::find_if(areas, [y](const QRectF &area) {
        return y >= area.top() - laneTitleHeight() && y < area.bottom() + gap;
    });
    return found == areas.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - areas.begin()));
}

} // namespace codewheel
