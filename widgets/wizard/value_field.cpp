// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/value_field.h"

#include "catalog/value_text.h"
#include "encoder/hex.h"
#include "widgets/look/fonts.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QLocale>

namespace codewheel {

ValueField::ValueField(const ParameterDescription &parameter, const QString &ifEmpty, QWidget *parent)
    : QWidget(parent)
    , m_parameter(parameter)
{
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    QWidget *field = nullptr;
    if (parameter.choices.empty()) {
        m_number = new QLineEdit(this);
        m_number->setFont(numberFont());
        m_number->setAlignment(Qt::AlignRight);
        m_number->setPlaceholderText(ifEmpty);
        m_number->setToolTip(tr("%1 to %2; decimal, or hexadecimal as 0x.. or ..h. Empty: %3.")
                                 .arg(QLocale().toString(qlonglong{parameter.minimum}),
                                      QLocale().toString(qlonglong{parameter.maximum}), ifEmpty));
        connect(m_number, &QLineEdit::textChanged, this, &ValueField::edited);
        field = m_number;
    } else {
        m_choice = new QComboBox(this);
        m_choice->addItem(ifEmpty);
        for (const Choice &choice : parameter.choices)
            m_choice->addItem(valueText(parameter, choice.value), qlonglong{choice.value});
        m_choice->setToolTip(parameterName(parameter.parameter));
        connect(m_choice, &QComboBox::currentIndexChanged, this, &ValueField::edited);
        field = m_choice;
    }
    field->setAccessibleName(parameterName(parameter.parameter));
    field->setObjectName(parameterKey(parameter.parameter));
    layout->addWidget(field);
    setFocusProxy(field);
}

void ValueField::setValue(std::optional<std::int64_t> value)
{
    const QSignalBlocker quiet(this);
    if (m_number) {
        m_number->setText(value ? QString::number(*value) : QString());
        return;
    }
    const int row = value ? m_choice->findData(qlonglong{*value}) : 0;
    m_choice->setCurrentIndex(std::max(row, 0));
}

Result<std::optional<std::int64_t>> ValueField::value() const
{
    if (m_choice) {
        const QVariant chosen = m_choice->currentData();
        return chosen.isValid() ? std::optional<std::int64_t>(chosen.toLongLong()) : std::nullopt;
    }
    if (m_number->text().trimmed().isEmpty())
        return std::optional<std::int64_t>();
    const auto number = parseNumber(m_number->text());
    if (!number || *number < m_parameter.minimum || *number > m_parameter.maximum) {
        const RefusalArgument given = number ? RefusalArgument(*number) : RefusalArgument(m_number->text());
        return refuse(RefusalKind::badInput, RefusalId::valueOutOfRange,
                      {m_parameter.parameter, given, m_parameter.minimum, m_parameter.maximum});
    }
    return std::optional(*number);
}

} // namespace codewheel
