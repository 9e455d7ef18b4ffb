// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

#include <QWidget>

#include <functional>
#include <optional>

class QLabel;
class QPushButton;

namespace codewheel {

// "Steps: the encoder has [    ] [Tell] [Cancel]": asks for one value, which the panel then uses. Hidden
// until asked for.
class ValueBar : public QWidget
{
    Q_OBJECT

public:
    struct Question
    {
        ParameterDescription parameter;
        QString label;
        QString ifEmpty; // shown in the empty field
        QString button;
        QString toolTip;
        bool mayBeEmpty = false;
        std::function<void(const std::optional<Value> &)> answered;
    };

    explicit ValueBar(QWidget *parent = nullptr);

    void ask(Question question, const std::optional<Value> &value);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void answer();
    void checkInput();

    Question m_question;
    QLabel *m_name;
    QWidget *m_input = nullptr;
    QPushButton *m_take;
    QPushButton *m_cancel;
    QLabel *m_wrong;
};

} // namespace codewheel
