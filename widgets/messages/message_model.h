// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/id_runs.h"
#include "journal/message_search.h"
#include "journal/message_store.h"
#include "journal/told_bus_names.h"

#include <QAbstractTableModel>
#include <QCache>
#include <QIcon>
#include <QPointer>
#include <QTimer>

#include <span>

namespace codewheel {

class EncoderBus;

// Everything that has happened to buses and devices, oldest first, from the message store, of this and
// earlier runs of the program: a row for each day, and one for consecutive messages that are alike. Fetches
// only the messages that are looked at; which row the others are in is found out in the background, newest
// first. Texts are made when they are shown, so that the language can change.
class MessageModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { timeColumn, severityColumn, placeColumn, textColumn, columnTotal };

    // The store outlives the model.
    explicit MessageModel(MessageStore &store, QObject *parent = nullptr);

    // Messages added without a date and time get those of this bus from now on, where time is virtual.
    void setClock(EncoderBus &bus);
    // Shown once the store has it.
    void add(const Message &message, const QDateTime &at);
    // Something that happens now.
    void addNow(Message message);

    // Searches for matches in the background, newest first; ends the previous search.
    void setFilter(const MessageFilter &filter);
    const MessageFilter &filter() const { return m_filter; }
    // The part searched so far, 0..1; nothing while no search runs.
    std::optional<double> searched() const;

    // Hides everything up to now; on disk it stays.
    void clear();
    bool isCleared() const { return m_clearedUpTo > 0; }
    void bringBack();

    bool isEmpty() const; // nothing to show, even without the filter

    // Attentions and faults added since they were last seen.
    int unseen() const { return m_unseen; }
    void see();

    std::vector<Place> places() const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

    Qt::ItemFlags flags(const QModelIndex &index) const override;

    // All matches found so far.
    IdRuns ids() const;
    qint64 foundCount() const { return m_ids.size(); } // so far
    // The last row with a message older than this one; -1: none.
    int rowBefore(qint64 id) const;
    int rowOf(qint64 id) const; // that it has or shares; -1: none
    static QIcon icon(Severity severity);
    bool isDay(int row) const { return m_rows.at(row).isDay(); }
    // The newest message of a row; its id is 0 if it has been dropped since.
    StoredMessage message(int row) const;
    StoredMessage oldestMessage(int row) const;
    qint64 countOf(int row) const { return m_rows.at(row).count; } // 0: a day
    std::vector<qint64> idsOf(int row) const;
    // The newest messages, whatever is shown, oldest first.
    std::vector<StoredMessage> newest(qint64 most) const;
    std::vector<StoredMessage> read(const std::vector<qint64> &ids) const;

    // A single message as it is copied: with date, and time to the millisecond.
    QString text(const StoredMessage &message, int column) const;

    const ToldBusNames &busNames() const { return m_busNames; } // when they were told

    // Shows what was added and found since the last call. Called internally ten times a second.
    void refresh();
    // Waits until all added messages are kept and all matches found, and shows them.
    void catchUp();

Q_SIGNALS:
    void searchChanged(); // it began, made progress or ended
    void unseenChanged();
    void added(const codewheel::Message &message); // by whoever tells it, while the program runs

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
    std::optional<MessageTable> m_table; // unset until the store has one
    qint64 m_changes = 0;                // of the table, at the last look
    MessageTable::Span m_span;           // of the table
    qint64 m_clearedUpTo = 0;            // id
    MessageFilter m_filter;
    MessageTextMatcher m_matcher{{}};
    qint64 m_lookedUpTo = 0; // id; those above are new
    IdRuns m_ids;            // that fit
    MessageRows m_rows;      // of m_ids
    int m_unseen = 0;
    ToldBusNames m_busNames;
    MessageSearch m_search;
    double m_searched = 0;
    mutable QCache<qint64, StoredMessage> m_cache; // by id
    QTimer m_timer;
};

} // namespace codewheel
