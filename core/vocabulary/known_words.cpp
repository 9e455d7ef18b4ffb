// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/known_words.h"

#include <QCoreApplication>

namespace codewheel::known_words {
namespace {

// The context of these texts.
struct KnownWords
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::KnownWords)
};

} // namespace

QString word(Evidence evidence)
{
    switch (evidence) {
    case Evidence::read:
        return KnownWords::tr("read");
    case Evidence::echoed:
        return KnownWords::tr("confirmed");
    case Evidence::told:
        break;
    }
    return KnownWords::tr("by hand");
}

QString word(const std::optional<Known> &known)
{
    return known ? word(known->evidence) : KnownWords::tr("unknown");
}

QString explanation(const std::optional<Known> &known, bool reads)
{
    if (!known)
        return reads ? KnownWords::tr("Not known: read it from the encoder.")
                     : KnownWords::tr(
                           "Not known, and the encoder cannot be read: set it manually, or write it.");
    switch (known->evidence) {
    case Evidence::read:
        return KnownWords::tr("It was read from the encoder.");
    case Evidence::echoed:
        return reads ? KnownWords::tr("Confirmed in a handshake, but not read back since: read it.")
                     : KnownWords::tr("Confirmed in a handshake; the encoder cannot be read.");
    case Evidence::told:
        break;
    }
    return reads ? KnownWords::tr("Set manually or by the plan of the bus, not by the encoder: read it.")
                 : KnownWords::tr("Set manually or by the plan of the bus; the encoder cannot be read.");
}

} // namespace codewheel::known_words
