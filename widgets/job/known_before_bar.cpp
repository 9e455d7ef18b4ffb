// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/known_before_bar.h"

#include "vocabulary/encoder_session.h"
#include "vocabulary/sentence.h"
#include "widgets/job/known_text.h"
#include "widgets/look/describe.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

constexpr std::size_t mostNamed = 2; // the others are in the tooltip

ParameterValues valuesOf(const KnownBefore &before)
{
    ParameterValues values;
    for (const KnownBefore::Entry &value : before.values)
        values.push_back({value.parameter, value.value});
    return values;
}

QString shortList(const DeviceDescription &device, ParameterValues values)
{
    const bool isLong = values.size() > mostNamed;
    values.resize(std::min(values.size(), mostNamed));
    return valueList(device, values) + (isLong ? QStringLiteral(", …") : QString());
}

QDateTime newestOf(const KnownBefore &before)
{
    return std::ranges::max_element(before.values, {}, &KnownBefore::Entry::at)->at;
}

} // namespace

KnownBeforeBar::KnownBeforeBar(QWidget *parent)
    : InlineMessage(parent)
{
    named(this, "knownBefore");
    connect(this, &InlineMessage::actionTriggered, this, [this] {
        if (m_encoder != nullptr)
            m_encoder->takeKnownBefore();
    });
    connect(this, &InlineMessage::otherActionTriggered, this, [this] {
        if (m_encoder != nullptr)
            m_encoder->setKnownBefore({});
    });
}

void KnownBeforeBar::setEncoder(EncoderSession *encoder)
{
    if (m_encoder != nullptr)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    if (encoder != nullptr)
        connect(encoder, &EncoderSession::knownBeforeChanged, this, &KnownBeforeBar::ask);
    ask();
}

void KnownBeforeBar::ask()
{
    if (m_encoder == nullptr || !m_encoder->knownBefore()) {
        withdraw();
        return;
    }
    const KnownBefore &before = *m_encoder->knownBefore();
    setToolTip(valueList(m_encoder->device(), valuesOf(before)));
    showMessage(Role::attention,
                codewheel::sentence(
                    tr("Is it the same encoder? Before it was connected anew this was known: %1 (%2)."),
                    {shortList(m_encoder->device(), valuesOf(before)),
                     QLocale().toString(newestOf(before).toLocalTime(), QLocale::ShortFormat)}),
                tr("The sa&me"), tr("An&other one"));
}

} // namespace codewheel
