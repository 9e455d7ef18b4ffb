// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_mode_bar.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

namespace codewheel {

CamModeBar::CamModeBar(QWidget *parent)
    : QWidget(parent)
    , m_question(new QLabel(tr("The mode of the encoder is not known, and for this it is switched to cam "
                               "mode. Which mode should it be in afterwards?"),
                            this))
    , m_position(new QPushButton(tr("&Position mode"), this))
    , m_cams(new QPushButton(this))
    , m_cancel(new QPushButton(tr("&Cancel"), this))
{
    m_question->setWordWrap(true);
    describe(m_position, "afterwardsPosition", tr("IN shows the position again (20800000)"));
    describe(m_cams, "afterwardsCams", tr("Cam mode"), tr("IN goes on showing the cams"));
    m_cancel->setToolTip(tr("Nothing is sent (Esc)"));
    layOutColumn(
        this, {m_question, layOutRow({Stretch{}, m_position, m_cams, m_cancel}, {.spacing = grid::margin})},
        {.margins = QMargins()});
    connect(m_position, &QPushButton::clicked, this, [this] { answer({.mode = Mode::position}); });
    connect(m_cams, &QPushButton::clicked, this,
            [this] { answer({.mode = Mode::cam, .camProgram = m_program}); });
    connect(m_cancel, &QPushButton::clicked, this, &QWidget::hide);
    hide();
}

void CamModeBar::ask(unsigned program)
{
    m_program = program;
    m_cams->setText(tr("Cam &mode, program %1").arg(program));
    show();
    m_position->setFocus();
}

void CamModeBar::answer(const SwitchMode &afterwards)
{
    hide();
    Q_EMIT answered(afterwards);
}

void CamModeBar::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        hide();
    else
        QWidget::keyPressEvent(event);
}

} // namespace codewheel
