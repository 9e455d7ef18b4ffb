// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/rod_dial.h"

#include "catalog/value_text.h"
#include "widgets/dial/missing_values.h"
#include "widgets/dial/printed_dial.h"
#include "widgets/dial/rod_view.h"
#include "widgets/dial/state_note.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/models/age_text.h"
#include "widgets/models/age_timer.h"
#include "widgets/parameters/value_field.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <array>

namespace codewheel {

namespace {

constexpr std::array rodValues{Parameter::direction, Parameter::measuringLength};
constexpr int widthOnPaper = 2 * RodPicture::usualWidth;

std::optional<std::int64_t> valueKnown(const EncoderSession &encoder, Parameter parameter)
{
    const auto known = encoder.known(parameter);
    return known ? std::optional(known->value) : std::nullopt;
}

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
    m_known = {};
    m_known.length = valueKnown(*m_encoder, Parameter::measuringLength);
    m_known.scale = rodScale(*m_encoder);
    const ParameterDescription *direction = m_encoder->device().find(Parameter::direction);
    if (const auto value = valueKnown(*m_encoder, Parameter::direction); value && direction != nullptr)
        if (const Choice *choice = direction->findChoice(*value))
            m_known.countsUpToTheEnd = choice->key == QStringLiteral("increasing");
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
    RodState state = stateOf(reading);
    if (m_encoder->freshness().isOfRecording() || m_encoder->freshness().isOld())
        makeOld(state);
    m_rod->setState(state);
}

void RodDial::makeOld(RodState &state) const
{
    const bool isRecorded = m_encoder->freshness().isOfRecording();
    const StateNote note =
        isRecorded ? noteOfRecording(*m_encoder, {state.note, state.role}) : noteOfAge(*m_encoder);
    if (!isRecorded)
        state.stepsPerSecond.reset();
    state.isLastKnown = true;
    state.age = ageText(*m_encoder);
    state.note = note.sentence;
    state.role = note.role;
}

RodState RodDial::stateOf(const Reading &reading) const
{
    RodState state = m_known;
    state.position = reading.position;
    if (reading.state == EncoderState::operation) {
        state.stepsPerSecond = reading.stepsPerSecond;
        state.note = noteOfKnown();
        state.role = state.note.isEmpty() ? Role::running : Role::attention;
        if (state.note.isEmpty() && !magnetPlace(state))
            state.note = tr("The position was set by a preset: where the magnet is on the rod is not known.");
        return state;
    }
    const StateNote note = noteOfState(m_encoder->device(), reading);
    state.isLastKnown = true;
    state.note = note.sentence;
    state.role = note.role;
    return state;
}

QString RodDial::noteOfKnown() const
{
    if (!m_missing->isEmpty())
        return tr("Not known: %1.").arg(m_missing->names());
    return m_known.scale ? QString() : tr("mm unknown: set the rod length from its label.");
}

} // namespace codewheel
