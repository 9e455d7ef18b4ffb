// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

#include <QPointer>
#include <QWidget>

#include <span>
#include <vector>

class QPushButton;

namespace codewheel {

class ContentScrollArea;
class InlineMessage;
class KnownBeforeBar;

// Those that this encoder has, and of which the value is not known; and their names: "Steps, Direction".
std::vector<Parameter> missingOf(const EncoderSession &encoder, std::span<const Parameter> needed);
QString namesOf(const std::vector<Parameter> &parameters);

// Below a dial: what it needs to know of its encoder but does not, and a button that reads it where it can be
// read.
class MissingValues : public QWidget
{
    Q_OBJECT

public:
    explicit MissingValues(std::vector<Parameter> needed, QWidget *parent = nullptr);

    void setEncoder(EncoderSession *encoder);
    bool isEmpty() const { return m_missing.empty(); }
    QString names() const { return namesOf(m_missing); }
    // Reads these now; a refusal is shown here.
    void read(const std::vector<Parameter> &parameters);

Q_SIGNALS:
    void changed(); // a value has become known, or has changed

private:
    void find();
    void tellMode();

    std::vector<Parameter> m_needed;
    std::vector<Parameter> m_missing; // as far as this kind of encoder has them
    QPointer<EncoderSession> m_encoder;
    QPushButton *m_read;
    InlineMessage *m_message;
    QWidget *m_question;
    KnownBeforeBar *m_before;
    ContentScrollArea *m_questionArea;
    bool m_isReading = false; // by its own job
};

} // namespace codewheel
