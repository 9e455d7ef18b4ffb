// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/connect/start.h"

#include "app/window/buses/plant.h"
#include "app/window/files/project_files.h"
#include "app/window/kinds/window_kinds.h"
#include "app/window/window_actions.h"
#include "app/window/window_settings.h"
#include "project/bus_kind.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/project/project_document.h"
#include "widgets/start/start_page.h"

#include <QAction>
#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {

Start::Start(const Parts &parts, QObject *parent)
    : QObject(parent)
    , m_parts(parts)
    , m_page(new StartPage(&parts.pages))
    , m_replacing(new InlineMessage(&parts.pages))
{
    parts.pages.addWidget(m_page);
    setHelpTopic(*m_page, "start.md");
    parts.notices.insertWidget(0, m_replacing);
    m_replacing->setObjectName(QStringLiteral("replaceNotice"));
    connect(m_page->reopen, &QAction::triggered, this, [this] { m_parts.files.open(QString(m_last)); });
    connect(m_page->training, &QAction::triggered, this, &Start::openTraining);
    connect(m_page->connectBus, &QAction::triggered, this, &Start::chooseBus);
    connect(m_page->open, &QAction::triggered, parts.actions.openProject, &QAction::trigger);
    connect(m_page->replace, &QAction::triggered, this, &Start::beginReplacing);
    connect(m_page->find, &QAction::triggered, parts.actions.findEncoders, &QAction::trigger);
    connect(m_page, &StartPage::recentRequested, &parts.files, &ProjectFiles::open, Qt::QueuedConnection);
    connect(m_page, &StartPage::removeRequested, &parts.files, &ProjectFiles::forget);
    connect(&parts.files, &ProjectFiles::recentChanged, this, &Start::lookAtFiles);
    connect(&m_look, &FileLook::changed, this, &Start::showFiles);
    connect(&parts.project, &ProjectDocument::fileChanged, this, &Start::showProject);
    connect(&parts.project, &ProjectDocument::changed, this, &Start::showReplacing);
    connect(&parts.plant.buses(), &Buses::changed, this, &Start::showReplacing);
    connect(m_replacing, &InlineMessage::closed, this, [this] { m_replaces = false; });
    connect(m_replacing, &InlineMessage::actionTriggered, this, [this] {
        if (!isAnyOpen()) {
            chooseBus();
            return;
        }
        m_replaces = false;
        m_replacing->withdraw();
        m_parts.actions.replaceEncoder->trigger();
    });
    connect(parts.actions.replaceEncoder, &QAction::changed, this, &Start::showReplacing);
    connect(&parts.pages, &QStackedWidget::currentChanged, this, [this] {
        if (m_parts.pages.currentWidget() == m_page)
            lookAtFiles();
    });
    showProject();
    lookAtFiles();
}

bool Start::isAnyOpen() const
{
    return !m_parts.plant.buses().open().empty();
}

void Start::offer(const QString &lastFile)
{
    m_last = lastFile;
    lookAtFiles();
    if (m_parts.pages.currentWidget() == m_page)
        m_page->setFocus(); // on the first offer
}

QWidget *Start::pageInsteadOf(QWidget *monitors) const
{
    return isAnyOpen() ? monitors : m_page;
}

QWidget *Start::page() const
{
    return m_page;
}

void Start::showProject()
{
    const QString file = m_parts.project.file();
    if (!file.isEmpty())
        m_last.clear();
    m_page->setProject(file);
    showFiles();
}

void Start::lookAtFiles()
{
    m_look.look(m_last);
    for (const QString &path : m_parts.settings.recentFiles())
        m_look.look(path);
    showFiles();
}

void Start::showFiles()
{
    std::vector<RecentFile> files;
    for (const QString &path : m_parts.settings.recentFiles())
        files.push_back({path, m_look.state(path)});
    m_page->setRecent(files);
    m_page->setLast({m_last, m_look.state(m_last)});
}

void Start::openTraining()
{
    if (isTrainingPlan()) {
        for (const BusAtWork *bus : m_parts.plant.all())
            if (bus->isTraining() && !bus->isOpen())
                Q_EMIT trainingRequested(bus->id());
        return;
    }
    if (!m_parts.files.makeNewForTraining())
        return;
    m_parts.plant.openTraining();
    m_parts.plant.start();
}

// A project in no file that plans the training buses as such: that of the training plant, or one made on it.
bool Start::isTrainingPlan() const
{
    const Project &project = m_parts.project.project();
    if (!m_parts.project.file().isEmpty() || (project.devices.empty() && m_parts.project.isSaved()))
        return false;
    return std::ranges::all_of(m_parts.plant.all(), [&project](const BusAtWork *bus) {
        return !bus->isTraining() || plansTraining(project, bus->id());
    });
}

std::vector<BusAtWork *> Start::closedBuses() const
{
    std::vector<BusAtWork *> planned;
    std::vector<BusAtWork *> all;
    for (BusAtWork *bus : m_parts.plant.all()) {
        const WindowKind *kind = windowKind(bus->kind());
        if (bus->isOpen() || kind == nullptr || kind->makeViews == nullptr)
            continue;
        all.push_back(bus);
        if (findBus(m_parts.project.project(), bus->id()) != nullptr)
            planned.push_back(bus);
    }
    return planned.empty() || m_parts.project.project().devices.empty() ? all : planned;
}

void Start::chooseBus()
{
    const auto buses = closedBuses();
    if (buses.size() == 1) {
        Q_EMIT connectRequested(buses.front()->id());
        return;
    }
    auto *menu = new QMenu(m_page);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const BusAtWork *bus : buses) {
        const BusId id = bus->id();
        const QString title = asLabel(m_parts.plant.nameOf(id));
        connect(menu->addAction(QStringLiteral("%1 (%2)").arg(title, busKind(bus->kind())->title())),
                &QAction::triggered, this, [this, id] { Q_EMIT connectRequested(id); });
    }
    const QWidget *entry = m_page->isVisible() ? m_page->connectEntry() : m_replacing;
    menu->popup(entry->mapToGlobal(entry->rect().bottomLeft()));
    menu->setActiveAction(menu->actions().value(0));
}

// Needs both: the project for its values, and the bus to reach the new encoder.
void Start::beginReplacing()
{
    if (m_parts.project.project().devices.empty() && !m_parts.files.askOpen())
        return;
    m_replaces = true;
    showReplacing();
}

void Start::showReplacing()
{
    if (!m_replaces)
        return;
    if (!isAnyOpen())
        m_replacing->showMessage(Role::attention,
                                 tr("Replace an encoder: connect the bus that the new encoder is on."),
                                 tr("&Connect"));
    else if (m_parts.actions.replaceEncoder->isEnabled())
        m_replacing->showMessage(Role::attention,
                                 tr("Replace an encoder: choose its place in the bus structure."),
                                 tr("&Replace the chosen one"));
    else
        m_replacing->showMessage(Role::attention,
                                 tr("Replace an encoder: choose its place in the bus structure."));
}

} // namespace codewheel
