// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

#include <QJsonObject>
#include <QString>

#include <optional>

namespace codewheel {

// The mode an encoder shows, as far as it is known.
LeftMode modeShown(const EncoderSession &encoder);

// In which mode a call has left an encoder, after its last job.
struct ModeLeft
{
    LeftMode before{}; // before the call
    LeftMode now{};
    bool isAnother = false;    // or may be, where neither is known
    bool hasFailed = false;    // that job
    bool isOutOfSight = false; // so nobody sees the mode any more

    QString toText() const; // in a sentence
    void addTo(QJsonObject &json) const;
};

// `atStart`: in which mode the job found it.
ModeLeft modeLeft(const EncoderSession &encoder, const Outcome &outcome, const LeftMode &before,
                  const LeftMode &atStart);

} // namespace codewheel
