// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/age_text.h"

#include "bus/not_live.h"
#include "bus/word_channel.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/freshness_text.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// The context of these texts.
struct AgeText
{
    Q_DECLARE_TR_FUNCTIONS(AgeText)
};

// What a recording shows is of a date, however long ago that is.
QString whenText(const NotLive &old)
{
    return old.reason == Freshness::Reason::recorded ? recordedText(old.seen)
                                                     : agoText(old.seen, QDateTime::currentDateTime());
}

template <typename Shown>
QString ageOf(const Shown &shown)
{
    const Freshness &freshness = shown.freshness();
    return freshness.isOld() ? whenText({freshness.reason(), shown.dateTime(freshness.seen())}) : QString();
}

} // namespace

QString ageText(const EncoderSession &encoder)
{
    return ageOf(encoder);
}

QString ageText(const WordChannel &word)
{
    return ageOf(word);
}

QString ageSentence(const EncoderSession &encoder)
{
    const Freshness &freshness = encoder.freshness();
    return freshness.isOld() ? ageSentence({freshness.reason(), encoder.dateTime(freshness.seen())})
                             : QString();
}

QString outOfSightReason(const EncoderSession &encoder)
{
    const Freshness &freshness = encoder.freshness();
    const bool isOnlyLate =
        freshness.reason() == Freshness::Reason::unsettled || Freshness::isOnlyNotAsked(freshness.reason());
    return freshness.isOld() && !isOnlyLate ? freshnessText(freshness.reason()) : QString();
}

QString unchangedSentence(const EncoderSession &encoder)
{
    const auto since = encoder.freshness().isLive() ? encoder.unchangedSince() : std::nullopt;
    const QString moment =
        since ? unchangedText(encoder.dateTime(*since), encoder.dateTime(encoder.latest().at)) : QString();
    return moment.isEmpty() ? QString() : AgeText::tr("It has shown the same since %1.", "14:02").arg(moment);
}

QString ageSentence(const NotLive &old)
{
    const QString why = freshnessText(old.reason);
    if (old.reason == Freshness::Reason::recorded)
        return AgeText::tr("%1 Shown is how it was on %2.", "reason, date and time").arg(why, whenText(old));
    return old.seen.isValid()
               ? AgeText::tr("%1 Shown is how it was %2.", "reason, 20 s ago").arg(why, whenText(old))
               : why;
}

} // namespace codewheel
