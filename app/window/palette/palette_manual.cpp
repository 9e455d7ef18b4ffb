// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/palette_manual.h"

#include <algorithm>
#include <utility>

namespace codewheel {

PaletteManual::PaletteManual(std::function<void(const QString &)> show)
    : m_show(std::move(show))
{}

void PaletteManual::begin()
{
    m_next = 0;
    if (m_headings.empty())
        m_headings = manualHeadings();
}

// What a page is about, in the language of the window and in English.
QString PaletteManual::titleOf(const QString &page)
{
    static constexpr std::pair<const char *, const char *> titles[] = {
        {"README.md", QT_TR_NOOP("The window")},
        {"cams.md", QT_TR_NOOP("Cams")},
        {"device.md", QT_TR_NOOP("Device panel")},
        {"dial.md", QT_TR_NOOP("Dial")},
        {"doctor.md", QT_TR_NOOP("Port doctor, rights, no port")},
        {"eeprom.md", QT_TR_NOOP("EEPROM writes")},
        {"find.md", QT_TR_NOOP("Who is there?, find encoders")},
        {"gateway.md", QT_TR_NOOP("Gateway, registers")},
        {"help.md", QT_TR_NOOP("Help, keys, support")},
        {"manufacturer-functions.md", QT_TR_NOOP("Modes, preset, reset, factory settings")},
        {"master.md", QT_TR_NOOP("Master, faults of the ring")},
        {"messages.md", QT_TR_NOOP("Messages")},
        {"monitors.md", QT_TR_NOOP("Monitors, words, bits")},
        {"palette.md", QT_TR_NOOP("Command palette, search")},
        {"parameters.md", QT_TR_NOOP("Parameters, read, write")},
        {"project.md", QT_TR_NOOP("Project, bus structure, offline, compare")},
        {"recording.md", QT_TR_NOOP("Recording")},
        {"replay.md", QT_TR_NOOP("Replay of a recording")},
        {"report.md", QT_TR_NOOP("Commissioning report, print")},
        {"sequence-and-trace.md", QT_TR_NOOP("Sequence, handshake trace")},
        {"serial-line.md", QT_TR_NOOP("Serial line, port, search for encoders")},
        {"serving.md", QT_TR_NOOP("Offer a training bus")},
        {"settings.md", QT_TR_NOOP("Settings, language, appearance")},
        {"simulated-line.md", QT_TR_NOOP("Simulated line, disturbances")},
        {"start.md", QT_TR_NOOP("Start page")},
        {"training.md", QT_TR_NOOP("Training, turn shafts, cause faults")},
        {"transfer.md", QT_TR_NOOP("Transfer, replace encoder")},
        {"trend.md", QT_TR_NOOP("Trend, curves")},
        {"why.md", QT_TR_NOOP("Why is there no data?, no answer, silent")},
        {"wizard.md", QT_TR_NOOP("Parameter wizard")},
        {"command-line.md", QT_TR_NOOP("Command line")},
    };
    const auto found =
        std::ranges::find_if(titles, [&](const auto &title) { return page == QLatin1String(title.first); });
    return found == std::end(titles) ? QString()
                                     : QString(tr(found->second) + u' ' + QLatin1String(found->second));
}

std::vector<PaletteEntry> PaletteManual::next()
{
    std::vector<PaletteEntry> entries;
    const std::size_t first = m_next;
    for (; m_next < m_headings.size() && m_headings[m_next].page == m_headings[first].page; ++m_next) {
        const ManualHeading &heading = m_headings[m_next];
        const bool isPage = heading.title == heading.page;
        entries.push_back({.kind = PaletteEntry::Kind::manual,
                           .id = QStringLiteral("manual:") + heading.topic,
                           .title = heading.title,
                           .context = isPage ? QString() : heading.page,
                           .words = titleOf(heading.topic.section(u'#', 0, 0).section(u'/', -1)),
                           .run = [show = m_show, topic = heading.topic] { show(topic); }});
    }
    return entries;
}

} // namespace codewheel
