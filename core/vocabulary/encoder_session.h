// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/capabilities.h"
#include "vocabulary/eeprom_count.h"
#include "vocabulary/event.h"
#include "vocabulary/freshness.h"
#include "vocabulary/kind_data.h"
#include "vocabulary/known_before.h"
#include "vocabulary/place.h"
#include "vocabulary/shown_values.h"

#include <QDateTime>
#include <QObject>

#include <optional>
#include <utility>

namespace codewheel {

struct DeviceDescription;

// One encoder in terms of its meaning, whatever bus it is on: what it can do, what is known of it, what it
// shows, and the jobs it is given. Views talk to this and to nothing below it. Lives in the thread of the
// window (or of the command line).
class EncoderSession : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    virtual Place place() const = 0;
    virtual const DeviceDescription &device() const = 0;
    virtual const Capabilities &can() const = 0;

    virtual const Reading &latest() const = 0;
    // Since when it has shown the same; empty: not known. A bus that cannot tell whether it still runs shows
    // the same for ever.
    virtual std::optional<Instant> unchangedSince() const { return {}; }
    // Whether the position it shows can be taken as the encoder's.
    virtual bool showsPosition() const { return latest().showsPosition(); }
    // Whether the outcomes of its jobs give the positions before and after, confirmed by several reads: a
    // single read may be corrupted.
    virtual bool agreesOnPositions() const { return false; }
    // What its values leave open and a setting decides, as its protocol knows it; for valueText(). Empty:
    // they follow from its description alone.
    virtual KindData valueOptions() const { return {}; }
    // Whether that is still current.
    const Freshness &freshness() const { return m_freshness; }
    virtual std::optional<Known> known(Parameter parameter) const = 0;
    // A cam program the encoder is known to have, 1..8.
    virtual std::optional<KnownCams> cams(unsigned program) const = 0;
    // What this program has written, and the encoder has taken without a run, or perhaps has, in words; run
    // makes it valid. Empty: nothing.
    virtual QString takenWithoutRun() const { return {}; }
    // Whether that is cam programs, and nothing else.
    virtual bool hasTakenCams() const { return false; }
    // The mode a job that was cut off has left it in, as long as it is not back in position mode. Empty:
    // none.
    virtual std::optional<LeftMode> leftInMode() const { return {}; }
    // The encoder's hardware and software version, in words; empty: not reported.
    virtual QString version() const { return {}; }
    // The user says what the encoder has, e.g. from its papers.
    virtual void tell(Parameter parameter, const std::optional<Value> &value) = 0;

    // The steps of these jobs, one after the other, as far as they are known beforehand: from what is in OUT,
    // the mode the encoder is in, and what is known of it. Refused like the jobs themselves if the input is
    // bad.
    virtual Result<std::vector<Step>> planned(const std::vector<Job> &jobs) const = 0;
    // At most one job at a time. The result says only whether the job was accepted; finished() says how it
    // ended.
    virtual Result<JobId> start(const Job &job, Pace pace = Pace::byItself) = 0;
    virtual std::optional<JobId> runningJob() const = 0;
    virtual void proceed() = 0;
    virtual void cancel(OnCancel how) = 0;

    // What was known of the encoder at this place before; kept by journal/known_keeper.h. Empty: nothing, or
    // it is settled whether it is the same encoder.
    const std::optional<KnownBefore> &knownBefore() const { return m_before; }
    // Without one: the encoder is another.
    void setKnownBefore(const std::optional<KnownBefore> &before)
    {
        const bool wasAsked = m_before.has_value();
        m_before = before && !before->values.empty() ? before : std::nullopt;
        if (wasAsked && !m_before)
            Q_EMIT isAnotherThanBefore();
        Q_EMIT knownBeforeChanged();
    }
    // It is the same encoder: what it had then it has now, unless that is known anew. Sends nothing.
    void takeKnownBefore()
    {
        const auto before = std::exchange(m_before, std::nullopt);
        if (!before)
            return;
        takeOver(*before);
        Q_EMIT isSameAsBefore();
        Q_EMIT knownBeforeChanged();
        Q_EMIT knownChanged();
    }

    // EEPROM writes by this program since this session began.
    virtual int eepromWrites() const = 0;
    // The same over all sessions, where a ledger is kept (journal/ledger_keeper.h, which sets it).
    EepromCount eepromCount() const { return m_count.value_or(EepromCount{.writes = eepromWrites()}); }
    void setEepromCount(const EepromCount &count)
    {
        if (m_count == count)
            return;
        m_count = count;
        Q_EMIT eepromCountChanged();
    }

    // The date and time of a reading or a known value.
    virtual QDateTime dateTime(Instant at) const = 0;

Q_SIGNALS:
    void latestChanged(); // a newer reading, possibly with the same content; at most once a frame
    // Everything it showed since the last frame, every cycle or answer, oldest first.
    void shown(const codewheel::ShownSeries &values);
    void freshnessChanged(); // live, old or unknown, or the reason for it
    void knownChanged();
    void knownBeforeChanged();
    // Whether it is the one of which that was known is settled; before knownBeforeChanged().
    void isSameAsBefore();
    void isAnotherThanBefore();
    // The encoder stored to its EEPROM this many times because of what this program sent.
    void eepromWritten(int writes);
    void eepromCountChanged();
    void permissionChanged(); // Watch or Operate, started or stopped: start() may accept what it refused
    // Before anything of it is sent, for the ledger of EEPROM writes: an accepted job; the previous values,
    // which a cancelled job writes again; a word sent by hand that was allowed.
    void jobAboutToStart(const codewheel::Job &job);
    void restoreAboutToStart();
    void wordAboutToBeSent(codewheel::Word word);
    void jobStarted(codewheel::JobId job);
    void progressed(const codewheel::Progress &progress);
    void finished(const codewheel::Outcome &outcome);
    void exchanged(const codewheel::Exchange &row);

protected:
    void setFreshness(const Freshness &freshness)
    {
        const Freshness before = std::exchange(m_freshness, freshness);
        if (!before.isSameStateAs(freshness))
            Q_EMIT freshnessChanged();
    }

private:
    virtual void takeOver(const KnownBefore & /*before*/) {}

    Freshness m_freshness;
    std::optional<EepromCount> m_count;
    std::optional<KnownBefore> m_before;
};

// Empty: not known, or a text.
inline std::optional<std::int64_t> knownNumber(const EncoderSession &encoder, Parameter parameter)
{
    const auto known = encoder.known(parameter);
    return known ? known->value.asNumber() : std::nullopt;
}

// The serial number that the encoder has reported. Empty: it has not, or reports 0 as one does that was given
// none: that identifies nobody.
inline std::optional<std::int64_t> reportedSerialNumber(const EncoderSession &encoder)
{
    const auto known = encoder.known(Parameter::serialNumber);
    return known && known->evidence == Evidence::read && known->value != 0 ? known->value.asNumber()
                                                                           : std::nullopt;
}

inline KindData valueOptionsOf(const EncoderSession *encoder)
{
    return encoder != nullptr ? encoder->valueOptions() : KindData();
}

// Somebody says that the encoder is in position mode: none reports its mode.
inline void tellPositionMode(EncoderSession &encoder)
{
    constexpr std::int64_t startsUpAsK3 = 1; // read-out 9, FRABA manual 10.2
    encoder.tell(Parameter::startUpMode, startsUpAsK3);
}

} // namespace codewheel
