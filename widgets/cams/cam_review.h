// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/job_review.h"

class QComboBox;

namespace codewheel {

// Of the cam editor: the words in their order, beside those that read, and in which mode the encoder is left.
// What the encoder is known to have is left out unless all is to be written, and none is left where nothing
// is to be written. A program that is not known is written as far as it turns out to differ.
class CamReview final : public JobReview
{
    Q_OBJECT

public:
    enum Column { programColumn, wordColumn, meaningColumn, oldColumn };

    explicit CamReview(QWidget *parent = nullptr);

    // before: the mode the encoder is in, or is to be left in as was answered.
    void review(EncoderSession &encoder, const std::vector<CamProgram> &programs, const SwitchMode &before);

private:
    Contents contents(const EncoderSession &encoder, bool writesAll) const override;
    void offerAfterwards(const SwitchMode &before);

    std::vector<CamProgram> m_programs;
    std::vector<SwitchMode> m_choices; // beside the entries of m_afterwards
    QLabel *m_title;
    QLabel *m_afterwardsLabel;
    QComboBox *m_afterwards;
};

} // namespace codewheel
