// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_range_bar.h"

#include "cams/check_cams.h"
#include "vocabulary/sentence.h"
#include "widgets/cams/cam_texts.h"
#include "widgets/cams/position_input.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"

#include <QPushButton>

namespace codewheel {
namespace {

QString complaint(const RefusalArgument &given)
{
    return CamRangeBar::tr("The largest position cannot be %1. Give a number from 1 to %2.")
        .arg(argumentText(given), cam_texts::position(largestCamPosition));
}

} // namespace

CamRangeBar::CamRangeBar(QWidget *parent)
    : QWidget(parent)
    , m_text(wrappedLabel(this))
    , m_read(new QPushButton(lineIcon(Icon::read), tr("Read &it"), this))
    , m_largest(new PositionInput(1, largestCamPosition, complaint, this))
    , m_tell(new QPushButton(tr("&Use it"), this))
{
    m_read->setToolTip(
        tr("Reads steps and revolutions. That sends words, and hides the position for some cycles."));
    describe(m_largest, tr("Largest position"),
             tr("Total range - 1, from the encoder's papers; decimal, or hexadecimal as 0x.. or ..h"));
    m_largest->setPlaceholderText(tr("largest position"));
    m_largest->setMaximumWidth(35 * grid::unit);
    m_tell->setToolTip(tr("Uses the largest position as given; nothing is sent"));
    layOutRow(this, {{m_text, 1}, m_read, m_largest, m_tell},
              {.spacing = grid::margin, .margins = QMargins()});
    connect(m_read, &QPushButton::clicked, this, &CamRangeBar::readRequested);
    connect(m_tell, &QPushButton::clicked, this, &CamRangeBar::tell);
    connect(m_largest, &QLineEdit::returnPressed, this, &CamRangeBar::tell);
    connect(m_largest, &PositionInput::inputChecked, this, &CamRangeBar::inputChecked);
}

void CamRangeBar::begin(std::optional<std::int64_t> toldLargest)
{
    m_largest->setText(toldLargest ? QString::number(*toldLargest) : QString());
}

void CamRangeBar::ask(bool canRead, std::optional<std::int64_t> toldLargest)
{
    m_read->setVisible(canRead);
    if (toldLargest)
        m_text->setText(tr("The positions go up to %1, set manually; the encoder was not asked.")
                            .arg(cam_texts::position(*toldLargest)));
    else
        m_text->setText(tr("The number of positions is not known."));
    show();
}

void CamRangeBar::tell()
{
    const auto largest = m_largest->value();
    if (largest)
        Q_EMIT told(*largest);
}

} // namespace codewheel
