// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/job_review.h"

class QLabel;

namespace codewheel {

class NowAndThen;

// The review before a position is set by a command that carries it: what the encoder shows, and what it will
// show.
class PresetReview final : public JobReview
{
    Q_OBJECT

public:
    explicit PresetReview(QWidget *parent = nullptr);

    void review(EncoderSession &encoder, std::int64_t position); // in steps

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    Contents contents(const EncoderSession &encoder, bool writesAll) const override;

    QLabel *m_change; // in words, as the first
    NowAndThen *m_picture;
    std::int64_t m_position = 0;
};

} // namespace codewheel
