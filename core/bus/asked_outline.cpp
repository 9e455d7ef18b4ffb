// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/asked_outline.h"

#include "bus/asked_bus.h"

namespace codewheel {

BusNode AskedOutlineWords::node(NodeId its, const QString &name) const
{
    return {.node = its,
            .parent = {},
            .name = name,
            .profile = profileName(profile),
            .code = address(its),
            .words = {}};
}

QString AskedOutline::title() const
{
    return m_words.title(m_bus.linkName());
}

std::optional<QString> AskedOutline::behindName() const
{
    return m_bus.linkName();
}

std::vector<BusNode> AskedOutline::nodes() const
{
    std::vector<BusNode> nodes;
    for (const Place place : m_bus.places())
        nodes.push_back(m_words.node(place.node, m_bus.encoder(place)->device().fullName()));
    return nodes;
}

NodeState AskedOutline::state(std::size_t node) const
{
    const std::vector<Place> places = m_bus.places();
    if (node >= places.size()) // it has been removed
        return {};
    const EncoderSession &encoder = *m_bus.encoder(places[node]);
    return {.shown = shown(places[node]),
            .position = encoder.latest().position,
            .isOld = encoder.freshness().isOld(),
            .isCutOff = m_bus.state() == BusState::lost};
}

QString AskedOutline::toolTip(std::size_t node, const QString &called) const
{
    const std::vector<Place> places = m_bus.places();
    return node < places.size() ? m_words.toolTip(places[node].node, called, shown(places[node]).word)
                                : QString();
}

std::vector<BusNode> PlannedAskedOutline::nodes() const
{
    std::vector<BusNode> nodes;
    for (const Encoder &encoder : m_encoders)
        nodes.push_back(m_words.node(encoder.node, encoder.name));
    return nodes;
}

QString PlannedAskedOutline::toolTip(std::size_t node, const QString &called) const
{
    return node < m_encoders.size() ? m_words.toolTip(m_encoders[node].node, called, planned().word)
                                    : QString();
}

} // namespace codewheel
