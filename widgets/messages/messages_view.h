// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/messages/message_filter.h"
#include "widgets/messages/message_model.h"

#include <QWidget>

class QAction;
class QBoxLayout;
class QComboBox;
class QLineEdit;
class QTableView;
class QToolButton;

namespace codewheel {

class EmptyState;
class InlineMessage;

// The messages, newest last: to filter, search, copy, export. Used by the bottom dock.
class MessagesView : public QWidget
{
    Q_OBJECT

public:
    // The model outlives the view.
    explicit MessagesView(MessageModel &messages, QWidget *parent = nullptr);

    // Something that happens now; stamped with the time of the bus.
    void add(const Message &message);
    // Asks for a file and writes the rows shown to it, as CSV.
    void exportRows();
    void copy(); // the rows chosen, else all that are shown; columns separated by tabs
    void clear();

protected:
    void changeEvent(QEvent *event) override;

private:
    QBoxLayout *makeFilters();
    void makeTable();
    QAction *addCommand(QBoxLayout *row, const QIcon &icon, const QString &text, const QString &toolTip);
    void makeCommands(QBoxLayout *row);
    void setColumnWidths();
    void listPlaces(int firstNew);
    void showAll();
    void bringBack();
    void updateContent();
    void followNewest();
    void writeFile(const QString &fileName);
    std::vector<int> chosenRows() const; // of the filter, in order; all where none is chosen
    const MessageRow &shownRow(int row) const;

    MessageModel &m_messages;
    MessageFilter *m_filter;
    QLineEdit *m_search;
    QComboBox *m_severity;
    QComboBox *m_place;
    QAction *m_follow = nullptr;
    QTableView *m_table;
    InlineMessage *m_note;
    EmptyState *m_empty;
    std::vector<MessageRow> m_cleared; // can be brought back while the note says so
};

} // namespace codewheel
