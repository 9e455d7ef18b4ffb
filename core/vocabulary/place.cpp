// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/bus_names.h"

#include <algorithm>

namespace codewheel {
namespace {

struct BusNames
{
    std::map<BusId, QString> ofPlaces;
    std::map<BusId, QString> ofBuses;
};

BusNames &busNames()
{
    static BusNames names;
    return names;
}

} // namespace

QString NodeId::toString() const
{
    return QString::fromLatin1(text().data(), static_cast<qsizetype>(text().size()));
}

// Number by number, from where they differ. Without leading zeros, the number with more digits is the
// greater.
std::strong_ordering operator<=>(const NodeId &one, const NodeId &other)
{
    const auto [left, right] = std::ranges::mismatch(one.m_text, other.m_text);
    if (left == one.m_text.end())
        return std::strong_ordering::equal;
    const auto ends = [](char c) { return c == '.' || c == ':' || c == '\0'; };
    const auto digitsLeft = std::find_if(left, one.m_text.end(), ends) - left;
    const auto digitsRight = std::find_if(right, other.m_text.end(), ends) - right;
    return digitsLeft == digitsRight ? *left <=> *right : digitsLeft <=> digitsRight;
}

QString Place::key() const
{
    const QString text = toString();
    return parse(text) == *this ? text : QStringLiteral("%1/%2").arg(bus.number).arg(text);
}

std::optional<Place> Place::parse(QStringView text)
{
    if (const qsizetype slash = text.indexOf(u'/'); slash >= 0) {
        bool isNumber = false;
        const int number = text.first(slash).toInt(&isNumber);
        const NodeId node(text.sliced(slash + 1).toLatin1().toStdString());
        return isNumber && number > 0 && !node.isEmpty() ? std::optional(Place{{number}, node})
                                                         : std::nullopt;
    }
    for (const PlaceFormat &format : placeFormats())
        if (const auto node = format.node(text))
            return Place{format.bus, *node};
    return std::nullopt;
}

std::optional<Place> Place::ofKey(QStringView key)
{
    if (!key.endsWith(u'/'))
        return parse(key);
    const int bus = key.chopped(1).toInt();
    return bus > 0 ? std::optional(Place{{bus}, {}}) : std::nullopt;
}

QString Place::shown() const
{
    if (!isEmpty())
        return shownPlace(*this, busNames().ofPlaces);
    const auto name = busNames().ofBuses.find(bus);
    return name == busNames().ofBuses.end() ? QString() : name->second;
}

void setBusNames(std::map<BusId, QString> ofPlaces, std::map<BusId, QString> ofBuses)
{
    busNames() = {std::move(ofPlaces), std::move(ofBuses)};
}

QString nameAmongOthers(BusId bus)
{
    const auto name = busNames().ofPlaces.find(bus);
    return name == busNames().ofPlaces.end() ? QString() : name->second;
}

} // namespace codewheel
