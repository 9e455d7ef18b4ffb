// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/cams/cam_review.h"

namespace codewheel {

// The words that the job will put into OUT, in this order, beside those that read: what the encoder is known
// to have is left out unless all is to be written, and none is left where nothing is to be written. A program
// that is not known is written as far as it turns out to differ. Refused as the job would be.
Result<std::vector<CamReviewRow>> camReviewRows(const EncoderSession &encoder, const WriteCams &job);

} // namespace codewheel
