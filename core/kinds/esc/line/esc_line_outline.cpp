// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_outline.h"

#include "catalog/device_description.h"
#include "kinds/esc/line/esc_line_checks.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/protocol/esc_bits.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_profile.h"
#include "vocabulary/sentence.h"

#include <QLocale>

namespace codewheel {
namespace {

// The translation context of these texts.
struct LineText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineOutline)
};

QStringList bitLines(const Reading &reading)
{
    QStringList lines;
    if (reading.alarms)
        lines << esc::bitTexts(esc::Command::alarms, *reading.alarms);
    if (reading.warnings)
        lines << esc::bitTexts(esc::Command::warnings, *reading.warnings);
    return lines;
}

QString titleOf(const QString &port)
{
    return port.isEmpty() ? LineText::tr("Serial line") : LineText::tr("Serial line (%1)").arg(port);
}

QString toolTipOf(NodeId node, const QString &called, const QString &state)
{
    return sentence(LineText::tr("%1  %2\nAddress %3\nState: %4"),
                    {node.toString(), called, EscLineAddress::of(node).shown(), state});
}

} // namespace

const AskedOutlineWords lineOutlineWords{
    .title = titleOf,
    .profile = profile::esc,
    .address = [](NodeId node) { return EscLineAddress::of(node).shown(); },
    .toolTip = toolTipOf,
};

EscLineOutline::EscLineOutline(const EscLineSession &line)
    : AskedOutline(lineOutlineWords, line)
    , m_line(line)
{}

QString EscLineOutline::toolTip() const
{
    return sentence(tr("%1, %2 Bd\nState: %3\nAnswers: %4, time-outs: %5"),
                    {title(), QString::number(m_line.settings().baudRate), state().word,
                     QLocale().toString(qulonglong{m_line.latest().figures.answers}),
                     QLocale().toString(qulonglong{m_line.latest().figures.timeOuts})});
}

QString EscLineOutline::alarmStop() const
{
    return tr("jobs end, and nothing that waits is sent; positions are still read");
}

StateWord EscLineOutline::state() const
{
    if (m_line.state() == BusState::opening)
        return connecting();
    if (!m_line.isOpen())
        return {Role::inactive, tr("offline")};
    const EscLineSnapshot &line = m_line.latest();
    if (!line.connected)
        return {Role::fault, tr("no port")};
    if (line.scanning)
        return {Role::attention, tr("searching")};
    if (!line.running)
        return {Role::inactive, tr("stopped")};
    return {Role::running, tr("open")};
}

std::vector<Fault> EscLineOutline::faults() const
{
    return lineFaults(m_line);
}

StateWord EscLineOutline::shown(Place place) const
{
    const EscLineSnapshot &line = m_line.latest();
    const EncoderSession &encoder = *m_line.encoder(place);
    const Reading &reading = encoder.latest();
    if (!m_line.isOpen() || !line.connected)
        return {Role::inactive, tr("cut off")};
    if (encoder.runningJob())
        return {Role::attention, tr("job", "it is running")};
    if (reading.state == EncoderState::silent)
        return {Role::fault, tr("silent")};
    if (!line.running)
        return {Role::inactive, tr("stopped")};
    if (reading.state == EncoderState::notSeen)
        return {Role::inactive, tr("not seen")};
    if (reading.alarms.value_or(0) != 0)
        return {Role::fault, tr("alarm")};
    if (reading.suspect)
        return {Role::attention, tr("suspect", "position")};
    if (!troubles(reading).isEmpty())
        return {Role::attention, tr("warning")};
    return {Role::running, tr("ok")};
}

QString EscLineOutline::toolTip(std::size_t node, const QString &called) const
{
    const std::vector<Place> places = m_line.places();
    if (node >= places.size())
        return {};
    const Reading &reading = m_line.encoder(places[node])->latest();
    QStringList lines{AskedOutline::toolTip(node, called)};
    if (reading.position)
        lines << tr("Position %1").arg(QLocale().toString(qlonglong{*reading.position}));
    return (lines + bitLines(reading)).join(u'\n');
}

} // namespace codewheel
