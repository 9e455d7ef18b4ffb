// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/device_number.h"
#include "encoder/freshness.h"
#include "encoder/refusal.h"
#include "ring/snapshot.h"

#include <QDateTime>
#include <QObject>

#include <optional>

namespace codewheel {

class BusSession;

// The raw face of one cyclic device, for monitors: its words, and one staged OUT word that all its monitors
// share. Staging sends nothing; write() does.
class WordChannel : public QObject
{
    Q_OBJECT

public:
    WordChannel(BusSession &bus, std::size_t device, DeviceNumber number, int inWords, int outWords);

    DeviceNumber number() const { return m_number; }
    int inWords() const { return m_inWords; } // 16 bit each; 0: none
    int outWords() const { return m_outWords; }

    Word in() const { return m_in; }
    Word out() const { return m_out; }         // as it stands on the bus
    Word inEdges() const { return m_inEdges; } // bits that changed in any cycle since the last picture
    Word outEdges() const { return m_outEdges; }
    bool heldByJob() const { return m_heldByJob; }
    const Freshness &freshness() const { return m_freshness; } // of both words
    QDateTime dateTime(Instant at) const;

    std::optional<Word> staged() const { return m_staged; } // nothing: as on the bus
    Word shownOut() const { return m_staged.value_or(m_out); }
    void stage(Word word);
    void unstage();
    // Sends the staged word, or repeats the OUT word if none is staged. Refused (signal and answer) in Watch,
    // while the bus is stopped, while a job holds the word, and by a device without OUT; the staged word
    // stays. It is unstaged once it stands on the bus; the bus may still refuse it (signal) until then.
    Result<void> write();

Q_SIGNALS:
    void changed(); // in, out, edges, or whether they are live: at most once per picture
    void stagedChanged();
    void refused(const codewheel::Refusal &why);

private:
    friend class BusSession;
    void show(const Snapshot &ring, const Freshness::Circumstances &bus);
    void wasWritten(Word word, Instant at);
    void moveTo(std::size_t device) { m_device = device; } // the ring is another

    struct Written
    {
        Word word;
        Instant at;
    };

    BusSession &m_bus;
    std::size_t m_device;
    DeviceNumber m_number;
    int m_inWords;
    int m_outWords;
    Word m_in = 0;
    Word m_out = 0;
    Word m_inEdges = 0;
    Word m_outEdges = 0;
    bool m_heldByJob = false;
    Freshness m_freshness;
    std::optional<Word> m_staged;
    std::optional<Written> m_written; // told by the bus, not shown by a snapshot yet
};

} // namespace codewheel
