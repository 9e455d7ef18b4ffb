// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/value_input.h"

#include "catalog/value_text.h"
#include "jobs/job_check.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/rod_scale.h"
#include "widgets/input/decimal_text.h"
#include "widgets/look/fonts.h"
#include "widgets/parameters/parameter_words.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QLocale>
#include <QValidator>

#include <algorithm>

namespace codewheel {

namespace {

struct ValueInputText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ValueInput)
};

constexpr double largestInput = 1e12; // beyond any range
constexpr int typedDigits = 12;

int hexDigitsOf(const ParameterDescription &parameter)
{
    return parameter.form != nullptr ? parameter.form->typedHexDigits : 0;
}

// "12" may be meant as 12h or as 0Ch.
bool isOfBothKinds(const ParameterDescription &parameter, const QString &text)
{
    constexpr int hexadecimal = 16;
    const QString plain = text.trimmed();
    const auto isInRange = [&](std::int64_t value) {
        return value >= parameter.minimum && value <= parameter.maximum;
    };
    const unsigned asDecimal = plain.toUInt();
    const unsigned asHexadecimal = plain.toUInt(nullptr, hexadecimal);
    return plain.size() > 1 && plain.size() <= hexDigitsOf(parameter) && asDecimal != asHexadecimal &&
           std::ranges::all_of(plain, [](QChar c) { return c.isDigit(); }) &&
           (isInRange(asDecimal) || isInRange(asHexadecimal));
}

// As it is typed: mm for a length sent in micrometres, the bits of a scaling factor, otherwise a whole
// number.
QString inputText(const ParameterDescription &parameter, std::int64_t value)
{
    if (const int digits = hexDigitsOf(parameter); digits > 0)
        return hexWord(static_cast<Word>(value)).right(digits) + u'h';
    if (parameter.unit != Unit::micrometres)
        return QString::number(value);
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(millimetresOf(value), 'g', typedDigits);
}

tl::expected<std::int64_t, QString> inputNumber(const ParameterDescription &parameter, const QString &text)
{
    if (isOfBothKinds(parameter, text)) {
        const int digits = hexDigitsOf(parameter);
        const QString plain = text.trimmed();
        const Word asDecimal = plain.toUInt();
        return tl::unexpected(ValueInputText::tr("\"%1\" can be hexadecimal or decimal. Write %2 or %3.")
                                  .arg(plain, plain.rightJustified(digits, u'0') + u'h',
                                       hexWord(asDecimal).right(digits) + u'h'));
    }
    if (parameter.unit != Unit::micrometres)
        return readWhole(text);
    const auto millimetres = readDecimal(text, QLocale());
    if (!millimetres)
        return tl::unexpected(millimetres.error());
    return micrometresOf(std::clamp(*millimetres, -largestInput, largestInput));
}

// Anything can be typed, so that what is wrong can be explained; only what is good is taken.
class RangeCheck final : public QValidator
{
public:
    explicit RangeCheck(ValueInput &input)
        : QValidator(&input)
        , m_input(input)
    {}

    State validate(QString &, int &) const override { return m_input.value() ? Acceptable : Intermediate; }

private:
    const ValueInput &m_input;
};

} // namespace

ValueInput::ValueInput(ParameterDescription parameter, QWidget *parent)
    : QLineEdit(parent)
    , m_parameter(std::move(parameter))
    , m_mark(*this)
{
    setFont(numberFont());
    setAlignment(m_parameter.isText() ? Qt::AlignLeft : Qt::AlignRight);
    setToolTip(parameter_words::rangeAndFactory(m_parameter));
    setValidator(new RangeCheck(*this));
    connect(this, &QLineEdit::textChanged, this, &ValueInput::check);
}

void ValueInput::setValue(const std::optional<Value> &value)
{
    if (value && value->isText())
        setText(value->toString());
    else
        setText(value ? inputText(m_parameter, value->number()) : QString());
}

Result<std::optional<Value>> ValueInput::value() const
{
    if (text().trimmed().isEmpty())
        return std::optional<Value>();
    if (m_parameter.isText())
        return checkText(m_parameter, Value(text())).map([this] { return std::optional<Value>(text()); });
    const auto number = inputNumber(m_parameter, text());
    const auto argument = [this](std::int64_t value) {
        return m_parameter.unit == Unit::micrometres
                   ? RefusalArgument(QStringLiteral("%1 %2").arg(valueText(m_parameter, value),
                                                                 unitText(m_parameter.unit)))
                   : RefusalArgument(value);
    };
    if (!number)
        return refuse(RefusalKind::badInput, RefusalId::inputNotUnderstood,
                      {m_parameter.parameter, number.error(), argument(m_parameter.minimum),
                       argument(m_parameter.maximum)});
    if (*number >= m_parameter.minimum && *number <= m_parameter.maximum)
        return std::optional<Value>(*number);
    return refuse(RefusalKind::badInput, RefusalId::valueOutOfRange,
                  {m_parameter.parameter, argument(*number), argument(m_parameter.minimum),
                   argument(m_parameter.maximum)});
}

QSize ValueInput::minimumSizeHint() const
{
    const QSize least = QLineEdit::minimumSizeHint();
    return {least.width() + fontMetrics().horizontalAdvance(placeholderText()), least.height()};
}

void ValueInput::check()
{
    const auto checked = value();
    const QString wrong = checked ? QString() : refusalText(checked.error());
    m_mark.show(wrong);
    Q_EMIT inputChecked(wrong);
}

QWidget *makeValueInput(const ParameterDescription &parameter, const QString &ifEmpty, QWidget *parent)
{
    QWidget *input = nullptr;
    if (parameter.choices.empty()) {
        auto *number = new ValueInput(parameter, parent);
        number->setPlaceholderText(ifEmpty);
        input = number;
    } else {
        auto *choices = new QComboBox(parent);
        choices->addItem(ifEmpty);
        for (const Choice &choice : parameter.choices)
            choices->addItem(valueText(parameter, choice.value), qlonglong{choice.value});
        choices->setToolTip(parameter_words::rangeAndFactory(parameter));
        input = choices;
    }
    input->setAccessibleName(parameterName(parameter));
    return input;
}

void setInputValue(QWidget &input, const std::optional<Value> &value)
{
    if (auto *number = qobject_cast<ValueInput *>(&input))
        number->setValue(value);
    else if (auto *choices = qobject_cast<QComboBox *>(&input))
        choices->setCurrentIndex(value ? std::max(choices->findData(qlonglong{value->number()}), 0) : 0);
}

QVariant variantOf(const std::optional<Value> &value)
{
    if (!value)
        return {};
    return value->isText() ? QVariant(value->toString()) : QVariant(qlonglong{value->number()});
}

std::optional<Value> valueFromVariant(const QVariant &variant)
{
    if (!variant.isValid())
        return std::nullopt;
    return variant.typeId() == QMetaType::QString ? Value(variant.toString()) : Value(variant.toLongLong());
}

Result<std::optional<Value>> inputValue(const QWidget &input)
{
    if (const auto *number = qobject_cast<const ValueInput *>(&input))
        return number->value();
    const QVariant chosen = static_cast<const QComboBox &>(input).currentData();
    return chosen.isValid() ? std::optional<Value>(chosen.toLongLong()) : std::nullopt;
}

} // namespace codewheel
