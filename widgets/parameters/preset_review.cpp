// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/preset_review.h"

#include "encoder/sentence.h"
#include "widgets/parameters/position_to_set.h"

#include <QHeaderView>
#include <QTableView>

#include <cmath>

namespace codewheel {
namespace {

QString shownText(const EncoderSession &encoder)
{
    return encoder.showsPosition() ? numberText(*encoder.latest().position) : PresetReview::tr("not known");
}

QStringList notesOf(const EncoderSession &encoder)
{
    QStringList notes{positionToSetText(encoder)};
    if (!encoder.showsPosition())
        notes << PresetReview::tr("Which position it shows now is not known.");
    else if (std::abs(encoder.latest().stepsPerSecond.value_or(0)) >= 1)
        notes << PresetReview::tr("The encoder moves: the place that gets this position is where it stands "
                                  "when the command arrives.");
    return notes;
}

} // namespace

PresetReview::PresetReview(QWidget *parent)
    : JobReview("confirmPreset", parent)
{
    offerToWriteAll(false);
}

void PresetReview::review(EncoderSession &encoder, std::int64_t position)
{
    using Kind = ReviewColumn::Kind;
    m_position = position;
    begin(encoder, {{{}}, {tr("Old"), Kind::value}, {tr("New"), Kind::value}},
          tr("Sets the position, where the encoder stands now"));
    table().horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
}

JobReview::Contents PresetReview::contents(const EncoderSession &encoder, bool) const
{
    return {.job = SetPreset{.value = m_position},
            .rows = {{.cells = {tr("Position of %1").arg(encoder.place().shown()), shownText(encoder),
                                numberText(m_position)}}},
            .notes = notesOf(encoder),
            .write = tr("&Set this position")};
}

} // namespace codewheel
