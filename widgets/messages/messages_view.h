// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/roles.h"
#include "widgets/messages/message_export.h"
#include "widgets/messages/message_model.h"

#include <QPointer>
#include <QWidget>

#include <optional>

class QAction;
class QLabel;
class QToolBar;

namespace codewheel {

class EmptyState;
class GoToPlace;
class InlineMessage;
class LogTable;
class MessageDetails;
class MessageFilterBar;

// The messages, newest last: to filter, search, copy, export, and to go to their devices. Used by the bottom
// dock. What is in sight counts as seen.
class MessagesView : public QWidget
{
    Q_OBJECT

public:
    // The model outlives the view, which resets the filter when it goes.
    explicit MessagesView(MessageModel &messages, QWidget *parent = nullptr);
    ~MessagesView() override;

    // The names of the buses, or the buses, have changed.
    void showPlaces();

    // Asks for a file and writes the shown rows to it, as CSV or HTML.
    void exportRows();
    void
    copy(); // the rows chosen, else all that are shown (as many as a clipboard bears); tabs between columns
    void clear();
    void showMessage(qint64 id); // chooses its row, unless it is gone

Q_SIGNALS:
    void goToWanted(codewheel::Place place); // which a message is about

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void makeTable();
    void connectModel();
    QAction *addCommand(QToolBar &bar, const QIcon &icon, const QString &text, const QString &toolTip);
    void makeCommands(QToolBar &bar);
    void setColumnWidths();
    void bringBack();
    void updateContent();
    void showSearch();
    void showChosen();
    int chosenRow() const; // -1: none
    void writeFile(const QString &fileName);
    void showExport(double part);
    void endExport(const QString &failure);
    void act();
    std::vector<qint64> chosenIds() const; // in order; all if none is chosen

    // What the button of the note does.
    enum class NoteAction { none, bringBack, cancelExport };
    void note(NoteAction action, Role role, const QString &sentence, const QString &actionText = {});

    MessageModel &m_messages;
    MessageFilterBar *m_filters;
    QLabel *m_search; // its progress
    LogTable *m_table;
    MessageDetails *m_details;
    InlineMessage *m_note;
    NoteAction m_noteAction = NoteAction::none;
    EmptyState *m_empty;
    QAction *m_follow = nullptr;
    QAction *m_bringBack = nullptr;
    QAction *m_showDetails = nullptr;
    std::optional<bool> m_detailsWanted; // unset: if there is room
    GoToPlace *m_goTo;
    QPointer<MessageExport> m_export;
    int m_exportPercent = -1; // last announced
};

} // namespace codewheel
