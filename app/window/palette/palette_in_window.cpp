// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/palette_in_window.h"

#include "app/window/buses/device_choice.h"
#include "app/window/buses/plant.h"
#include "app/window/help/context_help.h"
#include "app/window/look/panels.h"
#include "app/window/palette/palette_entries.h"
#include "app/window/palette/palette_manual.h"
#include "app/window/palette/palette_messages.h"
#include "app/window/window_actions.h"
#include "app/window/window_settings.h"
#include "widgets/help/help_topic.h"
#include "widgets/messages/messages_view.h"
#include "widgets/palette/command_palette.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QMainWindow>

namespace codewheel {
namespace {

constexpr qsizetype mostKept = 8;

QList<QAction *> usualActions(const WindowActions &actions)
{
    return {actions.monitors, actions.trend,       actions.wizard,          actions.cams,
            actions.transfer, actions.compare,     actions.structureEditor, actions.start,
            actions.stop,     actions.openProject, actions.saveProject,     actions.record,
            actions.settings, actions.manual};
}

} // namespace

PaletteInWindow::PaletteInWindow(const Parts &parts)
    : QObject(&parts.window)
    , m_parts(parts)
{
    auto *palette = new CommandPalette(parts.window);
    setHelpTopic(*palette, "palette.md");
    const auto add = [palette](std::function<std::vector<PaletteEntry>()> entries) {
        palette->addSource(std::make_unique<PaletteOfOnePart>(std::move(entries)));
    };
    add([this] { return actionEntries(m_parts.window, usualActions(m_parts.actions), m_otherLanguage); });
    add([this] {
        return buttonEntries(
            m_parts.window, m_parts.pages, [this](const QDockWidget &panel) { m_parts.panels.show(panel); },
            m_otherLanguage);
    });
    add([this] {
        return parameterEntries(m_parts.choice.encoder(), [this](Parameter each) { showParameter(each); });
    });
    add([this] {
        return deviceEntries(m_parts.structure, m_parts.plant.buses(), m_parts.project,
                             m_parts.plant.catalog(), [this](Place place) { showDevice(place); });
    });
    palette->addSource(std::make_unique<PaletteManual>(
        [help = &parts.help](const QString &topic) { help->showTopic(topic); }));
    palette->addSource(
        std::make_unique<PaletteMessages>(parts.messageModel, [this](qint64 id) { showMessage(id); }));
    connect(parts.actions.findCommand, &QAction::triggered, palette, [this, palette] {
        palette->setUsed(m_parts.settings.usedCommands());
        palette->open();
    });
    connect(palette, &CommandPalette::used, this, &PaletteInWindow::noteUsed);
    parts.actions.findCommand->setEnabled(true);
}

void PaletteInWindow::showDevice(Place place) const
{
    m_parts.panels.show(panel::structure);
    m_parts.structure.reveal(place);
    m_parts.showMonitors();
    m_parts.structure.setFocus();
}

void PaletteInWindow::showParameter(Parameter parameter) const
{
    m_parts.panels.show(panel::parameters);
    m_parts.parameters.showParameter(parameter);
}

void PaletteInWindow::showMessage(qint64 id) const
{
    m_parts.panels.show(panel::messages);
    m_parts.messages.showMessage(id);
}

void PaletteInWindow::noteUsed(const QString &id) const
{
    QStringList used = m_parts.settings.usedCommands();
    used.removeAll(id);
    used.prepend(id);
    m_parts.settings.setUsedCommands(used.first(std::min(mostKept, used.size())));
}

} // namespace codewheel
