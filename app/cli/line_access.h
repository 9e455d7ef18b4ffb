// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/line_link.h"
#include "journal/ledger_keeper.h"
#include "line/byte_link.h"
#include "line/line_session.h"

#include <functional>
#include <memory>

namespace codewheel {

// The serial line of a call. It is opened, in Watch, when it is first needed. A simulated line has virtual
// time, so that whatever it does is there at once; a real one takes its time.
class LineAccess
{
public:
    // How much time passes on a line between two looks at it.
    static constexpr Instant lookInterval = std::chrono::milliseconds(10);

    // The catalog must outlive it.
    LineAccess(std::unique_ptr<ByteLink> link, LineLink settings, const Catalog &catalog);

    // To the port that is named, or to a new simulated line.
    static LineAccess to(const LineLink &link, const Catalog &catalog);

    LineSession &bus() const { return *m_session; } // opened or not
    Checked<LineSession *> session();
    // Counts EEPROM writes, in a file or where the link's are counted.
    void keepLedger(const std::optional<QString> &file);
    LedgerKeeper *ledger() const { return m_ledger.get(); } // null: none is kept
    const LineLink &link() const { return m_link; }
    esc::ExplainOptions explainOptions() const { return m_link.explainOptions(); }

    // The encoder at the address, polled as this device of the catalog, and in contact: it shows where it
    // stands, and has told its serial number if it knows one. Refused where none answers.
    Checked<EncoderSession *> encoder(LineAddress address, const QString &deviceKey);

    // What an encoder tells of its version, which is asked for with its identity; empty: nothing.
    QString versionOf(const EncoderSession &encoder);
    // Lets time pass on the line, at most until the port is gone. False: it is gone.
    bool advance(Instant duration);
    // The port for programs; "training" of the simulated line.
    QString portKey() const;
    bool isConnected() const { return m_session->latest().connected; }
    Complaint portLost() const; // why it is gone
    // Of those that came until now: neither answers nor echo.
    std::uint64_t strayBytes() const;
    QString strayBytesText() const; // how many, and what that can mean; empty where none came
    // About a job that was refused, and about the port where it is gone.
    Complaint complaint(const Refusal &why) const;

private:
    Checked<EncoderSession *> contact(EncoderSession *encoder);
    Complaint noAnswerFrom(LineAddress address) const;
    Checked<void> determineFractionBits(Place number);
    bool waitUntil(const std::function<bool()> &isDone, Instant atMost);

    LineLink m_link;
    std::unique_ptr<LineSession> m_session;
    std::unique_ptr<LedgerKeeper> m_ledger;
    std::shared_ptr<Refusal> m_lost; // what the port said when it was gone
};

} // namespace codewheel
