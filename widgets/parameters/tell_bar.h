// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/refusal.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace codewheel {

// "The encoder has: Steps [    ] [Tell] [Cancel]": the user says what the encoder has, from its papers or its
// label. Empty takes back what was told. Hidden until asked for.
class TellBar : public QWidget
{
    Q_OBJECT

public:
    explicit TellBar(QWidget *parent = nullptr);

    void ask(const ParameterDescription &parameter, std::optional<std::int64_t> known);

Q_SIGNALS:
    void told(codewheel::Parameter parameter, std::optional<std::int64_t> value);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void tell();

    Parameter m_parameter = Parameter::steps;
    QLabel *m_name;
    QWidget *m_input = nullptr;
    QPushButton *m_tell;
    QPushButton *m_cancel;
    QLabel *m_wrong;
};

} // namespace codewheel
