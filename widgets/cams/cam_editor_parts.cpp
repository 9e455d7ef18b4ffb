// SPDX-License-Identifier: GPL-3.0-or-later
// What the cam editor is made of: tools, pages and how they are connected.
#include "history/track.h"
#include "widgets/cams/cam_board.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/cams/cam_mode_bar.h"
#include "widgets/cams/cam_range_bar.h"
#include "widgets/cams/cam_review.h"
#include "widgets/job/job_strip.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"
#include "widgets/look/tool.h"
#include "widgets/models/age_timer.h"

#include <QMenu>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>

namespace codewheel {

CamEditor::CamEditor(const Buses &buses, const Catalog &catalog, ProjectDocument &project, QWidget *parent)
    : Page(parent)
    , m_buses(buses)
    , m_catalog(catalog)
    , m_project(project)
    , m_sheet(new CamSheet(project, this))
    , m_age(new AgeTimer(this))
    , m_jobs(new CamJobs(this))
    , m_tools(new QToolBar(this))
    , m_menu(new QMenu(this))
    , m_message(new InlineMessage(this))
    , m_mode(new CamModeBar(this))
    , m_range(new CamRangeBar(this))
    , m_pages(new QStackedWidget(this))
    , m_empty(new EmptyState(Icon::cams, {}, {}, this))
    , m_board(new CamBoard(*m_sheet, this))
    , m_scroll(new QScrollArea(this))
    , m_review(new CamReview(this))
    , m_job(new JobStrip(this))
{
    makeTools();
    makePages();
    setFocusProxy(m_board);
    connectParts();
    setEncoder({});
    onEvent(this, {QEvent::Show}, [this] { showLive(); });
}

void CamEditor::makePages()
{
    m_scroll->setWidget(m_board);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_pages->addWidget(m_empty);
    m_pages->addWidget(m_scroll);
    m_pages->addWidget(m_review);
    layOutColumn(this,
                 {m_tools, layOutColumn({m_message, m_mode, m_range, {m_pages, 1}, m_job},
                                        {.spacing = grid::unit,
                                         .margins = QMargins(grid::margin, 0, grid::margin, grid::margin)})},
                 {.spacing = grid::unit, .margins = QMargins()});
}

void CamEditor::makeTools()
{
    setUpToolBar(*m_tools);
    const auto makeTool = [this](const Tool &tool, auto slot) {
        QAction *action = addTool(*this, *m_tools, tool);
        connect(action, &QAction::triggered, this, slot);
        return action;
    };
    m_jobActions = {
        makeTool({Icon::read, tr("Read"), Qt::CTRL | Qt::Key_R,
                  tr("Read this program from the encoder; no position is shown meanwhile")},
                 [this] { readPrograms(CamJobs::Purpose::read, {m_sheet->number()}); }),
        makeTool({Icon::write, tr("Write…"), Qt::CTRL | Qt::Key_Return,
                  tr("Show what will be written before anything is sent")},
                 &CamEditor::write),
        makeTool({Icon::compare, tr("Compare"), Qt::CTRL | Qt::Key_D,
                  tr("Read this program and say what differs; nothing is changed")},
                 [this] { readPrograms(CamJobs::Purpose::compare, {m_sheet->number()}); }),
    };
    m_tools->addSeparator();
    // The window has the keys: what is undone is the last step of the project.
    QAction *undo = m_project.undoStack().createUndoAction(this, tr("Undo"));
    QAction *redo = m_project.undoStack().createRedoAction(this, tr("Redo"));
    undo->setIcon(lineIcon(Icon::turnLeft));
    redo->setIcon(lineIcon(Icon::turnRight));
    QAction *open = makeTool(
        {Icon::open, tr("Open"), Qt::CTRL | Qt::SHIFT | Qt::Key_O, tr("Load the cam programs from a file")},
        &CamEditor::askLoad);
    QAction *save = makeTool({Icon::save, tr("Save"), Qt::CTRL | Qt::SHIFT | Qt::Key_E,
                              tr("Save all eight programs in a file of their own")},
                             &CamEditor::askSave);
    for (QAction *action : {undo, redo})
        m_tools->insertAction(open, action);
    // Their icons are known to everyone, and what would be undone is long. The bar gives all its buttons its
    // own style whenever there is room for words again.
    const auto showIconsOnly = [this, known = QList{undo, redo, open, save}] {
        for (QAction *action : known)
            static_cast<QToolButton *>(m_tools->widgetForAction(action))
                ->setToolButtonStyle(Qt::ToolButtonIconOnly);
    };
    showIconsOnly();
    connect(m_tools, &QToolBar::toolButtonStyleChanged, this, showIconsOnly);
    m_fileActions = {open, save};
    makeMenu();
    for (QAction *action : m_jobActions) // while disabled, the tooltip says why instead
        action->setStatusTip(action->toolTip());
}

void CamEditor::makeMenu()
{
    const auto add = [this](const QString &text, const QString &tip, auto slot) {
        QAction *action = m_menu->addAction(text);
        action->setToolTip(tip);
        connect(action, &QAction::triggered, this, slot);
        return action;
    };
    m_modeActions << add(tr("&Run this program in the encoder"),
                         tr("Cam mode: IN shows the cams of this program"),
                         [this] {
                             start(CamJobs::Purpose::switchMode,
                                   SwitchMode{.mode = Mode::cam, .camProgram = m_sheet->number()});
                         })
                  << add(tr("Back to &position mode"), tr("IN shows the position again"),
                         [this] { start(CamJobs::Purpose::switchMode, SwitchMode{.mode = Mode::position}); });
    m_jobActions << m_modeActions;
    m_menu->addSeparator();
    m_jobActions << add(tr("Read &all programs"),
                        tr("Each program is left again: what was changed and not stored is stored then, up "
                           "to 8 EEPROM "
                           "writes"),
                        &CamEditor::readAll)
                 << add(tr("&Write all programs…"),
                        tr("All that are set here and are not known to be in the encoder"),
                        &CamEditor::writeAll);
    m_menu->addSeparator();
    m_fileActions << add(tr("&Open this program alone…"), tr("Load the program shown from a file"),
                         &CamEditor::askLoadProgram);
    m_fileActions << add(tr("&Save this program alone…"), tr("Save the program shown in a file"),
                         &CamEditor::askSaveProgram);
    m_menu->addSeparator();
    m_fileActions << add(tr("&Clear this program"), tr("All eight cams inactive, shift 0; can be undone"),
                         [this] {
                             const CamProgram empty{.number = m_sheet->number()};
                             m_sheet->document().setProgram(empty, tr("Clear program %1").arg(empty.number));
                         });
    m_menu->addSeparator();
    m_fileActions << add(
        tr("Show this cam in &trend"), tr("As it is in IN while the encoder is in cam mode"), [this] {
            Q_EMIT trendWanted({m_encoder.place(), Channel::cams, static_cast<unsigned>(m_sheet->current())});
        });
    m_menu->setToolTipsVisible(true);

    auto *more =
        describe(new QToolButton(m_tools), tr("More for the cams"), tr("Modes, all programs, single files"));
    more->setText(tr("&More"));
    more->setPopupMode(QToolButton::InstantPopup);
    more->setMenu(m_menu);
    m_tools->addWidget(more);
    for (QAction *action : m_tools->actions())
        if (QWidget *button = m_tools->widgetForAction(action); button != nullptr && !action->isSeparator())
            button->setFocusPolicy(Qt::TabFocus);
}

void CamEditor::connectParts()
{
    connect(m_age, &QTimer::timeout, this, &CamEditor::showLive);
    connect(m_jobs, &CamJobs::ended, this, &CamEditor::finished);
    connect(m_board, &CamBoard::programChosen, this, &CamEditor::chooseProgram);
    const auto checked = [this](const QString &wrong) {
        if (wrong.isEmpty())
            withdraw(Cause::input);
        else
            say(Cause::input, Role::fault, wrong);
    };
    connect(m_board, &CamBoard::inputChecked, this, checked);
    connect(m_range, &CamRangeBar::inputChecked, this, checked);
    connect(m_range, &CamRangeBar::readRequested, this, &CamEditor::readRange);
    connect(m_range, &CamRangeBar::told, this, &CamEditor::tellLargest);
    connect(m_mode, &CamModeBar::answered, this, [this](const SwitchMode &afterwards) {
        if (session() && m_whenAnswered)
            std::exchange(m_whenAnswered, {})(afterwards);
    });
    connect(m_message, &InlineMessage::actionTriggered, this, &CamEditor::bringBack);
    connect(m_review, &CamReview::cancelled, this, [this] { m_pages->setCurrentWidget(m_scroll); });
    connect(m_review, &CamReview::confirmed, this, [this](const Job &job) {
        m_pages->setCurrentWidget(m_scroll);
        start(CamJobs::Purpose::write, job);
    });
    connect(m_sheet, &CamSheet::programChanged, this, [this] {
        withdraw(Cause::input);
        showLive();
    });
    connect(&m_project, &ProjectDocument::changed, this, [this] {
        if (m_encoder.isThere() && !session())
            showRange(); // the range follows the wanted values
    });
    connect(m_sheet, &CamSheet::largestChanged, this, [this] { withdraw(Cause::input); });
}

} // namespace codewheel
