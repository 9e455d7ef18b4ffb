// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/job_review.h"

class QComboBox;

namespace codewheel {

// The review of the cam editor: the words in order, between those that read, and the mode the encoder is left
// in. What the encoder is known to have is left out unless everything is to be written; with nothing to write
// there are no words. A program that is not known is written as far as it turns out to differ.
class CamReview final : public JobReview
{
    Q_OBJECT

public:
    enum Column { programColumn, wordColumn, meaningColumn, oldColumn };

    explicit CamReview(QWidget *parent = nullptr);

    // before: the mode the encoder is in, or the one the user chose to leave it in.
    void review(EncoderSession &encoder, const std::vector<CamProgram> &programs, const SwitchMode &before);

private:
    Contents contents(const EncoderSession &encoder, bool writesAll) const override;
    static QString nothingToWrite(const EncoderSession &encoder);
    void offerAfterwards(const SwitchMode &before);

    std::vector<CamProgram> m_programs;
    std::vector<SwitchMode> m_choices; // parallel to the entries of m_afterwards
    QLabel *m_title;
    QLabel *m_afterwardsLabel;
    QComboBox *m_afterwards;
};

} // namespace codewheel
