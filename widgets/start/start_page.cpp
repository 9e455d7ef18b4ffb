// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/start_page.h"

#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/start/recent_list.h"
#include "widgets/start/start_entry.h"

#include <QAction>
#include <QFileInfo>
#include <QLabel>
#include <QResizeEvent>
#include <QToolButton>

namespace codewheel {
namespace {

constexpr int twoColumnsFrom = 96; // characters

// Its key works anywhere on the page.
QAction *entry(StartPage &page, Icon icon, const QString &title, const QString &sentence, Qt::Key key)
{
    auto *action = new QAction(lineIcon(icon), title, &page);
    action->setToolTip(sentence);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    page.addAction(action);
    return action;
}

} // namespace

StartPage::StartPage(QWidget *parent)
    : QScrollArea(parent)
    , reopen(entry(*this, Icon::refresh, QString(), QString(), Qt::Key_0))
    , training(
          entry(*this, Icon::training, tr("Training bus"),
                tr("Simulated encoders on a ring and a serial line, to try everything without hardware."),
                Qt::Key_1))
    , connectBus(entry(*this, Icon::ring, tr("Connect"),
                       tr("Looks at the encoders of a bus. Nothing is written."), Qt::Key_2))
    , open(entry(*this, Icon::open, tr("Open a project"),
                 tr("The planned encoders, with the values they should have."), Qt::Key_3))
    , recent(entry(*this, Icon::down, tr("Recent projects"), tr("Goes to the projects that were open last"),
                   Qt::Key_6))
    , replace(
          entry(*this, Icon::encoder, tr("Replace an encoder"),
                tr("Gives a new encoder the values and the position of the previous one, from the project."),
                Qt::Key_4))
    , find(entry(
          *this, Icon::search, tr("Who is there?"),
          tr("Listens at ports and hosts for encoders and gateways, and connects with the settings found."),
          Qt::Key_5))
    , m_content(new QWidget(this))
    , m_heading(wrappedLabel(m_content, "startHeading"))
    , m_project(wrappedLabel(m_content, "startProject"))
{
    setObjectName(QStringLiteral("startPage"));
    setAccessibleName(tr("Start"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_heading->setFont(textFont(TextSize::large));
    m_heading->setText(tr("No bus is connected"));
    m_project->setTextFormat(Qt::PlainText);
    auto *entries = new QVBoxLayout;
    auto *files = new QVBoxLayout;
    makeEntries(*entries);
    makeRecent(*files);
    m_columns = layOutRow({entries, files}, {.spacing = 2 * grid::margin});
    m_columns->setStretch(0, 1);
    m_columns->setStretch(1, 1);
    layOutColumn(m_content, {m_heading, m_project, m_columns, Stretch{1}},
                 {.spacing = grid::margin, .margins = allAround(grid::margin)});
    setWidget(m_content);
    connect(recent, &QAction::triggered, this, [this] { m_list->setFocus(Qt::ShortcutFocusReason); });
    setProject({});
    setLast({});
    setRecent({});
}

void StartPage::makeEntries(QBoxLayout &column)
{
    column.setSpacing(grid::margin);
    for (QAction *action : {reopen, training, connectBus, open, replace, find}) {
        auto *its = new StartEntry(*action, m_content);
        column.addWidget(its);
        m_entries.push_back(its);
    }
    named(m_entries[0], "startReopen");
    named(m_entries[1], "startTraining");
    named(m_entries[2], "startConnect");
    named(m_entries[3], "startOpen");
    named(m_entries[4], "startReplace");
    named(m_entries[5], "startFind");
    column.addStretch(1);
}

void StartPage::makeRecent(QBoxLayout &column)
{
    m_recent = new QWidget(m_content);
    auto *title = new QLabel(
        tr("%1: key %2").arg(recent->text(), recent->shortcut().toString(QKeySequence::NativeText)));
    m_list = describe(new RecentList(m_recent), "recentFiles", recent->text(),
                      tr("Return opens the chosen project, Del takes it off the list."));
    m_remove = describe(new QToolButton(m_recent), "recentRemove", tr("Remove from the list"),
                        tr("Takes the chosen project off the list (Del); its file stays"));
    m_remove->setIcon(lineIcon(Icon::remove));
    m_remove->setAutoRaise(true);
    title->setBuddy(m_list);
    layOutColumn(m_recent, {layOutRow({title, Stretch{1}, m_remove}), m_list},
                 {.spacing = grid::unit, .margins = QMargins()});
    column.addWidget(m_recent);
    column.addStretch(1);
    connect(m_list, &RecentList::openRequested, this, &StartPage::recentRequested);
    connect(m_list, &RecentList::removeRequested, this, &StartPage::removeRequested);
    connect(m_remove, &QToolButton::clicked, m_list, &RecentList::removeCurrent);
    connect(m_list, &RecentList::currentRowChanged, this, [this](int row) {
        if (row >= 0 && m_list->hasFocus())
            ensureVisible(
                0, m_list->mapTo(m_content, m_list->visualItemRect(m_list->item(row)).bottomLeft()).y());
    });
}

void StartPage::setProject(const QString &file)
{
    m_project->setText(file.isEmpty()
                           ? tr("Nothing is connected or sent until you ask for it.")
                           : tr("The project %1 is open. Nothing is connected or sent until you ask "
                                "for it.")
                                 .arg(QFileInfo(file).fileName()));
}

void StartPage::setLast(const RecentFile &file)
{
    const QString why = codewheel::whyNotOpened(file.state);
    reopen->setText(tr("Reopen %1").arg(QFileInfo(file.path).fileName()));
    reopen->setToolTip(why.isEmpty() ? tr("The project of the last session, %1").arg(file.path)
                                     : tr("%1: %2").arg(file.path, why));
    reopen->setEnabled(file.canBeOpened());
    reopen->setVisible(!file.path.isEmpty());
}

void StartPage::setRecent(const std::vector<RecentFile> &files)
{
    m_list->setFiles(files);
    m_recent->setVisible(!files.empty());
    m_columns->setStretch(1, files.empty() ? 0 : 1);
    recent->setEnabled(!files.empty());
}

QWidget *StartPage::connectEntry() const
{
    return m_entries[2];
}

void StartPage::resizeEvent(QResizeEvent *event)
{
    const int enough = twoColumnsFrom * fontMetrics().averageCharWidth();
    for (QWidget *entry : m_entries)
        entry->setMaximumWidth(enough);
    const bool isWide = event->size().width() >= enough;
    m_columns->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    QScrollArea::resizeEvent(event);
}

// The last activity is the most likely next one.
void StartPage::focusInEvent(QFocusEvent *event)
{
    const bool isReopened = reopen->isVisible() && reopen->isEnabled();
    m_entries[isReopened ? 0 : 1]->setFocus(event->reason());
}

} // namespace codewheel
