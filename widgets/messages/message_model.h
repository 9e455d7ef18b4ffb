// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/id_runs.h"
#include "journal/message_search.h"
#include "journal/message_store.h"

#include <QAbstractTableModel>
#include <QCache>
#include <QPointer>
#include <QTimer>

#include <span>

namespace codewheel {

class EncoderBus;

// Everything that happened to bus and devices, oldest first, as the message store keeps it, of this run of
// the program and of those before: a row for each day, and one for messages in a row that are alike. Fetches
// the messages that are looked at and knows of the others only in which row they stand, which is found out in
// the background, newest first; texts are made when they are shown, so that the language can change.
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

    // Attentions and faults that were added since they were seen last.
    int unseen() const { return m_unseen; }
    void see();

    std::vector<Place> places() const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    Qt::ItemFlags flags(const QModelIndex &index) const override;

    // All that fit the filter, as far as they were found.
    IdRuns ids() const;
    qint64 foundCount() const { return m_ids.size(); } // so far
    bool isDay(int row) const { return m_rows.at(row).isDay(); }
    // Of a row the newest; with the id 0 where it was dropped since.
    StoredMessage message(int row) const;
    StoredMessage oldestMessage(int row) const;
    qint64 countOf(int row) const { return m_rows.at(row).count; } // 0: a day
    std::vector<qint64> idsOf(int row) const;
    // Whatever is shown: the newest, oldest first.
    std::vector<StoredMessage> newest(qint64 most) const;
    std::vector<StoredMessage> read(const std::vector<qint64> &ids) const;

    // Of a single message, as it is copied: with date, and time to the millisecond.
    static QString text(const StoredMessage &message, int column);

    // Shows what came and what was found since the last time. Comes by itself ten times a second.
    void refresh();
    // Waits until all that was added is kept and all that fits is found, and shows it.
    void catchUp();

Q_SIGNALS:
    void searchChanged(); // begun, further, ended
    void unseenChanged();

private:
    bool openTable();
    void failed(const DatabaseError &error) const;
    void list();
    void takeNew();
    void takeFound();
    void append(std::span<const SightedMessage> messages);
    void prepend(std::span<const SightedMessage> messages);
    void insertBefore(int row, std::span<const SightedMessage> messages);
    void tellChanged(int row);
    QVariant dayData(int row, int column, int role) const;
    QString rowText(int row, const StoredMessage &newest, int column) const;
    QString toolTip(int row, const StoredMessage &newest, int column) const;
    StoredMessage stored(qint64 id, const std::vector<qint64> &near) const;
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
    IdRuns m_ids;            // that fit
    MessageRows m_rows;      // of m_ids
    int m_unseen = 0;
    MessageSearch m_search;
    double m_searched = 0;
    mutable QCache<qint64, StoredMessage> m_cache; // by id
    QTimer m_timer;
};

} // namespace codewheel
