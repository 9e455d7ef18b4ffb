// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/scale_preview.h"

#include "widgets/dial/code_disc.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"

#include <QLabel>
#include <QLineEdit>

#include <cmath>

namespace codewheel {
namespace {

constexpr int leastDial = 190; // px: with it the page fits the smallest window

} // namespace

ScalePreview::ScalePreview(QWidget *parent)
    : QWidget(parent)
    , m_dial(new CodeDisc(this))
    , m_turns(describe(new DecimalField(this), "previewTurns", tr("Turns from here"),
                       tr("Imagine the shaft turned clockwise by so much; negative: counter-clockwise.")))
{
    auto *title = new QLabel(tr("Will read, &after turns from here:"), this);
    title->setWordWrap(true);
    title->setBuddy(m_turns);
    m_dial->setAccessibleName(tr("Dial with the wanted values"));
    m_dial->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
    m_dial->setMinimumHeight(leastDial);
    m_dial->setMaximumHeight(m_dial->sizeHint().height());
    m_turns->setFont(numberFont());
    m_turns->setAlignment(Qt::AlignRight);
    m_turns->setRange(-4096, 4096);
    m_turns->setDecimals(2);
    m_turns->setSingleStep(0.25);
    layOutColumn(this, {title, m_turns, {m_dial, 1}, Stretch{}},
                 {.spacing = grid::unit, .margins = QMargins()});
    connect(m_turns, &QDoubleSpinBox::valueChanged, this, &ScalePreview::draw);
    connect(m_turns->findChild<QLineEdit *>(), &QLineEdit::textChanged, this, &ScalePreview::draw);
}

void ScalePreview::setScale(const std::optional<PositionScale> &scale, std::optional<std::int64_t> start,
                            const QString &whyNot)
{
    m_scale = scale;
    m_start = start;
    m_whyNot = whyNot;
    draw();
}

void ScalePreview::draw()
{
    DialState state;
    const QString wrong = m_turns->complaint();
    if (m_scale && m_start && wrong.isEmpty()) {
        const std::int64_t position = positionAfterTurns(*m_scale, *m_start, m_turns->value());
        const double turns = static_cast<double>(position) / m_scale->resolution();
        state.position = position;
        state.turn = static_cast<qint64>(std::floor(turns));
        state.turnFraction = partOfTurn(turns, m_scale->clockwise);
    } else {
        state.note = wrong.isEmpty() ? m_whyNot : wrong;
    }
    m_dial->setState(state);
}

} // namespace codewheel
