// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/job_review.h"

namespace codewheel {

// The review of the parameter panel: parameter, old, new, word.
class WriteReview final : public JobReview
{
    Q_OBJECT

public:
    explicit WriteReview(QWidget *parent = nullptr);

    void review(EncoderSession &encoder, const ParameterValues &wanted);

private:
    Contents contents(const EncoderSession &encoder, bool writesAll) const override;

    ParameterValues m_wanted;
};

} // namespace codewheel
