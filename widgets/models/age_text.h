// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

class EncoderSession;
class WordChannel;
struct NotLive;

// The age of what is shown, in wall clock time: "20 s ago". Empty while it is live or unknown.
QString ageText(const EncoderSession &encoder);
QString ageText(const WordChannel &word);

// With the reason: "The bus does not run. Shown is how it was 20 s ago." Empty while it is live or unknown.
QString ageSentence(const EncoderSession &encoder);
QString ageSentence(const NotLive &old);

// Why what it has now is not known: "The link is lost."; empty: it is seen, or only comes late.
QString outOfSightReason(const EncoderSession &encoder);

// Since when what is live has been the same: "It has shown the same since 14:02."; empty for less than 10 s.
QString unchangedSentence(const EncoderSession &encoder);

} // namespace codewheel
