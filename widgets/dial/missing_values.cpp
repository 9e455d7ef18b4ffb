// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/missing_values.h"

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/refusal_text.h"
#include "widgets/job/known_before_bar.h"
#include "widgets/look/content_scroll_area.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace codewheel {

std::vector<Parameter> missingOf(const EncoderSession &encoder, std::span<const Parameter> needed)
{
    std::vector<Parameter> missing;
    for (const Parameter parameter : needed)
        if (encoder.device().find(parameter) != nullptr && !encoder.known(parameter))
            missing.push_back(parameter);
    return missing;
}

QString namesOf(const std::vector<Parameter> &parameters)
{
    QStringList names;
    for (const Parameter parameter : parameters)
        names.append(parameterName(parameter));
    return names.join(QStringLiteral(", "));
}

MissingValues::MissingValues(std::vector<Parameter> needed, QWidget *parent)
    : QWidget(parent)
    , m_needed(std::move(needed))
    , m_read(new QPushButton(lineIcon(Icon::read), tr("&Read what is missing"), this))
    , m_message(new InlineMessage(this))
    , m_question(new QWidget(this))
    , m_before(new KnownBeforeBar(m_question))
    , m_questionArea(new ContentScrollArea(m_question, this))
{
    layOutColumn(m_question, {m_before}, {.margins = QMargins()});
    m_questionArea->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    m_questionArea->setMinimumHeight(1); // in a low panel: it stands in that of the parameters, too
    m_questionArea->hide();
    onEventOf(m_before, {QEvent::ShowToParent}, this, [this] { m_questionArea->show(); });
    onEventOf(m_before, {QEvent::HideToParent}, this, [this] { m_questionArea->hide(); });
    auto *layout = layOut<QVBoxLayout>(this, grid::unit);
    layout->addWidget(m_message);
    layout->addWidget(m_questionArea);
    layout->addWidget(m_read, 0, Qt::AlignHCenter);
    describe(m_read, "readMissing", tr("Read what the dial needs"),
             tr("Reads what the dial needs from the encoder. That sends words, and hides the position for "
                "some cycles."));
    m_read->hide();
    connect(m_read, &QPushButton::clicked, this, [this] { read(m_missing); });
    connect(m_message, &InlineMessage::actionTriggered, this, [this] {
        m_message->withdraw();
        tellPositionMode(*m_encoder);
    });
}

void MissingValues::setEncoder(EncoderSession *encoder)
{
    if (m_encoder != nullptr)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    m_message->withdraw();
    m_before->setEncoder(encoder);
    m_isReading = false;
    if (encoder == nullptr)
        return;
    connect(encoder, &EncoderSession::knownChanged, this, &MissingValues::find);
    connect(encoder, &EncoderSession::jobStarted, this, [this] { m_read->setEnabled(false); });
    connect(encoder, &EncoderSession::finished, this, [this](const Outcome &outcome) {
        m_read->setEnabled(true);
        if (outcome.result)
            m_message->withdraw();
        if (std::exchange(m_isReading, false) && outcome.result)
            tellMode();
    });
    connect(encoder, &EncoderSession::permissionChanged, m_message, &InlineMessage::withdraw);
    m_read->setEnabled(!encoder->runningJob());
    find();
}

void MissingValues::find()
{
    m_missing = missingOf(*m_encoder, m_needed);
    m_read->setVisible(!m_missing.empty() && m_encoder->can().reads);
    Q_EMIT changed();
}

void MissingValues::read(const std::vector<Parameter> &parameters)
{
    if (m_encoder == nullptr)
        return;
    const auto started = m_encoder->start(ReadParameters{parameters});
    m_isReading = started.has_value();
    if (!started)
        m_message->showMessage(Role::attention, refusalText(started.error()));
}

// What no reading tells.
void MissingValues::tellMode()
{
    if (m_encoder->device().mayHaveModes() && !m_encoder->latest().mode)
        m_message->showMessage(
            Role::attention,
            tr("Its mode cannot be read: position, velocity or cam. It is known once you say it, "
               "or switch it from here."),
            tr("It is in &position mode"));
}

} // namespace codewheel
