// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/shaft_dial.h"

#include "widgets/dial/code_disc.h"
#include "widgets/dial/missing_values.h"
#include "widgets/dial/printed_dial.h"
#include "widgets/models/age_timer.h"

#include <QVBoxLayout>

namespace codewheel {

ShaftDial::ShaftDial(QWidget *parent)
    : QWidget(parent)
    , m_age(new AgeTimer(this))
    , m_disc(new CodeDisc(this))
    , m_missing(new MissingValues({shaftValues.begin(), shaftValues.end()}, this))
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_disc, 1);
    column->addWidget(m_missing);
    connect(m_missing, &MissingValues::changed, this, &ShaftDial::knownChanged);
    connect(m_age, &QTimer::timeout, this, &ShaftDial::draw);
}

void ShaftDial::setEncoder(EncoderSession *encoder)
{
    if (m_encoder != nullptr)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    if (encoder != nullptr) {
        m_disc->setPlace(encoder->place().shown());
        connect(encoder, &EncoderSession::latestChanged, this, &ShaftDial::draw);
        connect(encoder, &EncoderSession::freshnessChanged, this, &ShaftDial::draw);
    }
    m_missing->setEncoder(encoder);
}

std::optional<PrintedView> ShaftDial::printedView() const
{
    if (m_encoder == nullptr)
        return {};
    DialState state = m_disc->state();
    state.note.clear(); // stands among the values
    CodeDisc onPaper;
    onPaper.setForPaper();
    onPaper.setState(state);
    return printedDial(*m_encoder, drawnOnPaper(onPaper, onPaper.sizeHint()), m_disc->values(), shaftValues);
}

void ShaftDial::knownChanged()
{
    m_scale = shaftScale(*m_encoder);
    draw();
}

void ShaftDial::draw()
{
    if (m_encoder == nullptr)
        return;
    m_age->follow(*m_encoder);
    m_disc->setState(shaftState(*m_encoder, m_scale, m_missing->names()));
}

} // namespace codewheel
