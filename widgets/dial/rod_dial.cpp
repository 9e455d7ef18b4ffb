// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/rod_dial.h"

#include "catalog/value_text.h"
#include "widgets/dial/missing_values.h"
#include "widgets/dial/printed_dial.h"
#include "widgets/dial/rod_reading.h"
#include "widgets/dial/rod_view.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/models/age_timer.h"
#include "widgets/parameters/value_field.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace codewheel {

namespace {

constexpr int widthOnPaper = 2 * RodPicture::usualWidth;

} // namespace

RodDial::RodDial(QWidget *parent)
    : QWidget(parent)
    , m_age(new AgeTimer(this))
    , m_rod(new RodView(this))
    , m_missing(new MissingValues({rodValues.begin(), rodValues.end()}, this))
    , m_readStatus(new QPushButton(lineIcon(Icon::read), tr("Read error &status"), this))
    , m_tellRow(new QWidget(this))
    , m_tell(new QPushButton(tr("&Set manually"), m_tellRow))
{
    describe(m_readStatus, "readErrorStatus",
             tr("Reads why the error bit is set. That clears it, once the magnet is back."));
    describe(m_tell, "tellRodLength", tr("Sets the length manually. Nothing is sent."));
    auto *row = new QGridLayout(m_tellRow);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(grid::unit);
    row->setColumnStretch(0, 1);
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addWidget(m_rod, 1);
    column->addWidget(m_missing);
    column->addWidget(m_readStatus, 0, Qt::AlignHCenter);
    column->addWidget(m_tellRow);
    connect(m_missing, &MissingValues::changed, this, &RodDial::knownChanged);
    connect(m_age, &QTimer::timeout, this, &RodDial::draw);
    connect(m_readStatus, &QPushButton::clicked, this, [this] { m_missing->read({Parameter::errorStatus}); });
    connect(m_tell, &QPushButton::clicked, this, &RodDial::tellLength);
}

void RodDial::setEncoder(EncoderSession *encoder)
{
    if (m_encoder != nullptr)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    if (encoder != nullptr) {
        m_rod->setPlace(encoder->place().shown());
        connect(encoder, &EncoderSession::latestChanged, this, &RodDial::draw);
        connect(encoder, &EncoderSession::freshnessChanged, this, &RodDial::draw);
        showTellRow();
    }
    m_missing->setEncoder(encoder);
}

std::optional<PrintedView> RodDial::printedView() const
{
    if (m_encoder == nullptr)
        return {};
    RodState state = m_rod->state();
    state.note.clear(); // stands among the values
    RodView onPaper;
    onPaper.setState(state);
    return printedDial(*m_encoder, drawnOnPaper(onPaper, {widthOnPaper, onPaper.sizeHint().height()}),
                       m_rod->values(), rodValues);
}

// The field belongs to the device: its range is that of the description.
void RodDial::showTellRow()
{
    delete std::exchange(m_lengthField, nullptr);
    qDeleteAll(m_tellRow->findChildren<QLabel *>());
    const ParameterDescription *length = m_encoder->device().find(Parameter::rodLength);
    if (length == nullptr)
        return;
    auto *name = new QLabel(tr("Rod &length, from its label:"), m_tellRow);
    name->setWordWrap(true);
    m_lengthField = new ValueField(*length, tr("unknown"), m_tellRow);
    name->setBuddy(m_lengthField->focusProxy());
    auto *row = static_cast<QGridLayout *>(m_tellRow->layout());
    row->addWidget(name, 0, 0, 1, 3);
    row->addWidget(m_lengthField, 1, 0);
    row->addWidget(new QLabel(unitText(length->unit), m_tellRow), 1, 1);
    row->addWidget(m_tell, 1, 2);
    setTabOrder(m_lengthField->focusProxy(), m_tell);
    connect(m_lengthField, &ValueField::entered, this, &RodDial::tellLength);
}

void RodDial::tellLength()
{
    const auto length = m_lengthField->value();
    if (length && *length && m_encoder != nullptr)
        m_encoder->tell(Parameter::rodLength, *length);
}

void RodDial::knownChanged()
{
    m_known = knownOfRod(*m_encoder);
    m_tellRow->setVisible(m_lengthField != nullptr && !m_encoder->known(Parameter::rodLength));
    draw();
}

void RodDial::draw()
{
    if (m_encoder == nullptr)
        return;
    const Reading &reading = m_encoder->latest();
    m_readStatus->setVisible(reading.state == EncoderState::error && m_encoder->can().reads);
    m_age->follow(*m_encoder);
    m_rod->setState(rodReading(*m_encoder, m_known, m_missing->names()));
}

} // namespace codewheel
