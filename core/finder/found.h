// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "serial/serial_settings.h"
#include "vocabulary/kind_data.h"
#include "vocabulary/refusal.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace codewheel {

// How sure it is that somebody is there as told.
enum class Certainty : std::uint8_t {
    certain, // it answered in a way that chance does not give: a check sum, or two answers alike
    likely,  // one sign of it
};
QString certaintyKey(Certainty certainty); // language-neutral: "certain"
QString certaintyText(Certainty certainty);

// Somebody at a port or host, and how to connect there.
struct Found
{
    QString kind{};     // of its bus, as in projects: "esc"
    QString place{};    // "/dev/ttyUSB0", "192.168.0.5:502"
    QString settings{}; // "9600 Bd, 8N2"; empty: it has none
    QString sentence{}; // who it is
    Certainty certainty = Certainty::certain;
    // A master works there: only listen, or use the place once it has gone.
    bool isMasterAtWork = false;
    KindData plan{};   // of the link, as its kind plans it
    QString link{};    // as typed for the command line: "esc:/dev/ttyUSB0,baud=9600"
    KindData device{}; // as its kind knows who it is; empty: it does not

    friend bool operator==(const Found &, const Found &) = default;
};

// What the finder did last.
struct FinderNews
{
    enum class Kind : std::uint8_t {
        looking, // what it does; replaced by the next one
        heard,   // something that says how to go on
        found,
        refused, // the place cannot be used
        nobody,  // all was tried
    };

    Kind kind = Kind::looking;
    QString place{};
    QString sentence{};
    std::optional<Found> found{};
    bool isSilent = false;        // of `nobody`: nothing came while it was listened to
    std::optional<Refusal> why{}; // of `refused`

    friend bool operator==(const FinderNews &, const FinderNews &) = default;
};

FinderNews refusedNews(const QString &place, const Refusal &why);

QString formatText(const SerialSettings &settings); // "9600 Bd, 8N2"

} // namespace codewheel
