// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/number_fields.h"

#include "widgets/input/decimal_text.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>

#include <type_traits>

namespace codewheel {
namespace {

struct SpinFieldTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::SpinField)
};

} // namespace

template <typename SpinBox>
SpinField<SpinBox>::SpinField(QWidget *parent)
    : SpinBox(parent)
    , m_mark(*this->lineEdit())
{
    this->setKeyboardTracking(false);
    QObject::connect(this->lineEdit(), &QLineEdit::textChanged, this, [this] { check(); });
    QObject::connect(this, &SpinBox::valueChanged, this, [this] { check(); }); // may be set by code
}

// Without the field's own prefix and suffix.
template <typename SpinBox>
QString SpinField<SpinBox>::bareText(QString text) const
{
    if (!this->specialValueText().isEmpty() && text == this->specialValueText())
        return this->textFromValue(this->minimum());
    if (text.startsWith(this->prefix()))
        text.remove(0, this->prefix().size());
    if (text.endsWith(this->suffix()))
        text.chop(this->suffix().size());
    return text.trimmed();
}

template <typename SpinBox>
auto SpinField<SpinBox>::read(const QString &bare) const -> tl::expected<Number, QString>
{
    const auto number = [&] {
        if constexpr (std::is_integral_v<Number>)
            return readWhole(bare);
        else
            return readDecimal(bare, this->locale());
    }();
    if (!number)
        return tl::unexpected(number.error());
    const auto end = [this](Number its) {
        if constexpr (std::is_integral_v<Number>)
            return this->locale().toString(its);
        else
            return this->locale().toString(its, 'f', this->decimals());
    };
    if (*number < this->minimum() || *number > this->maximum())
        return tl::unexpected(SpinFieldTexts::tr("%1 is outside %2 to %3.")
                                  .arg(bare, end(this->minimum()), end(this->maximum())));
    return static_cast<Number>(*number);
}

template <typename SpinBox>
QString SpinField<SpinBox>::complaint() const
{
    const QString bare = bareText(this->lineEdit()->text());
    const auto number = read(bare);
    return number || bare.isEmpty() ? QString() : number.error();
}

template <typename SpinBox>
QString SpinField<SpinBox>::takeTyped()
{
    QString wrong = complaint();
    if (wrong.isEmpty())
        this->interpretText();
    return wrong;
}

template <typename SpinBox>
QValidator::State SpinField<SpinBox>::validate(QString &text, int &) const
{
    return read(bareText(text)) ? QValidator::Acceptable : QValidator::Intermediate;
}

template <typename SpinBox>
auto SpinField<SpinBox>::valueFromText(const QString &text) const -> Number
{
    return read(bareText(text)).value_or(this->value());
}

// The field handles Esc if something was typed, and Return if it is good; otherwise its surroundings do.
template <typename SpinBox>
void SpinField<SpinBox>::keyPressEvent(QKeyEvent *event)
{
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enters && !complaint().isEmpty()) {
        check();
        return;
    }
    const QString before = this->prefix() + this->textFromValue(this->value()) + this->suffix();
    if (event->key() == Qt::Key_Escape && bareText(this->lineEdit()->text()) != bareText(before)) {
        this->lineEdit()->setText(before);
        this->selectAll();
        return;
    }
    SpinBox::keyPressEvent(event);
}

template <typename SpinBox>
void SpinField<SpinBox>::focusOutEvent(QFocusEvent *event)
{
    keepingRefused([&] { SpinBox::focusOutEvent(event); });
}

template <typename SpinBox>
void SpinField<SpinBox>::showEvent(QShowEvent *event)
{
    keepingRefused([&] { SpinBox::showEvent(event); });
}

template <typename SpinBox>
void SpinField<SpinBox>::hideEvent(QHideEvent *event)
{
    keepingRefused([&] { SpinBox::hideEvent(event); });
}

// Refused input is not taken. It stays in the field, marked, to be corrected; Qt would silently restore the
// previous value.
template <typename SpinBox>
void SpinField<SpinBox>::keepingRefused(const std::function<void()> &handle)
{
    const bool isRefused = !complaint().isEmpty();
    const QString typed = this->lineEdit()->text();
    handle();
    if (isRefused)
        this->lineEdit()->setText(typed);
}

// Qt replaces the text without its signal.
template <typename SpinBox>
void SpinField<SpinBox>::setValue(Number value)
{
    SpinBox::setValue(value);
    check();
}

template <typename SpinBox>
void SpinField<SpinBox>::check()
{
    const QString wrong = complaint();
    m_mark.show(wrong);
    m_mark.tellBelow(*this, wrong);
    checked(wrong);
}

template class SpinField<QDoubleSpinBox>;
template class SpinField<QSpinBox>;

void leaveSeparatorsOut(QSpinBox &field)
{
    QLocale plain = field.locale();
    plain.setNumberOptions(plain.numberOptions() | QLocale::OmitGroupSeparator);
    field.setLocale(plain);
}

} // namespace codewheel
