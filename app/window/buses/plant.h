// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/bus_at_work.h"
#include "app/window/recording/recording_at_work.h"
#include "bus/buses.h"
#include "history/histories.h"
#include "transfer/last_positions.h"

#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace codewheel {

class Recordings;

// The buses of the program: the training ring and the training line, and those that the project plans. An
// open bus that is no longer planned stays until it is closed.
class Plant : public QObject
{
    Q_OBJECT

public:
    explicit Plant(BusAtWork::Surroundings surroundings, QObject *parent = nullptr);
    ~Plant() override;

    const Catalog &catalog() const { return m_surroundings.catalog; }
    std::vector<BusAtWork *> all() const; // by number
    QString nameOf(BusId bus) const;      // in the project, or the last one it had
    BusAtWork *find(BusId bus) const;     // null: there is none
    // The sessions of all buses.
    Buses &buses() { return m_sessions; }
    // What their encoders have shown.
    Histories &histories() { return m_histories; }
    RecordingAtWork &recording() { return m_recording; }
    LastPositions &positions() { return m_positions; }
    std::vector<const LedgerKeeper *> ledgers() const;
    template <class Bus>
    Bus *first() const // of this class; null: there is none
    {
        for (const auto &bus : m_buses)
            if (auto *its = qobject_cast<Bus *>(bus.get()))
                return its;
        return nullptr;
    }

    Recordings &recordings() { return *m_recordings; }
    // One that no project plans; it stays until it is closed.
    void add(std::unique_ptr<BusAtWork> bus);
    void removeUnneeded();

    // Takes a frame of all buses.
    void pump();
    // Of the computer, or, where buses are driven by hand, theirs.
    QDateTime wallClock() const;

    // Connects the training buses, which start in Operate.
    void openTraining();
    // Names that no project has given are made in the present language.
    void nameAnew();
    // In threads of their own from now on, unless they are driven by hand.
    void start();

Q_SIGNALS:
    void added(codewheel::BusAtWork *bus);
    void aboutToRemove(codewheel::BusAtWork *bus);
    void messaged(const codewheel::Message &message, const QDateTime &at);

private:
    void make(const QString &kind, BusId id);
    void followProject();
    void callBuses();
    void nameBuses();
    bool isNeeded(const BusAtWork &bus) const;

    const BusAtWork::Surroundings m_surroundings;
    using Names = std::map<BusId, QString>;
    Names m_called;                  // each one unique
    std::set<BusId> m_named;         // those of them that a project has given
    std::pair<Names, Names> m_names; // of those whose places others may also have, and of all
    Buses m_sessions;
    Histories m_histories{m_sessions};
    LastPositions m_positions{m_sessions};
    std::vector<std::unique_ptr<BusAtWork>> m_buses;
    Recordings *const m_recordings;
    RecordingAtWork m_recording{m_sessions, m_histories, [this] { return wallClock(); }}; // ends first
};

} // namespace codewheel
