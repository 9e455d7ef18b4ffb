// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/found.h"
#include "serial/byte_link.h"

#include <atomic>
#include <memory>
#include <span>
#include <vector>

namespace codewheel {

// What came with a request besides its echo and its answer.
struct OtherBytes
{
    QByteArray all{};
    // Somebody else sends; otherwise it may be a damaged answer, or what a converter makes of a change of
    // direction.
    bool areStrangers = false;
};

// What one request brought.
struct Asked
{
    std::optional<Found> found{}; // who answered, once that is sure
    OtherBytes others{};
};

// So many bytes that make no sense may come whenever somebody begins or ends to send on RS-485.
inline constexpr qsizetype glitches = 2;

// Asks whoever may be on a line, one request per step; only reads. Each step has its settings, with which the
// link is opened before it, and the line was silent before it. Used by one thread.
class Asking
{
public:
    virtual ~Asking() = default;

    virtual bool isDone() const = 0;
    virtual SerialSettings settings() const = 0; // of the next step
    virtual QString doing() const = 0;           // what it will do: "asks address 05"
    // Refused as the link refuses.
    virtual Result<Asked> step(ByteLink &link, const std::atomic<bool> &isStopped) = 0;
};

// What may be spoken on a serial line, as the finder knows it. A kind of bus that is on serial lines adds its
// own.
class SpokenProtocol
{
public:
    virtual ~SpokenProtocol() = default;

    virtual QString name() const = 0; // "Kübler ESC"
    // Whether somebody may speak it at this port; `first`: nothing else is as likely there.
    enum class Fit : std::uint8_t { none, possible, first };
    virtual Fit fitsAt(const QString & /*port*/) const { return Fit::possible; }
    // With which it is usually spoken, the most usual first.
    virtual std::vector<SerialSettings> usualSettings() const = 0;
    // What others say with these settings, if it makes sense as this protocol; empty: it does not.
    virtual std::optional<Found> heard(const QString &place, const SerialSettings &settings,
                                       const QByteArray &bytes) const = 0;
    // What asking would send, for announcing it.
    virtual QString announcement() const = 0;
    virtual std::unique_ptr<Asking> ask(const QString &place) const = 0;
};

// The built-in ones, and any that were added.
std::vector<const SpokenProtocol *> spokenProtocols();
// Those that fit at this port, the likeliest first.
std::vector<const SpokenProtocol *> spokenProtocolsAt(const QString &port);
void addSpokenProtocol(std::unique_ptr<const SpokenProtocol> protocol);

} // namespace codewheel
