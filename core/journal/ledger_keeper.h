// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/encoder_bus.h"
#include "journal/safe_ledger.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <map>
#include <vector>

namespace codewheel {

// Keeps the ledger of one bus: notes each job, and each word or typed write by hand, that may write to an
// EEPROM before anything is sent, what was written once it is seen, and the end; and gives each encoder
// session its count. For window and command line alike, in the thread of their sessions.
//
// Words sent by hand have no end of their own. They are one entry until the encoder has been in operation
// again, and no word that may write has been in OUT, for untilSettled. Writes typed for an encoder are one
// entry until the last of them has ended.
//
// The encoder is identified by the serial number it reported, otherwise by that on its label, otherwise by
// its place. What was noted at a place before a serial number was reported belongs to the encoder that
// reports it, unless something speaks against it: from the moment the number was forgotten or the bus became
// another one, or its link was lost, unless it is then found to be the same encoder. An encoder that moves to
// another place is the same one. What was typed for a place where none is known is noted by that place, for
// the encoder that is added there later.
class LedgerKeeper : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds untilSettled{1000};

    // The bus must outlive the keeper, or be closed first. If the file cannot be used the keeper goes on
    // (SafeLedger), and problem() says so.
    LedgerKeeper(EncoderBus &bus, const DatabasePlace &place, QObject *parent = nullptr);
    // In the same file as another keeper, which reports what becomes of it.
    LedgerKeeper(EncoderBus &bus, const LedgerKeeper &other, QObject *parent = nullptr);
    ~LedgerKeeper() override;

    // What places count for: the file of the project; empty: none. A link to a file counts as that file.
    void setProject(const QString &file);
    // The open project is now in another file, or in its first one: the encoders are the same, and what was
    // counted by their places counts there as well.
    void projectSavedAs(const QString &file);
    // The serial number typed from the label of the encoder there; empty: none.
    void setLabel(Place place, const QString &serialNumber);

    // What has to be reported about the file: damaged and put aside, or not usable.
    const std::optional<Message> &problem() const { return m_problem; }

    // Something was written that is not counted in the file.
    bool hasUncounted() const { return m_book->hasUncounted(); }

    const EncoderBus &bus() const { return m_bus; }
    const DatabasePlace &place() const { return m_book->place(); }
    // Null if Qt's driver for SQLite is missing.
    const Ledger *ledger() const { return m_book->ledger(); }
    EncoderIdentity identity(Place place) const;

Q_SIGNALS:
    // A mark of the budget was passed, or the file failed.
    void messaged(const codewheel::Message &message);

private:
    struct ByHand
    {
        qint64 id;
        Instant at{}; // of the last word
        ParameterValues sent{};
        int awaited = 0; // typed writes that have not ended
        int planned = 0; // writes, at most
        int counted = 0;
        int inDoubt = 0; // typed writes without an answer
    };
    struct ToStranger // a write typed for a place without a session
    {
        qint64 id;
        std::optional<QByteArray> awaited;
    };
    struct Doubtful // a job that ended out of sight, until what it sent is read
    {
        qint64 id;
        Outcome outcome;
        Instant at{};
    };
    struct Watched
    {
        QPointer<EncoderSession> encoder;
        EncoderIdentity identity;
        std::optional<qint64> job{}; // its entry, while it runs
        Progress progress{};         // of the job
        std::optional<ByHand> byHand{};
        std::optional<Doubtful> doubtful{};
        std::vector<qint64> unassigned{};  // entries of an encoder that has not reported a serial number
        std::vector<qint64> beforeItMet{}; // likewise, before the link was lost: perhaps of another encoder
    };

    void listenToBook();
    void watchBus();
    void watchDevices();
    void watch(Place place);
    void watchNamed(Place place);
    void doubtUnassigned();
    void leaveToPrevious(Place place);
    void meetAgain();
    void isSame(Place place);
    void isAnother(Place place);
    void leaveCountToPrevious(Place place);
    void move(Place from, Place to);
    void begin(Place place, const Job &job);
    std::optional<qint64> beginEntry(Watched &watched, int planned);
    std::optional<qint64> beginDoubtful(Watched &watched, int perhaps);
    void planToRestore(Place place);
    void count(Place place, int writes);
    void settle(Place place, const Outcome &outcome);
    void settleDoubtful(Place place);
    // That it has while it has no serial number.
    EncoderIdentity ofPlace(Place place) const
    {
        return {
            .by = CountedBy::place, .vendor = {}, .serialNumber = {}, .project = m_project, .place = place};
    }
    void identify(Place place);
    void attribute(Watched &watched);
    std::map<Place, std::vector<qint64>> onTheirWay() const;
    void takeAlong(const QString &from);
    void showCount(Place place);
    void tellOtherSerialNumber(Place place, const EncoderIdentity &reported);
    int writesBeforeItMet(Place place) const;
    void addDoubtOfPlace(EepromCount &count, Place place) const;
    void doubtWhatWasToPrevious(EepromCount &count, Place place) const;
    void addDoubtOfQuestion(EepromCount &count, const EncoderSession &encoder) const;
    Ledger::Entry entryAt(const Watched &watched) const;
    void note(Watched &watched, qint64 id);
    void warn(Place place, int before);

    // ledger_keeper_by_hand.cpp
    void beginByHand(Place place, Word word);
    void beginTyped(const TypedWrite &write);
    void beginToStranger(const TypedWrite &write);
    ByHand *byHand(Watched &watched, int planned);
    void loseByHand(Place place, Watched &watched);
    void settleByHand();
    void settleByHand(Place place, Watched &watched);
    void settleTyped(const TypedWrite &write, TypedEnd end);
    void settleToStranger(const TypedWrite &write, TypedEnd end);
    void noteWhatWasToStranger(Place place);
    bool standsStill(Place place, const EncoderSession &encoder) const;

    EncoderBus &m_bus;
    std::shared_ptr<SafeLedger> m_book; // shared by all that keep the same file
    std::optional<Message> m_problem;
    QString m_project;
    struct Label
    {
        QString serialNumber{};    // empty: none
        QString project{};         // that says so
        bool isOfPrevious = false; // another encoder is there by now
    };
    struct ToPrevious // what was written at a place before another encoder was there
    {
        QString project{}; // that the place is counted in
        EepromCount count{};
    };
    std::map<Place, Label> m_labels;
    std::map<Place, ToPrevious> m_toPrevious;
    std::map<Place, Watched> m_watched;
    std::map<Place, std::vector<ToStranger>> m_strangers;
};

// For the current buses.
using FindLedgers = std::function<std::vector<const LedgerKeeper *>()>;

} // namespace codewheel
