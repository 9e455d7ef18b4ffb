// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/encoder_bus.h"
#include "journal/known_keeper.h"

#include <any>
#include <functional>
#include <memory>

namespace codewheel {

class Catalog;
class LedgerKeeper;
class ProjectDocument;

// One bus of the program, connected or not, with the account of the EEPROM writes to its encoders. Outlives
// the window, which is rebuilt when the language changes.
class BusAtWork : public QObject
{
    Q_OBJECT

public:
    using Clock = std::function<QDateTime()>; // date and time of Instant 0 of a bus opened now

    // What all buses of the program share. Catalog and project outlive them.
    struct Surroundings
    {
        const Catalog &catalog;
        ProjectDocument &project;
        QString dataFolder;   // for the ledger
        bool byThread = true; // otherwise driven by hand: simulated buses keep virtual time
        Clock clock;
        // A kind's replacement for its usual training bus, of a type of its own; empty: none.
        std::any training{};
    };

    BusAtWork(BusId id, Surroundings surroundings, QObject *parent = nullptr);
    ~BusAtWork() override;

    BusId id() const { return m_id; }
    const Catalog &catalog() const { return m_surroundings.catalog; }
    ProjectDocument &project() const { return m_surroundings.project; }
    virtual QString kind() const = 0;    // as in projects: "interbus"
    virtual bool isTraining() const;     // such a bus always exists
    virtual QString nameOfNew() const;   // while no project gives it a name
    virtual EncoderBus *bus() const = 0; // null: there is none now
    bool isOpen() const { return bus() != nullptr && bus()->isOpen(); }
    // Why there is no data of this device, or, without a node, of the bus: also while it is not connected.
    std::vector<DataCheck> dataChecks(NodeId node) const;
    virtual void openTraining() {} // connects a training bus, in Operate
    // An encoder of a training bus whose shaft turns by itself.
    virtual std::optional<Place> turning() const { return std::nullopt; }
    // What ends for others when the project or the program is closed, in a sentence; empty: nothing.
    virtual QString endsForOthers() const { return {}; }
    virtual void start() {} // by a thread of its own from now on, unless it is driven by hand
    const LedgerKeeper *ledger() const { return m_ledger.get(); } // null: no bus

Q_SIGNALS:
    void aboutToChange(); // bus() and its encoders are about to go
    void changed();       // bus() has changed, or is null
    void messaged(const codewheel::Message &message, const QDateTime &at);

protected:
    const Surroundings &surroundings() const { return m_surroundings; }
    // Why it was refused to connect it before there was a session to ask; empty: it was not.
    void noteRefused(const std::optional<Refusal> &why) { m_whyRefused = why; }
    void tellMessagesOf(EncoderBus &bus);
    void keepAccount(std::unique_ptr<LedgerKeeper> ledger); // from now on
    void endAccount();
    void forgetKnown();     // it leads to other encoders from now on
    void forgetSimulated(); // they are new ones

private:
    void carryAccount();

    const BusId m_id;
    const Surroundings m_surroundings;
    std::unique_ptr<LedgerKeeper> m_ledger;
    QString m_file; // of the project
    KnownKeeper m_known;
    std::optional<Refusal> m_whyRefused;
};

} // namespace codewheel
