// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/id_runs.h"
#include "journal/message_search.h"
#include "journal/message_store.h"

#include <QAbstractTableModel>
#include <QCache>
#include <QPointer>
#include <QTimer>

namespace codewheel {

class EncoderBus;

// Everything that happened to bus and devices, oldest first, as the message store keeps it, of this run of
// the program and of those before. Fetches the messages that are looked at and knows of the others only their
// number; texts are made when they are shown, so that the language can change.
class MessageModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { timeColumn, severityColumn, placeColumn, textColumn, columnTotal };

    // The store outlives the model.
    explicit MessageModel(MessageStore &store, QObject *parent = nullptr);

    // Takes the date and time of this bus from now on, for what is added without any: where time is virtual.
    void setClock(EncoderBus &bus);
    // Shown as soon as the store has it.
    void add(const Message &message, const QDateTime &at);
    // Something that happens now.
    void addNow(Message message);

    // Looks for what fits in the background, newest first; ends the search before.
    void setFilter(const MessageFilter &filter);
    const MessageFilter &filter() const { return m_filter; }
    // How much of it was looked through, 0..1; nothing while none is sought.
    std::optional<double> searched() const;

    // Hides all that was before now; on disk it stays.
    void clear();
    bool isCleared() const { return m_clearedUpTo > 0; }
    void bringBack();

    bool isEmpty() const; // nothing to show, even without the filter
    std::vector<Place> places() const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    const IdRuns &ids() const { return m_ids; }
    StoredMessage message(int row) const; // with the id 0 where it was dropped since
    std::vector<StoredMessage> read(const std::vector<qint64> &ids) const;

    // As shown in this column; with Column::timeColumn to the millisecond.
    static QString text(const StoredMessage &message, int column);

    // Shows what came and what was found since the last time. Comes by itself ten times a second.
    void refresh();
    // Waits until all that was added is kept and all that fits is found, and shows it.
    void catchUp();

Q_SIGNALS:
    void searchChanged(); // begun, further, ended

private:
    bool openTable();
    void failed(const DatabaseError &error) const;
    void list();
    void takeNew();
    void takeFound();
    void dropBelow(qint64 first);
    qint64 firstShown() const;

    MessageStore &m_store;
    QPointer<EncoderBus> m_clock;
    DatabasePlace m_place;
    std::optional<MessageTable> m_table; // nothing until the store has one
    qint64 m_changes = 0;                // of the table, when it was looked at last
    MessageTable::Span m_span;           // of the table
    qint64 m_clearedUpTo = 0;            // id
    MessageFilter m_filter;
    MessageTextMatcher m_matcher{{}};
    qint64 m_lookedUpTo = 0; // id; those above are new
    IdRuns m_ids;            // of the rows
    MessageSearch m_search;
    double m_searched = 0;
    mutable QCache<qint64, StoredMessage> m_cache; // by id
    QTimer m_timer;
};

} // namespace codewheel
