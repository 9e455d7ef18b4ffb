// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/known_words.h"

#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>

#include <array>

namespace codewheel::known_words {
namespace {

struct KeptRow
{
    Kept id;
    const char *word;
    const char *sentence;
};

struct KnownWords
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::KnownWords)
    using enum Kept;

public:
    static constexpr auto all = std::to_array<KeptRow>({
        {byItself, nullptr, nullptr},
        {notKnown, nullptr, QT_TR_NOOP("Whether it is stored is not known.")},
        {untilPowerOff, QT_TR_NOOP("not stored"),
         QT_TR_NOOP("It is not stored: without supply the encoder loses it.")},
        {stored, QT_TR_NOOP("stored"), QT_TR_NOOP("It is stored: the encoder keeps it without supply.")},
    });
    static QString orNone(const char *text) { return text != nullptr ? tr(text) : QString(); }
};
static_assert(areInOrder(KnownWords::all, &KeptRow::id, Kept::stored));

QString howItBecameKnown(const Known &known, bool reads)
{
    switch (known.evidence) {
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

QString word(Kept kept)
{
    return KnownWords::orNone(rowOf(KnownWords::all, kept).word);
}

QString word(Evidence evidence, Kept kept)
{
    const QString isKept = word(kept);
    return isKept.isEmpty() ? word(evidence) : QStringLiteral("%1, %2").arg(word(evidence), isKept);
}

QString word(const std::optional<Known> &known)
{
    return known ? word(known->evidence, known->kept) : KnownWords::tr("unknown");
}

QString explanation(const std::optional<Known> &known, bool reads)
{
    if (!known)
        return reads ? KnownWords::tr("Not known: read it from the encoder.")
                     : KnownWords::tr(
                           "Not known, and the encoder cannot be read: set it manually, or write it.");
    return QStringLiteral("%1 %2")
        .arg(howItBecameKnown(*known, reads),
             KnownWords::orNone(rowOf(KnownWords::all, known->kept).sentence))
        .trimmed();
}

} // namespace codewheel::known_words
