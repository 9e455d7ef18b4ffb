// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/inline_message.h"

#include <QPointer>

namespace codewheel {

class EncoderSession;

// Asks whether the encoder is the one that was there before, with what was known of it then. Hidden where
// that is no question.
class KnownBeforeBar : public InlineMessage
{
    Q_OBJECT

public:
    explicit KnownBeforeBar(QWidget *parent = nullptr);

    void setEncoder(EncoderSession *encoder);

private:
    void ask();

    QPointer<EncoderSession> m_encoder;
};

} // namespace codewheel
