// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/line_branch.h"

#include "catalog/device_description.h"
#include "encoder/sentence.h"
#include "esc/esc_bits.h"
#include "line/line_session.h"
#include "widgets/models/age_text.h"
#include "widgets/project/project_document.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

// The warnings that somebody has to do something about; the others tell how the shaft turns and where it is.
bool isTrouble(std::uint16_t warnings)
{
    return std::ranges::any_of(esc::bitsOf(esc::Command::warnings), [warnings](const esc::BitRow &row) {
        const bool isSet = (warnings >> row.bit & 1) != 0;
        return isSet && (row.id == esc::BitId::positionWarning || row.id == esc::BitId::batteryLimit ||
                         row.id == esc::BitId::lightControl || row.id == esc::BitId::frequencyExceeded);
    });
}

QString bitLines(const Reading &reading)
{
    QStringList lines;
    if (reading.alarms)
        lines << esc::bitTexts(esc::Command::alarms, *reading.alarms);
    if (reading.warnings)
        lines << esc::bitTexts(esc::Command::warnings, *reading.warnings);
    return lines.join(u'\n');
}

} // namespace

QString calledText(const QString &station, const QString &name)
{
    return station.isEmpty() ? name : LineBranch::tr("%1: %2", "station, device").arg(station, name);
}

void LineBranch::setLine(LineSession *line)
{
    m_line = line;
}

LineSession *LineBranch::line() const
{
    return m_line;
}

QString LineBranch::name() const
{
    return m_line ? tr("Serial line (%1)").arg(m_line->linkName()) : tr("Serial line");
}

StateWord LineBranch::state() const
{
    if (!m_line || !m_line->isOpen())
        return {Role::inactive, tr("not connected")};
    const LineSnapshot &line = m_line->latest();
    if (!line.connected)
        return {Role::fault, tr("port is gone")};
    if (line.scanning)
        return {Role::attention, tr("searching")};
    if (!line.polling)
        return {Role::inactive, tr("stopped")};
    return {Role::running, tr("open")};
}

std::vector<LineBranch::Row> LineBranch::rows(const ProjectDocument *project) const
{
    std::vector<Row> rows;
    if (!m_line)
        return rows;
    for (const Place number : m_line->places()) {
        const EncoderSession &encoder = *m_line->encoder(number);
        rows.push_back({.number = number,
                        .name = encoder.device().fullName(),
                        .station = project ? project->device(number).station : QString(),
                        .shown = stateOf(number),
                        .position = encoder.latest().position,
                        .isOld = encoder.freshness().isOld()});
    }
    return rows;
}

StateWord LineBranch::stateOf(Place number) const
{
    const LineSnapshot &line = m_line->latest();
    const Reading &reading = m_line->encoder(number)->latest();
    if (!m_line->isOpen() || !line.connected)
        return {Role::inactive, tr("not reachable")};
    if (m_line->encoder(number)->runningJob())
        return {Role::attention, tr("job running")};
    if (reading.state == EncoderState::silent)
        return {Role::fault, tr("silent")};
    if (!line.polling)
        return {Role::inactive, tr("stopped")};
    if (reading.state == EncoderState::notSeen)
        return {Role::inactive, tr("not seen yet")};
    if (reading.alarms.value_or(0) != 0)
        return {Role::fault, tr("alarm")};
    if (reading.suspect)
        return {Role::attention, tr("suspect position")};
    if (isTrouble(reading.warnings.value_or(0)))
        return {Role::attention, tr("warning")};
    return {Role::running, tr("ok")};
}

QString LineBranch::toolTip() const
{
    if (!m_line)
        return {};
    return sentence(tr("%1, %2 Bd\nState: %3\nAnswers: %4, time-outs: %5"),
                    {name(), QLocale().toString(m_line->settings().baudRate), state().word,
                     QLocale().toString(qulonglong{m_line->latest().figures.answers}),
                     QLocale().toString(qulonglong{m_line->latest().figures.timeOuts})});
}

QString LineBranch::toolTip(const Row &row) const
{
    QString text = sentence(tr("%1  %2\nAddress %3\nState: %4"),
                            {row.number.toString(), calledText(row.station, row.name),
                             LineAddress::of(row.number.node).shown(), row.shown.word});
    if (row.position)
        text += u'\n' + tr("Position %1").arg(QLocale().toString(qlonglong{*row.position}));
    const EncoderSession *encoder = m_line ? m_line->encoder(row.number) : nullptr;
    if (!encoder)
        return text;
    for (const QString &more : {ageSentence(*encoder), bitLines(encoder->latest())})
        if (!more.isEmpty())
            text += u'\n' + more;
    return text;
}

} // namespace codewheel
