// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay/replay_outline.h"

#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "replay/replay_bus.h"
#include "vocabulary/freshness_text.h"
#include "vocabulary/sentence.h"

#include <QFileInfo>
#include <QLocale>

namespace codewheel {

QString ReplayOutline::title() const
{
    return sentence(tr("Recording (%1)"), {QFileInfo(m_bus.playback()->file()).fileName()});
}

QString ReplayOutline::toolTip() const
{
    const Playback &playback = *m_bus.playback();
    return sentence(tr("%1\nShown: %2\nFrom %3 to %4\nNothing is sent."),
                    {playback.file(), recordedText(m_bus.dateTime(m_bus.now())),
                     recordedText(playback.dateTime(playback.span().from)),
                     recordedText(playback.dateTime(playback.span().to))});
}

StateWord ReplayOutline::state() const
{
    return {Role::inactive, tr("recording")};
}

std::vector<BusNode> ReplayOutline::nodes() const
{
    std::vector<BusNode> nodes;
    for (const Place place : m_bus.places()) {
        const EncoderSession *encoder = m_bus.encoder(place);
        const WordChannel *words = m_bus.channel(place);
        nodes.push_back(
            {.node = place.node,
             .parent = {},
             .name = participantName(encoder != nullptr ? &encoder->device() : nullptr),
             .profile = encoder != nullptr ? profileName(encoder->device().profile) : QStringLiteral("-"),
             .code = {},
             .words = words != nullptr
                          ? QStringLiteral("%1 / %2").arg(words->inWords()).arg(words->outWords())
                          : QString()});
    }
    return nodes;
}

NodeState ReplayOutline::state(std::size_t node) const
{
    const std::vector<Place> places = m_bus.places();
    if (node >= places.size())
        return {};
    const EncoderSession *encoder = m_bus.encoder(places[node]);
    return {.shown = shown(places[node]),
            .position = encoder != nullptr ? encoder->latest().position : std::nullopt,
            .isOld = true};
}

StateWord ReplayOutline::shown(Place place) const
{
    const EncoderSession *encoder = m_bus.encoder(place);
    const WordChannel *words = m_bus.channel(place);
    const bool isKnown =
        encoder != nullptr ? encoder->freshness().isOld() : words != nullptr && words->freshness().isOld();
    if (!isKnown)
        return {Role::inactive, tr("not recorded")};
    if (encoder != nullptr && encoder->latest().state == EncoderState::error)
        return {Role::fault, tr("error")};
    return {Role::inactive, tr("recorded")};
}

QString ReplayOutline::toolTip(std::size_t node, const QString &called) const
{
    const std::vector<Place> places = m_bus.places();
    if (node >= places.size())
        return {};
    const Place place = places[node];
    QString text = sentence(tr("%1  %2\nState: %3 (%4)"), {place.node.toString(), called, shown(place).word,
                                                           recordedText(m_bus.dateTime(m_bus.now()))});
    const EncoderSession *encoder = m_bus.encoder(place);
    if (encoder == nullptr)
        text += u'\n' + tr("This program has no description of this device: only its words are shown.");
    else if (encoder->latest().position)
        text += u'\n' + tr("Position %1").arg(QLocale().toString(qlonglong{*encoder->latest().position}));
    return text;
}

} // namespace codewheel
