// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/age_text.h"

#include "bus/not_live.h"
#include "bus/word_channel.h"
#include "encoder/encoder_session.h"
#include "encoder/freshness_text.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// The context of these texts.
struct AgeText
{
    Q_DECLARE_TR_FUNCTIONS(AgeText)
};

template <typename Shown>
QString ageOf(const Shown &shown)
{
    const Freshness &freshness = shown.freshness();
    return freshness.isOld() ? agoText(shown.dateTime(freshness.seen()), QDateTime::currentDateTime())
                             : QString();
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

QString ageSentence(const NotLive &old)
{
    const QString why = freshnessText(old.reason);
    return old.seen.isValid() ? AgeText::tr("%1 Shown is how it was %2.", "reason, 20 s ago")
                                    .arg(why, agoText(old.seen, QDateTime::currentDateTime()))
                              : why;
}

} // namespace codewheel
