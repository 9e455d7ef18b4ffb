// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/preset_review.h"

#include "vocabulary/sentence.h"
#include "widgets/dial/now_and_then.h"
#include "widgets/job/known_text.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/parameters/position_to_set.h"

#include <QHideEvent>

namespace codewheel {
namespace {

QString shownText(const EncoderSession &encoder)
{
    return encoder.showsPosition() ? numberText(*encoder.latest().position) : PresetReview::tr("not known");
}

} // namespace

PresetReview::PresetReview(QWidget *parent)
    : JobReview("confirmPreset", parent)
    , m_change(wrappedLabel(this, "positionChange"))
    , m_picture(new NowAndThen(this))
{
    m_picture->hide();
    addTitle(m_change);
    showInstead(m_picture);
    offerToWriteAll(false);
}

void PresetReview::review(EncoderSession &encoder, std::int64_t position)
{
    using Kind = ReviewColumn::Kind;
    m_position = position;
    m_picture->setEncoder(encoder);
    m_picture->setThen(position);
    begin(encoder, {{{}}, {tr("Old"), Kind::value}, {tr("New"), Kind::value}},
          tr("Sets the position, where the encoder stands now"));
}

// A hidden page of the panel claims its height, too.
void PresetReview::showEvent(QShowEvent *event)
{
    m_picture->show();
    JobReview::showEvent(event);
}

void PresetReview::hideEvent(QHideEvent *event)
{
    JobReview::hideEvent(event);
    if (!event->spontaneous())
        m_picture->hide();
}

JobReview::Contents PresetReview::contents(const EncoderSession &encoder, bool) const
{
    m_change->setText(tr("Position of %1: now %2, then %3.")
                          .arg(encoder.place().shown(), shownText(encoder), numberText(m_position)));
    return {.job = SetPreset{.value = m_position},
            .rows = {{.cells = {tr("Position of %1").arg(encoder.place().shown()), shownText(encoder),
                                numberText(m_position)}}},
            .notes = movementTexts(encoder) << positionToSetText(encoder),
            .write = tr("&Set this position")};
}

} // namespace codewheel
